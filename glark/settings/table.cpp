// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/table.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "glark/settings/names/nearest_name.h"

namespace glark::settings {
namespace {

static_assert(core::max_supported_level == 11, "the texts below name the limit");

constexpr std::string_view smooth_word = "smooth";

template <class T, class U>
bool assign(std::optional<T> value, U& setting) {
  if (!value) return false;
  setting = *std::move(value);
  return true;
}

std::optional<std::string> parse_file(std::string_view text) {
  return text.empty() || text.find('\0') != std::string_view::npos ? std::nullopt : std::optional(std::string(text));
}

bool read_refinement(Settings& s, std::string_view text) {
  const bool smooth = text == smooth_word;
  const bool valid = assign(smooth ? core::Refinement::pn : parse_refinement(text), s.context.refinement);
  if (valid) s.context.smooth = smooth;
  return valid;
}

bool read_no_weld(Settings& s, std::string_view text) {
  bool off = false;
  const bool valid = assign(parse_switch(text), off);
  if (valid) s.context.weld = !off;
  return valid;
}

constexpr char level_needed[] = "an integer from 0 to 11";
constexpr char switch_needed[] = "0 or 1";
constexpr char file_needed[] = "the name of a file";
constexpr char key_needed[] = "F1 to F12, Pause, Insert, ScrollLock, Home, PageUp, PageDown, End, Menu, or none,";
constexpr char attribute_needed[] = "the name of a vertex attribute or its location";

constexpr char depth[] = "How fine";
constexpr char shape[] = "Which shape";
constexpr char cost[] = "Cost";
constexpr char draws[] = "Which draws stay unrefined";
constexpr char attributes[] = "Vertex attributes";
constexpr char output[] = "Pictures, statistics and messages";
constexpr char live[] = "While the program runs";
constexpr char files[] = "Configuration file";

// The words of all refinements and their descriptions, made at compile time from their rows.
template <std::size_t size>
struct Text {
  std::array<char, size> letters{};
  constexpr std::string_view view() const { return {letters.data(), size}; }
};

enum class RefinementText { words, help, details };

// `smooth` is no refinement of its own: it chooses between pn and none, mesh by mesh.
constexpr std::string_view smooth_help = "curved where all passes over a mesh can be";
constexpr std::string_view smooth_details =
    "smooth curves meshes as pn does, if they have normals and every pass over them can be curved. Everything else "
    "stays "
    "as the program draws it. A mesh is curved from the third frame on that draws it. ";

// Calls `add` with the parts of "a, b or c", or with the sentences.
constexpr void list_refinements(RefinementText wanted, auto&& add) {
  add(wanted == RefinementText::details ? smooth_details : smooth_word);
  if (wanted == RefinementText::help) {
    add(" (");
    add(smooth_help);
    add(")");
  }
  for (std::size_t i = 0; i < core::refinements.size(); ++i) {
    if (wanted == RefinementText::details) {
      add(core::refinements[i].details);
      continue;
    }
    add(i + 1 < core::refinements.size() ? ", " : " or ");
    add(core::refinements[i].word);
    if (wanted == RefinementText::words) continue;
    add(" (");
    add(core::refinements[i].help);
    add(")");
  }
}

template <RefinementText wanted>
constexpr auto refinements_text() {
  constexpr std::size_t size = [] {
    std::size_t letters = 0;
    list_refinements(wanted, [&](std::string_view part) { letters += part.size(); });
    return letters;
  }();
  Text<size> text;
  list_refinements(wanted, [&, end = std::size_t{0}](std::string_view part) mutable {
    for (const char letter : part) text.letters[end++] = letter;
  });
  return text;
}
constexpr auto refinement_words = refinements_text<RefinementText::words>();
constexpr auto refinement_help = refinements_text<RefinementText::help>();
constexpr auto refinement_details = refinements_text<RefinementText::details>();

template <std::size_t refinement>
bool read_shape_number(Settings& s, std::string_view text) {
  return assign(parse_shape_number(core::refinements[refinement].number, text), s.context.shape_numbers[refinement]);
}

constexpr std::size_t shape_number_count = [] {
  std::size_t count = 0;
  for (const core::RefinementTraits& row : core::refinements) count += row.number.exists() ? 1 : 0;
  return count;
}();

// Makes a row for each refinement that has a number.
template <std::size_t... refinement>
constexpr auto settings_of_shape_numbers(std::index_sequence<refinement...> /*all*/) {
  std::array<Setting, shape_number_count> rows{};
  std::size_t next = 0;
  const auto add = [&](const core::ShapeNumber& number, bool (*read)(Settings&, std::string_view)) {
    if (number.exists())
      rows[next++] = {shape,
                      number.key,
                      number.variable,
                      Kind::value,
                      number.placeholder,
                      number.needed,
                      number.initial_text,
                      "",
                      number.help,
                      "",
                      read};
  };
  (add(core::refinements[refinement].number, read_shape_number<refinement>), ...);
  return rows;
}

// Columns: group, key, variable, kind, value, limits, default, default in words, help, details, reader.
// clang-format off
constexpr std::array first_settings{
    Setting{depth, "level", "GLARK_LEVEL", Kind::value, "N", level_needed, "2", "",
            "Replace every triangle by 4^N triangles", "",
            [](Settings& s, std::string_view text) { return assign(parse_level(text), s.context.level); }},
    Setting{depth, "max-level", "GLARK_MAX_LEVEL", Kind::value, "N", level_needed, "6", "",
            "Prepare patterns up to level N", "A higher --level raises this limit unless the limit was set too.",
            [](Settings& s, std::string_view text) { return assign(parse_level(text), s.context.max_level); }},
    Setting{depth, "edge-pixels", "GLARK_EDGE_PIXELS", Kind::value, "P", "a number from 0.5 to 10000, or 0 for none,", "0", "off",
            "Refine each edge by its length on the screen, into segments of at most P pixels", "Replaces --level.",
            [](Settings& s, std::string_view text) { return assign(parse_edge_pixels(text), s.context.measure.pixels); }},
    Setting{depth, "curvature", "GLARK_CURVATURE", Kind::value, "DEGREES", "degrees from 0.5 to 180, or 0 for none,", "0", "off",
            "Refine each edge by the angle between the normals at its ends, into segments that turn by at most DEGREES",
            "Replaces --level. With --edge-pixels too, an edge gets the lesser of both depths.",
            [](Settings& s, std::string_view text) { return assign(parse_curvature(text), s.context.measure.degrees); }},
    Setting{depth, "screen-error", "GLARK_SCREEN_ERROR", Kind::value, "P", "a number from 0.01 to 1000, or 0 for none,", "0", "off",
            "Refine each edge until its curve leaves its segments by at most P pixels on the screen",
            "Replaces --level. Straight edges stay as they are, and so do edges that nobody sees. With --edge-pixels or --curvature "
            "too, an edge gets the least depth.",
            [](Settings& s, std::string_view text) { return assign(parse_screen_error(text), s.context.measure.error); }},
    Setting{depth, "budget", "GLARK_BUDGET", Kind::value, "N", "a number of triangles up to 1000000000, or 0 for none,", "0", "none",
            "Coarsen --edge-pixels, --curvature and --screen-error when a frame has more than N refined triangles",
            "With a --refine that curves triangles, the budget goes to what curves: flat triangles, backgrounds, and passes "
            "without colours do not count.",
            [](Settings& s, std::string_view text) { return assign(parse_budget(text), s.context.measure.budget); }},
    Setting{depth, "geomorph", "GLARK_GEOMORPH", Kind::toggle, "", switch_needed, "0", "off",
            "Move vertices smoothly between the levels of --edge-pixels, --curvature and --screen-error, so that no vertex pops up",
            "With a --budget, depths change slowly, so that some frames may exceed the budget.",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.geomorph); }},

