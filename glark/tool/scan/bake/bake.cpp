// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark bake LARGE -o MODEL.glb, or MODEL.ply: a coarse mesh with a normal map, a colour map and a displacement map.
#include <fmt/format.h>

#include <glark/maps.h>

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "glark/clients/geometry/measure/area.h"
#include "glark/tool/scan/bake/coarse_mesh.h"
#include "glark/tool/scan/bake/saved_work.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/rgb.h"
#include "glark/tool/scan/stream/work_folder.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

constexpr double samples_a_vertex = 2;  // of a fine mesh, at least: triangles are divided into whole parts

// A reconstruction is nearer to noisy scans than strips, but takes longer and keeps all points in the memory.
constexpr std::size_t most_reconstructed = 4000000;
constexpr double most_texels = 64;  // of the surface for each point

struct Bake {
  Files files;
  std::string mesh, size;
  CoarseOptions coarse;
  maps::BakeOptions options;
  std::optional<double> noise;  // empty: measured
  Memory memory;
  bool pictures = false, object_normals = false, strips = false, resume = false;
};

// The fine surface. Its points are in a file, or in the memory.
struct Fine {
  geometry::Geometry geometry;
  std::vector<std::uint8_t> colours;
  std::vector<maps::Picture> pictures;
  std::vector<maps::PictureWrap> wraps;  // of the pictures
  stream::Source source;
};

// The model names the displacement map, and glTF is UTF-8.
bool is_utf8(const std::string& text) {
  try {
    return !Report(text).dump().empty();
  } catch (const Report::exception&) {
    return false;
  }
}

bool is_ply(const Bake& command) { return std::filesystem::path(command.files.output).extension() == ".ply"; }

void require_model_name(const Bake& command) {
  const std::filesystem::path file(command.files.output);
  if (file.extension() != ".glb" && !is_ply(command))
    throw std::runtime_error(
        file.string() +
        ": the model is written as binary glTF or PLY; give a name that ends with .glb or .ply, as "
        "model.glb");
  if (command.strips && !is_ply(command))
    throw std::runtime_error(file.string() + ": --strips is for PLY; give a name that ends with .ply, as model.ply");
  if (is_ply(command) && file.filename().string().find_first_of("\r\n") != std::string::npos)
    throw std::runtime_error(
        file.string() + ": the name has a line break, which a comment of a PLY file cannot have; give another name");
  if (!is_ply(command) && !is_utf8(file.filename().string()))
    throw std::runtime_error(file.string() +
                             ": the name is no UTF-8, which the text in a model must be; give another name");
}

void write(const Bake& command, const maps::Baked& model) {
  const std::string& file = command.files.output;
  if (is_ply(command)) {
    maps::write_ply(file, model, command.strips);
  } else {
    maps::write_model(file, model);
    if (command.pictures) maps::write_pictures(file, model);
  }
  if (command.object_normals) maps::write_object_normals(file, model);
}

void require_coarse(const geometry::Geometry& mesh, const Bake& command) {
  if (!command.mesh.empty()) return;
  if (mesh.triangles.empty())
    throw std::runtime_error(fmt::format("{}: nothing is left of it with {} triangles; more --triangles keep its shape",
                                         command.files.input, command.coarse.triangles));
  constexpr double told = 1.05;
  if (static_cast<double>(mesh.triangle_count()) > told * static_cast<double>(command.coarse.triangles))
    warn(
        fmt::format("{}: the coarse mesh has {} triangles instead of {}, because fewer would tear it; are all its "
                    "triangles wound to one side?",
                    command.files.input, mesh.triangle_count(), command.coarse.triangles));
}

double spacing_of(const geometry::Geometry& mesh) {
  const double samples = samples_a_vertex * static_cast<double>(mesh.point_count());
  return std::sqrt(2 * geometry::area_of(mesh) / samples);  // n * n samples have n / sqrt(2) in a square's side
}

maps::Wrap wrap_of(geometry::Wrap wrap) {
  if (wrap == geometry::Wrap::repeat) return maps::Wrap::repeat;
  return wrap == geometry::Wrap::mirror ? maps::Wrap::mirror : maps::Wrap::clamp;
}

