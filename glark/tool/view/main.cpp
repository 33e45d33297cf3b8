// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-view: `glark view FILE` shows points or a mesh in a window, or writes a picture without a window. `glark edit SCAN`
// becomes `glark-view edit SCAN` where there is a display.
#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <vector>

#include "glark/clients/geometry/measure/distance.h"
#include "glark/clients/geometry/write/output_file.h"
#include "glark/tool/scan/complaint.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/validators.h"
#if GLARK_HAS_EDIT
#include "glark/tool/scan/edit/session_names.h"
#include "glark/tool/view/edit/edit_window.h"
#endif
#include "glark/tool/view/draw/gl.h"
#include "glark/tool/view/film.h"
#include "glark/tool/view/maps/mapped_model.h"
#include "glark/tool/view/offscreen.h"
#include "glark/tool/view/window.h"

namespace glark::tool {
namespace {

struct View {
  Files files;
  std::string other;      // a second model; empty: none
  std::string reference;  // distances from it are shown; empty: none
  std::string picture;
  std::string film;
  int frames = 120;
  ViewOptions options;
};

void describe_models(CLI::App& command, View& view) {
  describe_input(command, view.files);
  command.add_option("OTHER", view.other, "A second model, which is shown beside the first one by the same camera");
  command
      .add_option("--measure", view.reference,
                  "Colour the points by their distance from the surface of this file: blue is 0, red is far")
      ->type_name("REFERENCE");
  command
      .add_option("--turntable", view.film,
                  "Write a film of one turn and exit, by the program ffmpeg; needs no display")
      ->type_name("OUT.mp4|OUT.gif");
  command.add_option("--frames", view.frames, "Pictures of the film, 30 a second; default 120")
      ->check(CLI::Range(1, 100000));
  command.add_option("--offscreen", view.picture, "Write a picture and exit; needs no display")
      ->type_name("OUT.png")
      ->excludes("--turntable");
}

void describe_modes(CLI::App& command, ViewOptions& options) {
  command
      .add_option("--mode", options.mode,
                  "splat, strip (strips of the points; of a file with strips or triangles, these), mesh, wireframe, "
                  "refined or patterns (refined, a colour for each pattern); default: "
                  "mesh if there are triangles, otherwise strip, or "
                  "splat above a million points")
      ->transform(one_of<Mode>({{"splat", Mode::splat},
                                {"strip", Mode::strip},
                                {"mesh", Mode::mesh},
                                {"wireframe", Mode::wireframe},
                                {"refined", Mode::refined},
                                {"patterns", Mode::patterns}}))
      ->type_name("MODE");
  command
      .add_option("--maps", options.maps,
                  "plain, normal or displaced: a model with maps by its mode, with its normal map, or displaced by "
                  "OpenGL too; default: all its maps, but plain with --mode or --measure")
      ->transform(one_of<MapsShown>(
          {{"plain", MapsShown::plain}, {"normal", MapsShown::normal}, {"displaced", MapsShown::displaced}}))
      ->type_name("MAPS");
  command.add_flag("--lines", options.settings.lines, "Draw refined triangles, and those of maps, as lines");
  command.add_flag("!--no-cull", options.settings.cull, "Also draw strips that are out of view or face away");
}

void describe_camera(CLI::App& command, ViewOptions& options) {
  command.add_option("--width", options.width, "Width of the picture in pixels; default 1024")
      ->check(CLI::Range(1, largest_side));
  command.add_option("--height", options.height, "Height of the picture in pixels; default 768")
      ->check(CLI::Range(1, largest_side));
  command.add_option("--yaw", options.yaw, "Degrees about the upright axis; default 30")->check(between(-360.0, 360.0));
  command.add_option("--pitch", options.pitch, "Degrees above the horizon, -90 to 90; default 20, or 40 for terrain")
      ->check(between(-90.0, 90.0));
  command
      .add_option("--up", options.z_is_up,
                  "The upright axis, y or z; default: z for terrain, which is flat in z, otherwise y")
      ->transform(one_of<bool>({{"y", false}, {"z", true}}))
      ->type_name("AXIS");
  command.add_option("--zoom", options.zoom, "Zoom; default 1, which shows everything")->check(between(0.01, 1000.0));
}

void describe_refinement(CLI::App& command, DrawSettings& settings) {
  command
      .add_option("--refine", settings.refinement,
                  "pn (curved PN triangles), phong or linear (flat triangles); default pn")
      ->transform(
          one_of<Refinement>({{"pn", Refinement::pn}, {"phong", Refinement::phong}, {"linear", Refinement::linear}}))
      ->type_name("REFINEMENT");
  command.add_option("--level", settings.level, "Level of refinement, 0 to 4; default 2")
      ->check(CLI::Range(0, deepest_level));
  command
      .add_option(
          "--edge-pixels", settings.edge_pixels,
          "Refine edges into segments of at most so many pixels, instead of --level; default for displaced maps: 4")
      ->check(CLI::Range(1, 10000));
  command
      .add_option("--budget", settings.budget,
                  "At most so many refined triangles with --edge-pixels: the segments grow until it holds")
      ->check(CLI::Range(0, 1000000000));
}

void describe(CLI::App& command, View& view) {
  describe_models(command, view);
  describe_modes(command, view.options);
  describe_camera(command, view.options);
  describe_refinement(command, view.options.settings);
}

Report report_of(const Statistics& drawn) {
  Report report;
  report["indices"] = drawn.indices;
  report["points"] = drawn.points;
  if (drawn.refined_triangles > 0) report["refined_triangles"] = drawn.refined_triangles;
  if (!drawn.patterns.empty()) {
    for (const auto& [pattern, count] : drawn.patterns) report["patterns"][name_of(pattern)] = count;
  }
  if (drawn.strips == 0) return report;
  report["strips"] = drawn.strips;
  report["nodes_visited"] = drawn.nodes_visited;
  report["nodes_out_of_view"] = drawn.nodes_out_of_frustum;
  report["nodes_turned_away"] = drawn.nodes_back_facing;
  return report;
}

// The models in a context without a window.
class Pictures {
 public:
  Pictures(const ViewOptions& options, std::vector<Model> models)
      : options_(options), context_(options.width, options.height) {
    for (Model& model : models) {
      scenes_.push_back(std::make_unique<Scene>(std::move(model.geometry), model.maps));
      if (!model.distances.empty()) scenes_.back()->colour_by(model.distances, greatest_shown(model.distances));
    }
    settings_ = settings_for(scenes_, options);
    camera = camera_for(*scenes_.front(), options);
  }

