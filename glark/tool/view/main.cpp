// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-view: `glark view FILE` shows points or a mesh in a window, or writes a picture without a window.
#include <CLI/CLI.hpp>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "glark/clients/geometry/write/output_file.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/validators.h"
#include "glark/tool/view/offscreen.h"
#include "glark/tool/view/window.h"

namespace glark::tool {
namespace {

constexpr int exit_failure = 1;
constexpr int exit_usage = 2;
constexpr int largest_side = 16384;

struct View {
  Files files;
  std::string picture;
  ViewOptions options;
};

void describe(CLI::App& command, View& view) {
  describe_input(command, view.files);
  ViewOptions& options = view.options;
  command.add_option("--offscreen", view.picture, "Write a picture and exit; needs no display")->type_name("OUT.png");
  command
      .add_option("--mode", options.mode,
                  "splat, strip, mesh, wireframe or refined; default: mesh if there are triangles, otherwise strip, or "
                  "splat above a million points")
      ->transform(one_of<Mode>({{"splat", Mode::splat},
                                {"strip", Mode::strip},
                                {"mesh", Mode::mesh},
                                {"wireframe", Mode::wireframe},
                                {"refined", Mode::refined}}))
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
  command.add_option("--level", options.level, "Level of refinement, 0 to 4; default 2")->check(CLI::Range(0, 4));
  command.add_flag("!--no-cull", options.cull, "Also draw strips that are out of view or face away");
}

Report report_of(const Statistics& drawn) {
  Report report;
  report["indices"] = drawn.indices;
  report["points"] = drawn.points;
  if (drawn.strips == 0) return report;
  report["strips"] = drawn.strips;
  report["nodes_visited"] = drawn.nodes_visited;
  report["nodes_out_of_view"] = drawn.nodes_out_of_frustum;
  report["nodes_turned_away"] = drawn.nodes_back_facing;
  return report;
}

void draw_offscreen(const View& view, geometry::Geometry geometry) {
  const ViewOptions& options = view.options;
  const Offscreen context(options.width, options.height);
  Scene scene(std::move(geometry));
  scene.cull = options.cull;
  scene.refinement_level = options.level;
  const Statistics drawn = scene.draw(camera_for(scene, options), options.mode.value_or(scene.default_mode()),
                                      options.width, options.height);
  if (drawn.indices == 0 && drawn.points == 0)
    warn(view.files.input + ": nothing is drawn, for its points make no triangles; use --mode splat");
  write_screenshot(view.picture, options.width, options.height);
  print(report_of(drawn), view.files.json);
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
  geometry::Geometry geometry = load(view.files.input, view.files);
  if (view.picture.empty())
    show_window("glark " + view.files.input, std::move(geometry), view.options);
  else
    draw_offscreen(view, std::move(geometry));
}

int complain(const std::string& problem, int status) {
  std::fprintf(stderr, "glark: %s\n", problem.c_str());
  return status;
}

}  // namespace
}  // namespace glark::tool

int main(int argc, char** argv) {
  using namespace glark::tool;
  CLI::App app("glark: points and triangles in files", "glark");
  app.require_subcommand(1);
  View view;
  CLI::App* command = app.add_subcommand("view", "Show points or triangles in a window, or write a picture");
  describe(*command, view);
  try {
    app.parse(argc, argv);
    run(view);
  } catch (const CLI::Success& wanted) {  // --help
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; glark view --help lists the options", exit_usage);
  } catch (const std::bad_alloc&) {
    return complain("the memory is too small for this file; simplify it first", exit_failure);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failure);
  }
  return 0;
}
