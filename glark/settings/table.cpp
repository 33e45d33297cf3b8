// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/table.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace glark::settings {
namespace {

static_assert(core::max_supported_level == 11, "the texts below name the limit");

template <class T, class U>
bool assign(std::optional<T> value, U& setting) {
  if (!value) return false;
  setting = *std::move(value);
  return true;
}

std::optional<std::string> parse_file(std::string_view text) {
  return text.empty() || text.find('\0') != std::string_view::npos ? std::nullopt : std::optional(std::string(text));
}

bool read_max_level(Settings& s, std::string_view text) {
  const bool valid = assign(parse_level(text), s.context.max_level);
  s.max_level_set = s.max_level_set || valid;
  return valid;
}

constexpr char level_needed[] = "an integer from 0 to 11";
constexpr char switch_needed[] = "0 or 1";
constexpr char file_needed[] = "the name of a file";
constexpr char attribute_needed[] = "the name of a vertex attribute or its location";

// The words of all refinements, and with them what each does, made at compile time from their rows.
template <std::size_t size>
struct Text {
  std::array<char, size> letters{};
  constexpr operator std::string_view() const { return {letters.data(), size}; }
};

// Calls `add` with the parts of "a, b or c".
constexpr void list_refinements(bool with_help, auto&& add) {
  for (std::size_t i = 0; i < core::refinements.size(); ++i) {
    add(i == 0 ? "" : i + 1 < core::refinements.size() ? ", " : " or ");
    add(core::refinements[i].word);
    if (!with_help) continue;
    add(" (");
    add(core::refinements[i].help);
    add(")");
  }
}

template <bool with_help>
constexpr auto refinements_text() {
  constexpr std::size_t size = [] {
    std::size_t letters = 0;
    list_refinements(with_help, [&](std::string_view part) { letters += part.size(); });
    return letters;
  }();
  Text<size> text;
  list_refinements(with_help, [&, end = std::size_t{0}](std::string_view part) mutable {
    for (const char letter : part) text.letters[end++] = letter;
  });
  return text;
}
constexpr auto refinement_words = refinements_text<false>();
constexpr auto refinement_help = refinements_text<true>();

template <std::size_t refinement>
bool read_shape_number(Settings& s, std::string_view text) {
  return assign(parse_shape_number(core::refinements[refinement].number, text), s.context.shape_numbers[refinement]);
}

constexpr std::size_t shape_number_count = [] {
  std::size_t count = 0;
  for (const core::RefinementTraits& row : core::refinements) count += row.number.exists() ? 1 : 0;
  return count;
}();

// A setting for each refinement that has a number.
template <std::size_t... refinement>
constexpr auto settings_of_shape_numbers(std::index_sequence<refinement...> /*all*/) {
  std::array<Setting, shape_number_count> rows{};
  std::size_t next = 0;
  const auto add = [&](const core::ShapeNumber& number, bool (*read)(Settings&, std::string_view)) {
    if (number.exists())
      rows[next++] = {number.key, number.variable, Kind::value, number.placeholder, number.needed, number.help, read};
  };
  (add(core::refinements[refinement].number, read_shape_number<refinement>), ...);
  return rows;
}

// clang-format off
constexpr std::array first_settings{
    Setting{"level", "GLARK_LEVEL", Kind::value, "N", level_needed,
            "Uniform level of refinement, 0 to 11: every triangle becomes 4^N; 2 if not given",
            [](Settings& s, std::string_view text) { return assign(parse_level(text), s.context.level); }},
    Setting{"max-level", "GLARK_MAX_LEVEL", Kind::value, "N", level_needed,
            "Deepest level that patterns are made for, 0 to 11; 6 if not given", read_max_level},
    Setting{"refine", "GLARK_REFINE", Kind::value, "KIND", refinement_words, refinement_help,
            [](Settings& s, std::string_view text) { return assign(parse_refinement(text), s.context.refinement); }},
};

constexpr std::array other_settings{
    Setting{"no-weld", "GLARK_NO_WELD", Kind::toggle, "", switch_needed,
            "Curve each triangle by its own normals alone: where they jump from one to the next, pn may crack there",
            [](Settings& s, std::string_view text) {
              bool off = false;
              const bool valid = assign(parse_switch(text), off);
              s.context.weld = !off;
              return valid;
            }},
    Setting{"edge-pixels", "GLARK_EDGE_PIXELS", Kind::value, "P", "a number from 0.5 to 10000, or 0 for none,",
            "Each edge as deep as its length on the screen wants: the longest segment, in pixels; instead of --level",
            [](Settings& s, std::string_view text) { return assign(parse_edge_pixels(text), s.context.measure.pixels); }},
    Setting{"curvature", "GLARK_CURVATURE", Kind::value, "DEGREES", "degrees from 0.5 to 180, or 0 for none,",
            "Each edge as deep as the normals at its ends differ: the greatest turn of a segment, in degrees",
            [](Settings& s, std::string_view text) { return assign(parse_curvature(text), s.context.measure.degrees); }},
    Setting{"budget", "GLARK_BUDGET", Kind::value, "N", "a number of triangles up to 1000000000, or 0 for none,",
            "Refined triangles a frame that --edge-pixels and --curvature give way to",
            [](Settings& s, std::string_view text) { return assign(parse_budget(text), s.context.measure.budget); }},
    Setting{"geomorph", "GLARK_GEOMORPH", Kind::toggle, "", switch_needed,
            "Move vertices between the levels of --edge-pixels and --curvature, so that none pops up",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.geomorph); }},
    Setting{"polygons", "GLARK_POLYGONS", Kind::value, "SPLIT", "triangles or centroid",
            "triangles (quads and polygons as OpenGL cuts them) or centroid (a fan about the centre of each)",
            [](Settings& s, std::string_view text) { return assign(parse_polygons(text), s.context.centroids); }},
    Setting{"wireframe", "GLARK_WIREFRAME", Kind::toggle, "", switch_needed, "Draw the refined triangles as lines",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.context.wireframe); }},
    Setting{"position", "GLARK_POSITION", Kind::value, "ATTRIBUTE", attribute_needed,
            "Vertex attribute that is the position, by name or location, where it is not guessed right",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.position); }},
    Setting{"normal", "GLARK_NORMAL", Kind::value, "ATTRIBUTE", attribute_needed,
            "Vertex attribute that is the normal",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.normal); }},
    Setting{"texture-coordinate", "GLARK_TEXTURE_COORDINATE", Kind::value, "ATTRIBUTE", attribute_needed,
            "Vertex attribute that is the texture coordinate",
            [](Settings& s, std::string_view text) { return assign(parse_attribute(text), s.context.roles.texture_coordinate); }},
    Setting{"leave-draws", "GLARK_LEAVE_DRAWS", Kind::value, "RULES",
            "a list of screen-quads, overlays, orthographic, blended, no-depth-test, no-depth-writes, or none",
            "Draws to leave as they are, with commas: screen-quads,overlays,orthographic if not given; "
            "also blended, no-depth-test, no-depth-writes; none for no such rule",
            [](Settings& s, std::string_view text) { return assign(parse_left_draws(text), s.context.left_draws); }},
    Setting{"leave-shaders", "GLARK_LEAVE_SHADERS", Kind::value, "HASHES", "a list of hashes of 16 hexadecimal digits",
            "Shader programs to leave as they are, by their hashes in --stats and --dump-shaders, with commas",
            [](Settings& s, std::string_view text) { return assign(parse_hashes(text), s.context.left_shaders); }},
    Setting{"leave-alone", "GLARK_LEAVE_ALONE", Kind::toggle, "", switch_needed,
            "Leave every draw of the program as it is",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.leave_alone); }},
    Setting{"everything", "GLARK_EVERYTHING", Kind::toggle, "", switch_needed,
            "Leave no draw and no shader as it is, whatever the other settings say",
            [](Settings& s, std::string_view text) { return assign(parse_switch(text), s.everything); }},
    Setting{"capture", "GLARK_CAPTURE", Kind::captures, "FRAME:FILE.png", "FRAME:FILE.png, with frames counted from 1,",
            "Write that frame, counted from 1, as an image; may be repeated",
            [](Settings& s, std::string_view text) { return assign(parse_captures(text), s.captures); }},
    Setting{"stats", "GLARK_STATS", Kind::output_file, "FILE.json", file_needed, "Write statistics of the run",
            [](Settings& s, std::string_view text) { return assign(parse_file(text), s.statistics_file); }},
    Setting{"dump-shaders", "GLARK_DUMP_SHADERS", Kind::output_folder, "DIR", "the name of a folder",
            "Write the sources of the program's shaders and of those derived from them",
            [](Settings& s, std::string_view text) { return assign(parse_file(text), s.dump_folder); }},
    Setting{"log", "GLARK_LOG", Kind::value, "LEVEL", "error, warning, info or debug",
            "Most verbose messages wanted: error, warning, info or debug",
            [](Settings& s, std::string_view text) { return assign(parse_log_level(text), s.log_level); }},
    // Looked for before all others are read.
    Setting{"config", variable::config, Kind::input_file, "FILE", file_needed,
            "Configuration file, instead of glark/glark.toml in the XDG folders",
            [](Settings&, std::string_view) { return true; }, false},
};
// clang-format on

constexpr auto settings_table = [] {
  constexpr auto numbers = settings_of_shape_numbers(std::make_index_sequence<core::refinements.size()>());
  std::array<Setting, first_settings.size() + numbers.size() + other_settings.size()> all{};
  std::copy(
      other_settings.begin(), other_settings.end(),
      std::copy(numbers.begin(), numbers.end(), std::copy(first_settings.begin(), first_settings.end(), all.begin())));
  return all;
}();

}  // namespace

std::span<const Setting> table() { return settings_table; }

const Setting* find_setting(std::string_view key) {
  const auto* const found = std::find_if(settings_table.begin(), settings_table.end(),
                                         [&](const Setting& setting) { return setting.key == key; });
  return found != settings_table.end() ? found : nullptr;
}

}  // namespace glark::settings