  // Returns what was drawn of the first model.
  Statistics draw() {
    clear_window();
    Statistics first;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      const Part part = part_of(i, scenes_.size(), options_.width, options_.height);
      const Statistics drawn = scenes_[i]->draw(camera, settings_, part);
      if (i == 0) first = drawn;
    }
    gl.Finish();  // without a window, this ends a frame
    return first;
  }

  Camera camera;

 private:
  const ViewOptions& options_;
  DrawSettings settings_;
  Offscreen context_;
  Scenes scenes_;
};

void draw_offscreen(const View& view, std::vector<Model> models) {
  constexpr int frames_to_budget = 12;  // the extension meets a budget some frames later
  Pictures pictures(view.options, std::move(models));
  Statistics drawn = pictures.draw();
  for (int frame = 1; view.options.settings.budget > 0 && frame < frames_to_budget; ++frame) drawn = pictures.draw();
  if (drawn.indices == 0 && drawn.points == 0)
    warn(view.files.input + ": nothing is drawn, for its points make no triangles; use --mode splat");
  write_screenshot(view.picture, view.options.width, view.options.height);
  print(report_of(drawn), view.files.json);
}

void film_turntable(const View& view, std::vector<Model> models) {
  Pictures pictures(view.options, std::move(models));
  Film film(view.film);
  const float first = pictures.camera.yaw;
  Statistics drawn;
  for (int i = 0; i < view.frames; ++i) {
    pictures.camera.yaw = first + 360.0F * static_cast<float>(i) / static_cast<float>(view.frames);
    drawn = pictures.draw();
    film.add_picture(view.options.width, view.options.height);
  }
  film.finish();
  print(report_of(drawn), view.files.json);
}

std::string lower_case_ending(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

Model load_model(const std::string& file, const Files& files) {
  const bool has_format = file == files.input && !files.format.empty();
  const std::string format = has_format ? files.format : lower_case_ending(file);
  if (format == ".glb" || format == ".gltf") {
    MapsReading reading = read_maps(file);
    for (const std::string& warning : reading.warnings) warn(warning);
    if (reading.model) return {std::move(reading.model->geometry), {}, std::move(reading.model->maps)};
  }
  return {load(file, files), {}, {}};
}

// All models are drawn by one camera, so the origin of the first is theirs.
void move_to_origin(const std::array<double, 3>& origin, geometry::Geometry& geometry) {
  for (std::size_t i = 0; i < geometry.positions.size(); ++i)
    geometry.positions[i] = static_cast<float>(geometry.positions[i] + (geometry.origin[i % 3] - origin[i % 3]));
  geometry.origin = origin;
}

void check_maps(const View& view, const Model& model) {
  if (!view.options.maps || *view.options.maps == MapsShown::plain) return;
  const bool displaced = *view.options.maps == MapsShown::displaced;
  if (!model.maps)
    warn(view.files.input + ": it has no maps for --maps; glark bake makes them");
  else if (displaced && !model.maps->displacement)
    warn(view.files.input + ": it has no displacement map for --maps displaced; its other maps are drawn");
}

std::vector<Model> load_models(const View& view) {
  std::vector<Model> models;
  models.push_back(load_model(view.files.input, view.files));
  check_maps(view, models.front());
  if (!view.other.empty()) {
    models.push_back(load_model(view.other, view.files));
    move_to_origin(models.front().geometry.origin, models.back().geometry);
  }
  if (view.reference.empty()) return models;
  const geometry::Geometry reference = load(view.reference, view.files);
  for (Model& model : models) {
    if (reference.point_count() == 0 || model.geometry.point_count() == 0)
      throw std::runtime_error("--measure: " + view.reference + " or the model has no points");
    model.distances = geometry::distances_of_points(model.geometry, reference);
  }
  return models;
}

bool is_png(const std::string& file) {
  const std::string extension = lower_case_ending(file);
  return extension == ".png" || extension.empty();
}

void run(View& view) {
  ViewOptions& options = view.options;
  if (options.mode && options.maps.value_or(MapsShown::plain) != MapsShown::plain)
    throw CLI::ValidationError(
        "--mode is for models without maps; leave it out with --maps normal or displaced, --lines shows their "
        "triangles");
  if (!view.reference.empty() && !options.maps) options.maps = MapsShown::plain;  // maps would hide its colours
  if (!view.picture.empty()) {
    if (!is_png(view.picture))
      throw std::runtime_error(view.picture + ": pictures are written as PNG; call it OUT.png");
    const geometry::OutputFile trial(view.picture);
  }
  if (!view.film.empty()) const geometry::OutputFile trial(view.film);
  std::vector<Model> models = load_models(view);
  if (!view.film.empty())
    film_turntable(view, std::move(models));
  else if (!view.picture.empty())
    draw_offscreen(view, std::move(models));
  else
    show_window("glark " + view.files.input, std::move(models), view.options);
}

#if GLARK_HAS_EDIT
void describe(CLI::App& command, EditOptions& edit) {
  command.add_option("SCAN", edit.scan, "The scan: binary PLY, .las, .stl or .raw")->required();
  command
      .add_option("-o,--output", edit.output,
                  "Where the edited scan is saved, in the format of SCAN; default: SCAN.edited with its ending")
      ->type_name("OUT");
  command.add_option("--session", edit.session, "The folder of the session; default: SCAN with the ending .edit")
      ->type_name("FOLDER");
  command.add_option("--target", edit.sampling.target, "The most samples of a new session; default 200000")
      ->transform(whole_above_zero());
  command.add_option("--memory", edit.sampling.memory, "The most memory for the sampling, as 64MB; default 256MB")
      ->transform(bytes_above_zero())
      ->type_name("BYTES");
  command.add_option("--threads", edit.sampling.threads, "Most threads; default: all of the machine");
  command.add_option("--width", edit.width, "Width of the window; default 1024")->check(CLI::Range(1, largest_side));
  command.add_option("--height", edit.height, "Height of the window; default 768")->check(CLI::Range(1, largest_side));
}

void run(EditOptions edit) {
  if (edit.session.empty()) edit.session = session_folder(edit.scan);
  edit.may_replace = !edit.output.empty();
  if (edit.output.empty()) edit.output = edited_scan(edit.scan);
  show_edit_window(edit);
}
#endif

}  // namespace
}  // namespace glark::tool

int main(int argc, char** argv) {
  using namespace glark::tool;
  const std::string name = argc > 1 && std::string(argv[1]) == "edit" ? "edit" : "view";
  CLI::App app("glark: points and triangles in files", "glark");
  app.require_subcommand(1);
  View view;
  CLI::App* command = app.add_subcommand("view", "Show points or triangles in a window, or write a picture");
  describe(*command, view);
#if GLARK_HAS_EDIT
  EditOptions edit;
  CLI::App* editing = app.add_subcommand("edit", "Edit a scan by its sampling, in a window");
  describe(*editing, edit);
#endif
  try {
    app.parse(argc, argv);
#if GLARK_HAS_EDIT
    if (editing->parsed()) run(edit);
#endif
    view.options.has_depth = command->count("--level") + command->count("--edge-pixels") > 0;
    if (command->parsed()) run(view);
  } catch (const CLI::Success& wanted) {  // --help
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; glark " + name + " --help lists the options", exit_usage);
  } catch (const std::bad_alloc&) {
    return complain("the memory is too small for this file; simplify it first", exit_failure);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failure);
  }
  return 0;
}
