// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/maps.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <limits>

#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/scan_files.h"

namespace glark::python {
namespace {

using maps::Baked;
using maps::Jump;
using maps::SeamJumps;

// A fine mesh that keeps its arrays.
class FineArrays {
 public:
  FineArrays(const Array<float>& positions, const OptionalArray<std::uint32_t>& triangles,
             const OptionalArray<float>& normals, const OptionalArray<std::uint8_t>& colours,
             const std::array<double, 3>& origin, double spacing)
      : positions_(positions), triangles_(triangles), normals_(normals), colours_(colours), spacing_(spacing) {
    mesh_ = {.origin = origin,
             .positions = rows(positions_, 3, "positions"),
             .normals = rows(normals_, 3, "normals"),
             .colours = rows(colours_, 3, "colours"),
             .triangles = rows(triangles_, 3, "triangles")};
  }

  const maps::FineMesh& mesh() const { return mesh_; }
  double spacing() const { return spacing_; }

 private:
  Array<float> positions_;
  OptionalArray<std::uint32_t> triangles_;
  OptionalArray<float> normals_;
  OptionalArray<std::uint8_t> colours_;
  double spacing_;
  maps::FineMesh mesh_;
};

// Runs a step of glark-maps as with_files() does, whose errors of files it knows, too.
template <class Step>
auto with_models(const Step& step) {
  try {
    return with_files(step);
  } catch (const maps::Error& error) {
    if (error.element() != maps::Element::file) throw;
    throw geometry::Error(error.what());
  }
}

}  // namespace

template <>
inline constexpr bool is_bound<Jump> = true;
template <>
inline constexpr bool is_bound<SeamJumps> = true;
template <>
inline constexpr bool is_bound<Baked> = true;
template <>
inline constexpr bool is_bound<FineArrays> = true;

namespace {

stream::Source source_of(const py::object& given, const std::string& format) {
  if (py::isinstance<FineArrays>(given)) {
    const auto& fine = given.cast<const FineArrays&>();
    return maps::mesh_source(fine.mesh(), fine.spacing());
  }
  py::detail::make_caster<std::filesystem::path> file;
  if (!file.load(given, true)) {
    PyErr_Clear();
    throw ArgumentError(
        fmt::format("glark: source is of the type {}; give it the name of a file or a glark.maps.FineMesh",
                    std::string(py::str(py::type::of(given).attr("__name__")))));
  }
  return stream::file_source(py::detail::cast_op<std::filesystem::path&>(file), format);
}

// (height, width) and the channels, if there are several.
template <class T>
py::object map_of(const std::vector<T>& texels, const Baked& model, py::ssize_t channels, py::handle owner) {
  if (texels.empty()) return py::none();
  const py::array_t<T> all = view(texels, 1, owner);
  return channels == 1 ? all.attr("reshape")(model.height, model.width)
                       : all.attr("reshape")(model.height, model.width, channels);
}

void bind_seams(py::module_& module) {
  py::class_<Jump>(module, "Jump", "Differences of two sides.")
      .def_readonly("greatest", &Jump::greatest, "the greatest one")
      .def_readonly("root_mean_square", &Jump::root_mean_square, "their root mean square");
  py::class_<SeamJumps>(module, "SeamJumps", "The differences along the edges where two charts of the maps meet.")
      .def_readonly("colour", &SeamJumps::colour, "of the channel that differs most, 0 to 1")
      .def_readonly("normal", &SeamJumps::normal, "in degrees")
      .def_readonly("displacement", &SeamJumps::displacement, "in the positions' unit")
      .def_readonly("edges", &SeamJumps::edges, "the number of such edges");
}

void bind_fine_mesh(py::module_& module) {
  const auto floats = [](const py::object& s, auto values) { return view(values(s.cast<FineArrays&>().mesh()), 3, s); };
  py::class_<FineArrays>(module, "FineMesh", "A fine mesh, or points with normals, as the source of bake().")
      .def(py::init<const Array<float>&, const OptionalArray<std::uint32_t>&, const OptionalArray<float>&,
                    const OptionalArray<std::uint8_t>&, const std::array<double, 3>&, double>(),
           py::arg("positions"), py::arg("triangles") = py::none(), py::kw_only(), py::arg("normals") = py::none(),
           py::arg("colours") = py::none(), py::arg("origin") = std::array<double, 3>{},
           py::arg("spacing") = std::numeric_limits<double>::infinity(),
           "positions: (vertices, 3). triangles: (triangles, 3); without them, only the vertices are baked.\n"
           "normals: (vertices, 3), towards the outside; by default those of the triangles. colours: (vertices, 3) "
           "uint8.\n"
           "origin: added to all positions. spacing: the greatest distance of neighbouring samples of a triangle; by\n"
           "default, each triangle has samples at its corners and its centre.")
      .def_property_readonly(
          "positions", [floats](const py::object& s) { return floats(s, [](const auto& m) { return m.positions; }); },
          "(vertices, 3) float32")
      .def_property_readonly(
          "triangles", [floats](const py::object& s) { return floats(s, [](const auto& m) { return m.triangles; }); },
          "(triangles, 3) uint32")
      .def_property_readonly(
          "spacing", [](const FineArrays& fine) { return fine.spacing(); },
          "the greatest distance of neighbouring samples of a triangle");
}

void bind_arrays(py::class_<Baked>& type) {
  type.def_property_readonly(
          "positions", [](const py::object& s) { return view(s.cast<Baked&>().positions, 3, s); },
          "(vertices, 3) float32; vertices of several charts are there several times")
      .def_property_readonly(
          "normals", [](const py::object& s) { return view(s.cast<Baked&>().normals, 3, s); },
          "(vertices, 3) float32, of unit length")
      .def_property_readonly(
          "tangents", [](const py::object& s) { return view(s.cast<Baked&>().tangents, 4, s); },
          "(vertices, 4) float32: the direction of the first texture coordinate, and 1; -1 where the mesh's own "
          "coordinates "
          "are mirrored")
      .def_property_readonly(
          "texcoords", [](const py::object& s) { return view(s.cast<Baked&>().texcoords, 2, s); },
          "(vertices, 2) float32, 0 to 1; the first row of a map is at t = 0")
      .def_property_readonly(
          "triangles", [](const py::object& s) { return view(s.cast<Baked&>().triangles, 3, s); },
          "(triangles, 3) uint32, in the order of the coarse mesh")
      .def_property_readonly(
          "normal_map", [](const py::object& s) { return map_of(s.cast<Baked&>().normal_map, s.cast<Baked&>(), 3, s); },
          "(height, width, 3) uint8, in tangent space")
      .def_property_readonly(
          "colour_map", [](const py::object& s) { return map_of(s.cast<Baked&>().colour_map, s.cast<Baked&>(), 3, s); },
          "(height, width, 3) uint8, red green blue; None if the source has no colours")
      .def_property_readonly(
          "displacement_map",
          [](const py::object& s) { return map_of(s.cast<Baked&>().displacement_map, s.cast<Baked&>(), 1, s); },
          "(height, width) uint16: the height is scale * value / 65535 + bias");
}

void bind_model(py::module_& module) {
  py::class_<Baked> type(module, "Baked", "A coarse mesh with its maps.");
  bind_arrays(type);
  type.def_readonly("origin", &Baked::origin, "added to all positions")
      .def_readonly("width", &Baked::width, "of all maps; a power of two")
      .def_readonly("height", &Baked::height, "of all maps; a power of two")
      .def_readonly("scale", &Baked::scale, "the range of the heights, in the positions' unit")
      .def_readonly("bias", &Baked::bias, "the lowest height")
      .def_readonly("points", &Baked::points, "the number of points that were read")
      .def_readonly("left_out", &Baked::left_out, "points beyond the reach, or facing away from the mesh")
      .def_readonly("invalid", &Baked::invalid, "points that are not finite")
      .def_readonly("has_own_texcoords", &Baked::has_own_texcoords,
                    "whether the texture coordinates are those of the coarse mesh; then the vertices are in its order")
      .def_readonly("texcoords_fault", &Baked::texcoords_fault, "why they are not; empty: they are, or were not to be")
      .def_readonly("charts", &Baked::charts, "the number of charts or islands")
      .def_readonly("empty_charts", &Baked::empty_charts, "charts without any point; they stay flat")
      .def_readonly("hard_edges", &Baked::hard_edges, "edges of the coarse mesh that are creases of the fine surface")
      .def_readonly("texels", &Baked::texels, "texels of charts")
      .def_readonly("filled", &Baked::filled, "texels that got their values by diffusion")
      .def_readonly("reach", &Baked::reach, "the reach that was used")
      .def_readonly("seams", &Baked::seams, "the differences along the seams of charts, in the first mipmap level")
      .def_readonly("mip_seams", &Baked::mip_seams, "a list: in the second mipmap level and the third one");
}

maps::Texcoords texcoords_of(const std::string& word) {
  if (word == "auto") return maps::Texcoords::automatic;
  if (word == "own") return maps::Texcoords::own;
  if (word == "charts") return maps::Texcoords::charts;
  throw ArgumentError(fmt::format("glark: texture_coordinates is \"{}\"; give \"auto\", \"own\" or \"charts\"", word));
}

void bind_bake(py::module_& module) {
  const maps::BakeOptions defaults;
  module.def(
      "bake",
      [](const Array<float>& positions, const Array<std::uint32_t>& triangles, const py::object& source,
         const OptionalArray<float>& normals, const std::array<double, 3>& origin, const std::string& format,
         const Whole<std::size_t>& texture_memory, const Whole<unsigned>& most_side, double noise,
         double texels_per_point, double reach, bool skip_invalid, const Whole<unsigned>& threads,
         const OptionalArray<float>& texcoords, const std::string& texture_coordinates,
         const std::array<unsigned, 2>& size, const std::filesystem::path& work, bool resume) {
        const maps::CoarseMesh mesh{.origin = origin,
                                    .positions = rows(positions, 3, "positions"),
                                    .normals = rows(normals, 3, "normals"),
                                    .triangles = rows(triangles, 3, "triangles"),
                                    .texcoords = rows(texcoords, 2, "texcoords")};
        maps::BakeOptions options;
        options.texcoords = texcoords_of(texture_coordinates);
        options.width = size[0];
        options.height = size[1];
        options.texture_memory = texture_memory.checked("texture_memory");
        options.most_side = most_side.checked("most_side");
        options.noise = noise;
        options.texels_per_point = texels_per_point;
        options.reach = reach;
        options.skip_invalid = skip_invalid;
        options.threads = threads.checked("threads");
        options.work = work;
        options.resume = resume;
        options.progress = &stop_for_signals;
        const stream::Source points = source_of(source, format);
        return with_models([&] { return maps::bake(mesh, points, options); });
      },
      py::arg("positions"), py::arg("triangles"), py::arg("source"), py::kw_only(), py::arg("normals") = py::none(),
      py::arg("origin") = std::array<double, 3>{}, py::arg("format") = "",
      py::arg("texture_memory") = defaults.texture_memory, py::arg("most_side") = defaults.most_side,
      py::arg("noise") = defaults.noise, py::arg("texels_per_point") = defaults.texels_per_point,
      py::arg("reach") = defaults.reach, py::arg("skip_invalid") = false, py::arg("threads") = 0,
      py::arg("texcoords") = py::none(), py::arg("texture_coordinates") = "auto",
      py::arg("size") = std::array<unsigned, 2>{}, py::arg("work") = "", py::arg("resume") = false,
      "Bake the appearance of `source` into a normal map, a colour map and a displacement map of a coarse mesh.\n\n"
      "positions: (vertices, 3). triangles: (triangles, 3), counter-clockwise from outside. normals: (vertices, 3); "
      "by\n"
      "default those of the triangles. origin: added to all positions.\n"
      "source: the name of a scan of any size, in `format` or that of the name; or a FineMesh.\n"
      "texture_memory: bytes of all maps with their mipmaps. most_side: the greatest width and height.\n"
      "noise: the root mean square noise of the points; texels are 3.5 times as wide or more.\n"
      "reach: points farther from the mesh are left out; 0: by the distances of the points.\n"
      "texcoords: (vertices, 2), of the coarse mesh; (0, 0) is the lower left texel. texture_coordinates: \"own\" "
      "keeps\n"
      "them, \"charts\" makes new ones, \"auto\" keeps them if each triangle has a place of its own within 0 to 1.\n"
      "size: width and height of the maps, powers of two; (0, 0): by the number of points.\n"
      "work: a folder for the state of the work, from which a killed run continues with resume=True. Remove it when "
      "the\n"
      "model is written.");
}

}  // namespace

void bind_maps(py::module_& module) {
  py::module_ maps_module =
      module.def_submodule("maps", "Normal, colour and displacement maps of a coarse mesh, baked from a scan.");
  bind_seams(maps_module);
  bind_fine_mesh(maps_module);
  bind_model(maps_module);
  bind_bake(maps_module);
  maps_module.def(
      "write_model",
      [](const std::filesystem::path& file, const Baked& model) {
        with_models([&] { maps::write_model(file, model); });
      },
      py::arg("file"), py::arg("model"),
      "Write a model as binary glTF, and its displacement map beside it: model.displacement.png for model.glb.");
  maps_module.def(
      "write_ply",
      [](const std::filesystem::path& file, const Baked& model, bool strips) {
        with_models([&] { maps::write_ply(file, model, strips); });
      },
      py::arg("file"), py::arg("model"), py::kw_only(), py::arg("strips") = false,
      "Write a model as PLY, and its maps beside it: model.normals.png, model.displacement.png and model.colours.png "
      "for\n"
      "model.ply. strips: triangle strips instead of triangles.");
}

}  // namespace glark::python