std::unique_ptr<Fine> read_fine(const Bake& command) {
  auto fine = std::make_unique<Fine>();
  if (must_read_in_parts(command.files, memory_for(command.memory))) {
    fine->source = stream::file_source(command.files.input, command.files.format);
    return fine;
  }
  fine->geometry = load(command.files.input, command.files, true);
  const geometry::Geometry& geometry = fine->geometry;
  if (geometry.point_count() == 0) throw std::runtime_error(command.files.input + ": it has no points");
  warn_of_alpha(geometry.colours, command.files.input);
  fine->colours = rgb_of(geometry.colours);
  for (const geometry::Image& image : geometry.images) {
    fine->pictures.push_back({image.width, image.height, image.pixels});
    fine->wraps.push_back({wrap_of(image.wrap_s), wrap_of(image.wrap_t)});
  }
  if (fine->pictures.empty() && fine->colours.empty() && !geometry.texture_coordinates.empty())
    warn(command.files.input + ": it has texture coordinates, but no picture was read; the model has no colours");
  const double spacing = geometry.triangles.empty() ? 1 : spacing_of(geometry);
  std::span<const std::uint8_t> tints;
  if (geometry.colours_tint_images) tints = fine->colours;
  fine->source = maps::mesh_source({.origin = geometry.origin,
                                    .positions = geometry.positions,
                                    .normals = geometry.normals,
                                    .colours = fine->colours,
                                    .triangles = geometry.triangles,
                                    .pictures = fine->pictures,
                                    .triangle_pictures = geometry.triangle_images,
                                    .texcoords = geometry.texture_coordinates,
                                    .picture_wraps = fine->wraps,
                                    .tints = tints},
                                   spacing > 0 ? spacing : 1);
  fine->source.name = command.files.input;
  return fine;
}

// All that the saved work depends on, by the names of the options.
std::string identity_of(const Bake& command, const Fine& fine) {
  const maps::BakeOptions& options = command.options;
  std::string identity = fmt::format("glark bake {}\n", GLARK_VERSION);
  const auto add = [&](const char* name, const auto& value) { identity += fmt::format("{} {}\n", name, value); };
  add("the input", fine.source.identity);
  add("--skip-invalid", command.files.skip_invalid);
  add("--mesh", command.mesh.empty() ? "none" : "given");
  add("--triangles", command.coarse.triangles);
  add("--memory", command.coarse.memory);
  add("--texture-coordinates", static_cast<int>(options.texcoords));
  add("--size", fmt::format("{}x{}", options.width, options.height));
  add("--texture-memory", options.texture_memory);
  add("--texels-per-point", options.texels_per_point);
  add("--noise", command.noise ? fmt::format("{}", *command.noise) : "measured");
  add("--reach", options.reach);
  return identity;
}

// noise: receives the noise of the points, if it is measured.
geometry::Geometry make_coarse_mesh(const Bake& command, const Fine& fine, SavedWork& work, double& noise) {
  if (!fine.geometry.triangles.empty()) return simplify_to(fine.geometry, command.coarse);
  const std::size_t points = fine.geometry.point_count();
  if (points > 0 && points <= most_reconstructed) {
    CoarseReconstruction coarse = reconstruct_from(fine.geometry, command.coarse);
    noise = coarse.noise;
    if (!coarse.mesh.triangles.empty()) return std::move(coarse.mesh);
  }
  return strip_sampling(fine.source, command.coarse, command.files.skip_invalid, work);
}

geometry::Geometry coarse_mesh(const Bake& command, const Fine& fine, SavedWork& work, double& noise) {
  if (!command.mesh.empty()) return read_coarse_mesh(command.mesh, command.files);
  geometry::Geometry mesh;
  if (work.load("mesh", mesh, noise)) return mesh;
  mesh = make_coarse_mesh(command, fine, work, noise);
  require_coarse(mesh, command);
  work.save("mesh", mesh, noise);
  return mesh;
}

void warn_of_losses(const maps::Baked& model, const Bake& command) {
  constexpr double told = 0.99;
  const std::string& file = command.files.input;
  if (model.density < told && command.options.width == 0)
    warn(fmt::format(
        "{}: the maps have {:.3g} of the texels that its points are worth; more --texture-memory gives more", file,
        model.density * model.density));
  if (model.left_out > 0)
    warn(fmt::format(
        "{}: {} of {} points are left out, which are more than {:.3g} from the coarse mesh or face away from "
        "it; --reach takes in points farther away, and normals must point to the outside",
        file, model.left_out, model.points, model.reach));
  if (model.invalid > 0)
    warn(fmt::format("{}: {} points with NaN or infinite coordinates are left out", file, model.invalid));
  if (model.empty_charts > 0)
    warn(fmt::format(
        "{}: {} of {} charts of the coarse mesh have no points; they stay flat, with the colours of their neighbours",
        file, model.empty_charts, model.charts));
}