    Setting{shape, "refine", "GLARK_REFINE", Kind::value, "KIND", refinement_words.view(), smooth_word, "",
            refinement_help.view(), refinement_details.view(), read_refinement},
    Setting{shape, "crease", "GLARK_CREASE", Kind::value, "DEGREES", "degrees from 0 to 180", "80", "",
            "Keep edges straight whose faces share their normals but meet at more than DEGREES",
            "Curved triangles then stay within half of their least height. 180 curves every edge as its normals say.",
            [](Settings& s, std::string_view text) { return assign(parse_crease(text), s.context.crease); }},
};

constexpr std::array other_settings{
    Setting{shape, "normals", "GLARK_NORMALS", Kind::value, "SOURCE", "given or geometry", "given", "",
            "Curve meshes by the program's normals only (given), or make normals from positions for meshes without any "
            "(geometry)",
            "Faces that meet at more than --crease keep their own normals.",
            [](Settings& s, std::string_view text) { return assign(parse_normals(text), s.context.geometry_normals); }},
    Setting{shape, "no-weld", "GLARK_NO_WELD", Kind::toggle, "", switch_needed, "0", "off",
            "Curve each triangle by its own normals alone; curved ones then crack open where normals differ",
            "Otherwise the edges of a draw are welded by position.", read_no_weld},
    Setting{shape, "polygons", "GLARK_POLYGONS", Kind::value, "SPLIT", "triangles or centroid", "triangles", "",
            "Split quads and polygons into triangles as OpenGL does (triangles), or into a fan about their centre (centroid)", "",
            [](Settings& s, std::string_view text) { return assign(parse_polygons(text), s.context.centroids); }},
    Setting{shape, "wireframe", "GLARK_WIREFRAME", Kind::toggle, "", switch_needed, "0", "off",
            "Draw the refined triangles as lines (not in OpenGL ES)", "",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.wireframe); }},

    Setting{cost, "keep-refined", "GLARK_KEEP_REFINED", Kind::value, "MB", "megabytes from 0 to 65536", "256", "",
            "Keep up to MB megabytes of refined vertices in each context; 0: none",
            "Draws that do not change are then refined once, and drawn like static meshes.",
            [](Settings& s, std::string_view text) { return assign(parse_megabytes(text), s.context.kept_vertex_bytes); }},

    Setting{cost, "wait", "GLARK_WAIT", Kind::toggle, "", switch_needed, "0", "off",
            "Compile everything that a draw needs before it is drawn",
            "Otherwise a frame compiles a few shader programs, and draws that need more stay unrefined until then. Programs "
            "that call the extension wait in any case, and so do runs with --capture.",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.wait); }},

    Setting{draws, "leave-draws", "GLARK_LEAVE_DRAWS", Kind::value, "RULES",
            "a list of screen-quads, overlays, orthographic, blended, no-depth-test, no-depth-writes, or none",
            "screen-quads,overlays,orthographic", "",
            "Leave the draws unrefined that match one of these rules, separated by commas; none: refine them too",
            "The rules are screen-quads, overlays, orthographic, blended, no-depth-test and no-depth-writes.",
            [](Settings& s, std::string_view text) { return assign(parse_left_draws(text), s.context.left_draws); }},
    Setting{draws, "leave-shaders", "GLARK_LEAVE_SHADERS", Kind::value, "HASHES", "a list of hashes of 16 hexadecimal digits", "", "none",
            "Leave these shader programs unrefined, named by their hashes, separated by commas",
            "--stats, --dump-shaders and --log info show the hashes.",
            [](Settings& s, std::string_view text) { return assign(parse_hashes(text), s.context.left_shaders); }},
    Setting{draws, "leave-alone", "GLARK_LEAVE_ALONE", Kind::toggle, "", switch_needed, "0", "off",
            "Leave every draw of the program unrefined", "",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.leave_alone); }},
    Setting{draws, "everything", "GLARK_EVERYTHING", Kind::toggle, "", switch_needed, "0", "off",
            "Refine every draw, whatever --leave-draws and --leave-shaders say", "",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.everything); }},

    Setting{attributes, "position", "GLARK_POSITION", Kind::value, "ATTRIBUTE", attribute_needed, "", "guessed",
            "The vertex attribute that is the position, by name or location", "",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.position); }},
    Setting{attributes, "normal", "GLARK_NORMAL", Kind::value, "ATTRIBUTE", attribute_needed, "", "guessed",
            "The vertex attribute that is the normal, by name or location", "",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.normal); }},
    Setting{attributes, "texture-coordinate", "GLARK_TEXTURE_COORDINATE", Kind::value, "ATTRIBUTE", attribute_needed, "", "guessed",
            "The vertex attribute that is the texture coordinate, by name or location", "",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.texture_coordinate); }},

    Setting{output, "capture", "GLARK_CAPTURE", Kind::captures, "FRAME:FILE.png", "FRAME:FILE.png, with frames counted from 1,", "", "none",
            "Write frame FRAME, counted from 1, as an image; may be repeated", "The variable takes several, separated by commas.",
            [](Settings& s, std::string_view text) { return assign(parse_captures(text), s.captures); }},
    Setting{output, "record", "GLARK_RECORD", Kind::output_file, "FILE.mp4", file_needed, "", "none",
            "Record the window as a film, by the program ffmpeg",
            "The film has at most 30 frames a second, as they were shown. The ending of the file's name chooses the format. "
            "A program with several windows gets a film of the one that is shown first.",
            [](Settings& s, std::string_view text) { return assign(parse_file(text), s.record_file); }},
    Setting{output, "stats", "GLARK_STATS", Kind::output_file, "FILE.json", file_needed, "", "none",
            "Write statistics: draws by class of state and by what was decided about them, causes, and frames",
            "%p in the name stands for the number of the process. The document reference/formats.md explains the keys.",
            [](Settings& s, std::string_view text) { return assign(parse_file(text), s.statistics_file); }},
    Setting{output, "dump-shaders", "GLARK_DUMP_SHADERS", Kind::output_folder, "DIR", "the name of a folder", "", "none",
            "Write the sources of the program's shaders and of the shaders derived from them",
            "The files of one program share its hash: programN-HASH.original.vert, programN-HASH.pn.vert and so on. "
            "fixed-HASH are the stages that were generated for the fixed function.",
            [](Settings& s, std::string_view text) { return assign(parse_file(text), s.dump_folder); }},
    Setting{output, "log", "GLARK_LOG", Kind::value, "LEVEL", "error, warning, info or debug", "warning", "",
            "Print messages up to this level: error, warning, info or debug", "",
            [](Settings& s, std::string_view text) { return assign(parse_log_level(text), s.log_level); }},

    Setting{live, "overlay", "GLARK_OVERLAY", Kind::toggle, "", switch_needed, "0", "off",
            "Open a panel over the program's frames when --overlay-key is pressed",
            "The panel changes settings, shows what was decided about the draws, and writes the configuration file.",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.overlay); }},
    Setting{live, "overlay-open", "GLARK_OVERLAY_OPEN", Kind::toggle, "", switch_needed, "0", "off",
            "With --overlay, the panel is open from the first frame on", "",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.overlay_open); }},
    Setting{live, "overlay-key", "GLARK_OVERLAY_KEY", Kind::value, "KEY", key_needed, "F10", "",
            "Open and close the panel with this key; with Shift, arrow keys and Space work in it",
            "The program does not get the key. On Wayland it does.",
            [](Settings& s, std::string_view text) { return assign(parse_key(text), s.overlay_key); }},
    Setting{live, "toggle-key", "GLARK_TOGGLE_KEY", Kind::value, "KEY", key_needed, "none", "",
            "Switch refinement off and on with this key, with or without the panel", "",
            [](Settings& s, std::string_view text) { return assign(parse_key(text), s.toggle_key); }},
    Setting{live, "split", "GLARK_SPLIT", Kind::toggle, "", switch_needed, "0", "off",
            "Refine the right half of the window only", "",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.live.split); }},

    // Read before every other setting, so the reader has nothing to do.
    Setting{files, "config", variable::config, Kind::input_file, "FILE", file_needed, "", "glark/glark.toml in the XDG folders",
            "Read this configuration file", "/dev/null for no file at all.",
            [](Settings&, std::string_view) { return true; }, false},
};
// clang-format on

