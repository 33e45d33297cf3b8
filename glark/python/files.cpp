// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "glark/clients/geometry/formats.h"
#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/text.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<geometry::Geometry> = true;
namespace {

using geometry::Geometry;

void require_name(const std::filesystem::path& file) {
  if (file.empty()) throw ArgumentError("glark: the name of the file is empty; name a file");
}

Geometry read(const std::filesystem::path& file, bool skip_invalid, const std::string& format) {
  require_name(file);
  geometry::Reading reading =
      without_gil([&] { return geometry::read_file(file, {.skip_invalid = skip_invalid, .format = format}); });
  for (const std::string& warning : reading.warnings) {
    if (PyErr_WarnFormat(PyExc_UserWarning, 1, "%U", text_of(warning).ptr()) != 0) throw py::error_already_set();
  }
  return std::move(reading.geometry);
}

// Colours may have three or four columns.
std::vector<std::uint8_t> with_alpha(const OptionalArray<std::uint8_t>& colours) {
  if (!colours) return {};
  if (const auto& given = colours->checked("colours"); given.ndim() == 2 && given.shape(1) == 4) {
    const auto all = rows(*colours, 4, "colours");
    return {all.begin(), all.end()};
  }
  const auto rgb = rows(*colours, 3, "colours");
  std::vector<std::uint8_t> rgba;
  rgba.reserve(rgb.size() / 3 * 4);
  for (std::size_t i = 0; i < rgb.size(); i += 3) rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
  return rgba;
}

template <class T>
std::vector<T> copied(std::span<const T> values) {
  return {values.begin(), values.end()};
}

// Throws ArgumentError if an attribute has another number of points.
void require_points(std::size_t found, std::size_t points, const char* name) {
  if (found != 0 && found != points) {
    throw ArgumentError(fmt::format("glark: {} has {} rows for {} points; give it as many", name, found, points));
  }
}

// Throws ArgumentError for a coordinate that the readers refuse.
void require_finite(std::span<const float> positions) {
  const auto bad = std::ranges::find_if(positions, [](float x) { return !std::isfinite(x); });
  if (bad == positions.end()) return;
  throw ArgumentError(fmt::format("glark: positions has the coordinate {} in row {}; remove the point", *bad,
                                  (bad - positions.begin()) / 3));
}

Geometry geometry_of(const Array<float>& positions, const OptionalArray<float>& normals,
                     const OptionalArray<std::uint8_t>& colours, const OptionalArray<float>& texcoords,
                     const OptionalArray<std::uint32_t>& triangles, const std::array<double, 3>& origin) {
  Geometry result;
  result.origin = origin;
  result.positions = copied(rows(positions, 3, "positions"));
  require_finite(result.positions);
  result.normals = copied(rows(normals, 3, "normals"));
  result.colours = with_alpha(colours);
  result.texture_coordinates = copied(rows(texcoords, 2, "texcoords"));
  result.triangles = copied(rows(triangles, 3, "triangles"));
  const std::size_t points = result.point_count();
  require_points(result.normals.size() / 3, points, "normals");
  require_points(result.colours.size() / 4, points, "colours");
  require_points(result.texture_coordinates.size() / 2, points, "texcoords");
  for (const std::uint32_t index : result.triangles) {
    if (index >= points) {
      throw ArgumentError(
          fmt::format("glark: triangles has the index {}, but there are {} points; correct it", index, points));
    }
  }
  return result;
}

}  // namespace

void bind_files(py::module_& module) {
  py::class_<Geometry>(module, "Geometry", "Points with attributes, and triangles if there are any.")
      .def_property_readonly(
          "positions", [](const py::object& self) { return view(self.cast<Geometry&>().positions, 3, self); },
          "(points, 3) float32, relative to the origin")
      .def_property_readonly(
          "normals", [](const py::object& self) { return view_or_none(self.cast<Geometry&>().normals, 3, self); },
          "(points, 3) float32, or None")
      .def_property_readonly(
          "colours", [](const py::object& self) { return view_or_none(self.cast<Geometry&>().colours, 4, self); },
          "(points, 4) uint8: red, green, blue, alpha; or None")
      .def_property_readonly(
          "texcoords",
          [](const py::object& self) { return view_or_none(self.cast<Geometry&>().texture_coordinates, 2, self); },
          "(points, 2) float32, or None")
      .def_property_readonly(
          "triangles", [](const py::object& self) { return view_or_none(self.cast<Geometry&>().triangles, 3, self); },
          "(triangles, 3) uint32, or None for points")
      .def_readonly("origin", &Geometry::origin, "three floats of double precision, to be added to the positions");
  module.def("read", &read, py::arg("file"), py::kw_only(), py::arg("skip_invalid") = false, py::arg("format") = "",
             "Read PLY, OBJ, STL, OFF, glTF, PCD, XYZ or PTS, also compressed by zstd. The ending of the name gives "
             "the format.\n\n"
             "skip_invalid: leave out points with NaN or infinite coordinates, instead of raising FileError.\n"
             "format: 'ply', for example; by default that of the name.\n"
             "What the format has and glark does not keep becomes a warning.");
  module.def(
      "write",
      [](const std::filesystem::path& file, const Array<float>& positions, const OptionalArray<float>& normals,
         const OptionalArray<std::uint8_t>& colours, const OptionalArray<float>& texcoords,
         const OptionalArray<std::uint32_t>& triangles, const std::array<double, 3>& origin, bool text) {
        require_name(file);
        const Geometry geometry = geometry_of(positions, normals, colours, texcoords, triangles, origin);
        without_gil([&] { geometry::write_file(file, geometry, {.text = text}); });
      },
      py::arg("file"), py::arg("positions"), py::arg("normals") = py::none(), py::arg("colours") = py::none(),
      py::arg("texcoords") = py::none(), py::arg("triangles") = py::none(), py::kw_only(),
      py::arg("origin") = std::array<double, 3>{}, py::arg("text") = false,
      "Write PLY, OBJ, STL, XYZ, PTS or GLB. The file is complete or not there.\n\n"
      "positions: (points, 3). normals: (points, 3). colours: (points, 3) or (points, 4) uint8. texcoords: (points, "
      "2).\n"
      "triangles: (triangles, 3) indices of points. text: PLY as text.");
}

}  // namespace glark::python