Report report_of(const maps::Baked& model, double noise) {
  Report report;
  report["points"] = model.points;
  report["points_left_out"] = model.left_out;
  report["triangles"] = model.triangles.size() / 3;
  report["vertices"] = model.positions.size() / 3;
  report["width"] = model.width;
  report["height"] = model.height;
  report["own_texture_coordinates"] = model.has_own_texcoords;
  report["charts"] = model.charts;
  report["hard_edges"] = model.hard_edges;
  report["charts_without_points"] = model.empty_charts;
  report["texels"] = model.texels;
  report["texels_filled"] = model.filled;
  report["texel_density"] = model.density;
  report["reach"] = model.reach;
  report["noise"] = noise;
  report["lowest_displacement"] = model.bias;
  report["highest_displacement"] = static_cast<double>(model.bias) + static_cast<double>(model.scale);
  report["seams"] = model.seams.edges;
  const auto add = [&report](const std::string& name, const maps::Jump& jump, double unit) {
    report["largest_" + name] = unit * static_cast<double>(jump.greatest);
    report["root_mean_square_" + name] = unit * static_cast<double>(jump.root_mean_square);
  };
  add("seam_colour_of_255", model.seams.colour, 255);
  add("seam_normal_degrees", model.seams.normal, 1);
  add("seam_displacement", model.seams.displacement, 1);
  for (std::size_t i = 0; i < model.mip_seams.size(); ++i) {
    add(fmt::format("seam_colour_of_255_level_{}", i + 1), model.mip_seams[i].colour, 255);
    add(fmt::format("seam_normal_degrees_level_{}", i + 1), model.mip_seams[i].normal, 1);
  }
  return report;
}

// Bad input fails again. So the saved work is kept only if a file could not be read or written.
template <class Step>
void run_saved(SavedWork& work, const Step& step) {
  try {
    step();
  } catch (const WorkError&) {
    throw;
  } catch (const maps::Error& error) {
    if (error.element() != maps::Element::file) work.finish();
    throw;
  } catch (const stream::Error& error) {
    if (error.element() != stream::Element::file) work.finish();
    throw;
  } catch (const std::exception&) {
    work.finish();
    throw;
  }
  work.finish();
}

maps::Baked bake_maps(const Bake& command, const Fine& fine, const geometry::Geometry& mesh,
                      const maps::BakeOptions& options) {
  maps::Baked model =
      maps::bake({.origin = mesh.origin,
                  .positions = mesh.positions,
                  .normals = mesh.normals,
                  .triangles = mesh.triangles,
                  .texcoords = command.mesh.empty() ? std::span<const float>() : std::span(mesh.texture_coordinates)},
                 fine.source, options);
  if (command.mesh.empty() && 2 * model.left_out > model.points)
    throw std::runtime_error(fmt::format(
        "{}: {} of {} points are more than {:.3g} from the coarse mesh or face away from it; normals must point to the "
        "outside: turn them, leave them out, or give a mesh by --mesh",
        command.files.input, model.left_out, model.points, model.reach));
  warn_of_losses(model, command);
  if (!mesh.texture_coordinates.empty() && !model.texcoords_fault.empty())
    warn(command.mesh + ": new texture coordinates replace its own, because " + model.texcoords_fault);
  return model;
}

void bake(const Bake& command, const Fine& fine, SavedWork& work) {
  double noise = 0;
  const geometry::Geometry mesh = coarse_mesh(command, fine, work, noise);
  maps::BakeOptions options = command.options;
  options.noise = command.noise.value_or(noise);
  options.threads = command.coarse.threads;
  options.skip_invalid = command.files.skip_invalid;
  options.work = work.part("maps");
  options.resume = command.resume && !options.work.empty();
  Progress progress("baking " + command.files.input);
  options.progress = [&](double fraction) { progress.show(fraction); };
  const maps::Baked model = bake_maps(command, fine, mesh, options);
  write(command, model);
  Report report = report_of(model, options.noise);
  report["seconds"] = progress.seconds();
  report["peak_memory_bytes"] = peak_memory();
  print(report, command.files.json);
}

void run(const Bake& command) {
  require_model_name(command);
  check_output(command.files);
  const std::unique_ptr<Fine> fine = read_fine(command);
  SavedWork work(work_folder(command.files.output), identity_of(command, *fine), command.resume);
  run_saved(work, [&] { bake(command, *fine, work); });
}