constexpr auto settings_table = [] {
  constexpr auto numbers = settings_of_shape_numbers(std::make_index_sequence<core::refinements.size()>());
  std::array<Setting, first_settings.size() + numbers.size() + other_settings.size()> all{};
  auto* const after_first = std::copy(first_settings.begin(), first_settings.end(), all.begin());
  auto* const after_numbers = std::copy(numbers.begin(), numbers.end(), after_first);
  std::copy(other_settings.begin(), other_settings.end(), after_numbers);
  return all;
}();

}  // namespace

std::span<const Setting> table() { return settings_table; }

const Setting* find_setting(std::string_view key) {
  const auto* const found = std::find_if(settings_table.begin(), settings_table.end(),
                                         [&](const Setting& setting) { return setting.key == key; });
  return found != settings_table.end() ? found : nullptr;
}

std::string_view shown_default(const Setting& setting) {
  return setting.shown.empty() ? setting.initial : setting.shown;
}

std::string_view nearest_key(std::string_view wrong) {
  std::vector<std::string_view> keys;
  for (const Setting& setting : settings_table)
    if (setting.in_file) keys.push_back(setting.key);
  return nearest_name(wrong, keys);
}

bool give(const Setting& setting, Settings& settings, std::string_view text) {
  const bool valid = setting.read(settings, text);
  if (valid) settings.given.insert(setting.key);
  return valid;
}

void apply_defaults(Settings& settings) {
  for (const Setting& setting : settings_table)
    if (!setting.initial.empty()) setting.read(settings, setting.initial);
}

}  // namespace glark::settings
