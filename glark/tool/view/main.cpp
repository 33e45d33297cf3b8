// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-view: `glark view FILE` shows points or a mesh in a window, or writes a picture without a window. `glark edit SCAN`
// becomes `glark-view edit SCAN` where there is a display.
#include <CLI/CLI.hpp>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <vector>

#include "glark/clients/geometry/measure/distance.h"
#include "glark/clients/geometry/write/output_file.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/validators.h"
#if GLARK_HAS_EDIT
#include "glark/tool/scan/edit/session_names.h"
#include "glark/tool/view/edit/edit_window.h"
#endif
#include "glark/tool/view/film.h"
#include "glark/tool/view/offscreen.h"
#include "glark/tool/view/window.h"

namespace glark::tool {
namespace {

constexpr int exit_failure = 1;
constexpr int exit_usage = 2;

struct View {
  Files files;
  std::string other;      // a second model; empty: none
  std::string reference;  // distances from it are shown; empty: none
  std::string picture;
  std::string film;
  int frames = 120;
  ViewOptions options;
};

void describe(CLI::App& command, View& view) {
  describe_input(command, view.files);
  ViewOptions& options = view.options;
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
  command.add_option("--offscreen", view.picture, "Write a picture and exit; needs no display")->type_name("OUT.png");
  command
      .add_option("--mode", options.mode,
                  "splat, strip, mesh, wireframe, refined or patterns (refined, a colour for each pattern); default: "
                  "mesh if there are triangles, otherwise strip, or "
                  "splat above a million points")
      ->transform(one_of<Mode>({{"splat", Mode::splat},
                                {"strip", Mode::strip},
                                {"mesh", Mode::mesh},
                                {"wireframe", Mode::wireframe},
                                {"refined", Mode::refined},
                                {"patterns", Mode::patterns}}))
      ->type_name("MODE");
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
  command
      .add_option("--refine", options.settings.refinement,
                  "pn (curved PN triangles), phong or linear (flat triangles); default pn")
      ->transform(
          one_of<Refinement>({{"pn", Refinement::pn}, {"phong", Refinement::phong}, {"linear", Refinement::linear}}))
      ->type_name("REFINEMENT");
  command.add_option("--level", options.settings.level, "Level of refinement, 0 to 4; default 2")
      ->check(CLI::Range(0, deepest_level));
  command
      .add_option("--edge-pixels", options.settings.edge_pixels,
                  "Refine edges into segments of at most so many pixels, instead of --level")
      ->check(CLI::Range(1, 10000));
  command.add_flag("--lines", options.settings.lines, "Draw refined triangles as lines");
  command.add_flag("!--no-cull", options.settings.cull, "Also draw strips that are out of view or face away");
}

Report report_of(const Statistics& drawn) {
  Report report;
  report["indices"] = drawn.indices;
  report["points"] = drawn.points;
  if (!drawn.patterns.empty()) {
    report["refined_triangles"] = drawn.refined_triangles;
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
      : options_(options), settings_(options.settings), context_(options.width, options.height) {
    for (Model& model : models) {
      scenes_.push_back(std::make_unique<Scene>(std::move(model.geometry)));
      if (!model.distances.empty()) scenes_.back()->colour_by(model.distances, greatest_shown(model.distances));
    }
    settings_.mode = options.mode.value_or(scenes_.front()->default_mode());
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
    return first;
  }

  Camera camera;

 private:
  const ViewOptions& options_;
  DrawSettings settings_;
  Offscreen context_;
  std::vector<std::unique_ptr<Scene>> scenes_;
};

void draw_offscreen(const View& view, std::vector<Model> models) {
  Pictures pictures(view.options, std::move(models));
  const Statistics drawn = pictures.draw();
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

std::vector<Model> load_models(const View& view) {
  std::vector<Model> models;
  models.push_back({load(view.files.input, view.files), {}});
  if (!view.other.empty()) models.push_back({load(view.other, view.files), {}});
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
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension == ".png" || extension.empty();
}

void run(const View& view) {
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
      ->transform(CLI::AsSizeValue(false))
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

int complain(const std::string& problem, int status) {
  std::fprintf(stderr, "glark: %s\n", problem.c_str());
  return status;
}

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