// Accepts a power of two, as 2048, or two of them, as 2048x1024.
CLI::Validator size_of_maps(maps::BakeOptions& options) {
  return {[&options](std::string& text) -> std::string {
            constexpr unsigned least = 64;
            const std::size_t cross = text.find('x');
            const std::array<std::string, 2> sides{text.substr(0, cross),
                                                   cross == std::string::npos ? text : text.substr(cross + 1)};
            for (std::size_t i = 0; i < 2; ++i) {
              unsigned& side = i == 0 ? options.width : options.height;
              const bool is_number = !sides[i].empty() && sides[i].find_first_not_of("0123456789") == std::string::npos;
              if (!is_number || !CLI::detail::lexical_cast(sides[i], side) || !std::has_single_bit(side) ||
                  side < least || side > largest_side)
                return fmt::format("\"{}\" is not a power of two from {} to {}, or two of them as 2048x1024", text,
                                   least, largest_side);
            }
            return {};
          },
          ""};
}

void describe_layout(CLI::App& command, Bake& bake) {
  command
      .add_option(
          "--texture-coordinates", bake.options.texcoords,
          "Whose texture coordinates the model has: own keeps those of COARSE, charts makes new ones, auto keeps "
          "them if each triangle has a place of its own within 0 to 1; default auto")
      ->type_name("auto|own|charts")
      ->transform(one_of<maps::Texcoords>(
          {{"auto", maps::Texcoords::automatic}, {"own", maps::Texcoords::own}, {"charts", maps::Texcoords::charts}}))
      ->needs("--mesh");
  command
      .add_option(
          "--size", bake.size,
          "The size of the maps, a power of two or two of them, as 2048 or 2048x1024; default: by the number of "
          "points, within --texture-memory")
      ->type_name("SIDE")
      ->check(size_of_maps(bake.options));
}

void describe(CLI::App& command, Bake& bake) {
  command
      .add_option(
          "-o,--output", bake.files.output,
          "The model to write, .glb or .ply. The displacement map is written beside it, and all maps beside .ply")
      ->type_name("MODEL.glb")
      ->required();
  command.add_flag(
      "--png", bake.pictures,
      "Write the normal map and the colour map beside the model, too: MODEL.normals.png, MODEL.colours.png");
  command.add_flag("--strips", bake.strips, "With .ply: write triangle strips instead of triangles");
  command.add_flag("--object-normals", bake.object_normals,
                   "Write the normals in object space beside the model, too: MODEL.object_normals.png");
  command
      .add_option("--mesh", bake.mesh,
                  "The coarse mesh; default: a mesh or reconstruction with fewer triangles, or strips of samples of "
                  "large scans")
      ->type_name("COARSE");
  command
      .add_option(
          "--triangles", bake.coarse.triangles,
          fmt::format("The most triangles of the coarse mesh without --mesh; default {}", bake.coarse.triangles))
      ->transform(whole_above_zero())
      ->excludes("--mesh");
  describe_layout(command, bake);
  constexpr std::uint64_t least_maps = std::uint64_t{1} << 20;
  command
      .add_option("--texture-memory", bake.options.texture_memory,
                  "The most memory of the maps with mipmaps, as 64MB or 1GB; default 128MB")
      ->transform(bytes_above_zero(least_maps))
      ->excludes("--size")
      ->type_name("BYTES");
  command
      .add_option(
          "--texels-per-point", bake.options.texels_per_point,
          fmt::format("Texels for each point, up to {}; default {}", most_texels, bake.options.texels_per_point))
      ->check(above_zero(most_texels));
  command
      .add_option(
          "--noise", bake.noise,
          "The root mean square noise of the points, as a length: texels are 3.5 times as wide or more; default: "
          "measured where points are reconstructed, otherwise 0")
      ->check(between(0, 1e18));
  command
      .add_option("--reach", bake.options.reach,
                  "Leave out points farther than this from the coarse mesh; default: six times the root mean square "
                  "distance, at least a quarter of an edge")
      ->check(above_zero());
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bake", "Bake the appearance of a scan or a fine mesh onto a coarse mesh");
  const auto bake = std::make_shared<Bake>();
  describe_input(*command, bake->files, {"las", "raw"});
  describe(*command, *bake);
  describe_memory(*command, bake->memory);
  describe_threads(*command, bake->coarse.threads);
  command->add_flag("--resume", bake->resume, resume_help);
  command->callback([bake] {
    bake->coarse.memory = memory_for(bake->memory).bytes;
    run(*bake);
  });
}

}  // namespace glark::tool
