// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/depth.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/guarded.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<Guarded<depth::Tagger>> = true;
namespace {

using Tagger = Guarded<depth::Tagger>;  // metrics keep what they have measured

// Lets `fill` write one tag for each vertex.
template <class Fill>
py::array_t<float> tags_by(Tagger& tagger, const Fill& fill) {
  std::vector<float> tags(tagger.fixed().vertices());
  tagger.change([&](depth::Tagger& metrics) { fill(metrics, std::span<float>(tags)); });
  return owned(std::move(tags), 1);
}

depth::View view_of(const std::array<float, 3>& eye, float pixels_at_one, float nearest) {
  return {.eye = eye, .pixels_at_one = pixels_at_one, .nearest = nearest};
}

depth::EdgeRule rule_of(bool geomorph) { return geomorph ? depth::EdgeRule::geomorph : depth::EdgeRule::rounded; }

py::array_t<float> by_curvature(Tagger& tagger, const Array<float>& positions, float tolerance,
                                const OptionalArray<float>& normals) {
  const auto points = rows(positions, 3, "positions");
  const auto given = rows(normals, 3, "normals");
  return tags_by(tagger, [&](auto& metrics, auto tags) { metrics.by_curvature(points, given, tolerance, tags); });
}

py::array_t<float> by_curvature_on_screen(Tagger& tagger, const Array<float>& positions, float pixels,
                                          const std::array<float, 3>& eye, float pixels_at_one,
                                          const OptionalArray<float>& normals, float nearest) {
  const auto points = rows(positions, 3, "positions");
  const auto given = rows(normals, 3, "normals");
  const depth::View from = view_of(eye, pixels_at_one, nearest);
  return tags_by(tagger, [&](auto& metrics, auto tags) { metrics.by_curvature(points, given, from, pixels, tags); });
}

py::array_t<float> by_displacement(Tagger& tagger, const Array<float>& texcoords, const Array<float>& heights,
                                   float tolerance) {
  const auto& image = heights.checked("heights");
  if (image.ndim() != 2) {
    throw ArgumentError("glark: heights is no image; give it the shape (height, width)");
  }
  const auto coordinates = rows(texcoords, 2, "texcoords");
  const depth::HeightMap map{.heights = {image.data(), static_cast<std::size_t>(image.size())},
                             .width = static_cast<std::uint32_t>(image.shape(1)),
                             .height = static_cast<std::uint32_t>(image.shape(0))};
  return tags_by(tagger, [&](auto& metrics, auto tags) { metrics.by_displacement(coordinates, map, tolerance, tags); });
}

auto by_distance(Tagger& tagger, const Array<float>& positions, const std::array<float, 3>& point, float nearest,
                 float farthest, float finest, float coarsest) {
  const auto points = rows(positions, 3, "positions");
  return tags_by(tagger, [&](auto& metrics, auto tags) {
    metrics.by_distance(points, {point, nearest, farthest, finest, coarsest}, tags);
  });
}

auto by_edge_length(Tagger& tagger, const Array<float>& positions, float pixels, const std::array<float, 3>& eye,
                    float pixels_at_one, float nearest) {
  const auto points = rows(positions, 3, "positions");
  const depth::View from = view_of(eye, pixels_at_one, nearest);
  return tags_by(tagger, [&](auto& metrics, auto tags) { metrics.by_edge_length(points, from, pixels, tags); });
}

auto refined_triangles(const Tagger& tagger, const Array<float>& tags, bool geomorph) {
  const auto given = rows(tags, 1, "tags");
  return tagger.read([&](const auto& metrics) { return metrics.refined_triangles(given, rule_of(geomorph)); });
}

py::tuple keep_budget(const Tagger& tagger, const Array<float>& tags, const Whole<std::uint64_t>& most, bool geomorph) {
  const std::uint64_t triangles = most.checked("triangles");
  const auto given = rows(tags, 1, "tags");
  std::vector<float> kept(given.begin(), given.end());
  const depth::Budget budget = tagger.read(
      [&](const depth::Tagger& metrics) { return metrics.keep_budget(triangles, kept, rule_of(geomorph)); });
  return py::make_tuple(owned(std::move(kept), 1), budget.triangles, budget.kept);
}

}  // namespace

void bind_depth(py::module_& parent) {
  py::module_ module = parent.def_submodule("depth", "Depth tags by metrics, for glDepthTagPointerARK.");
  const depth::DistanceRange range;
  py::class_<Tagger>(module, "Tagger",
                     "Computes tags for the vertices of one mesh: (vertices,) float32, 0 to max_level.")
      .def(py::init([](const Whole<std::size_t>& vertices, const Array<std::uint32_t>& triangles,
                       const Whole<unsigned>& max_level) {
             return std::make_unique<Tagger>(vertices.checked("vertices"), rows(triangles, 3, "triangles"),
                                             max_level.checked("max_level"));
           }),
           py::arg("vertices"), py::arg("triangles"), py::arg("max_level"),
           "vertices: their number. triangles: (triangles, 3). max_level: 0 to 11.")
      .def_property_readonly(
          "vertices", [](const Tagger& tagger) { return tagger.fixed().vertices(); }, "the number of vertices")
      .def_property_readonly(
          "max_level", [](const Tagger& tagger) { return tagger.fixed().max_level(); }, "the deepest tag, 0 to 15")
      .def("by_distance", &by_distance, py::arg("positions"), py::arg("point"), py::kw_only(),
           py::arg("nearest") = range.nearest, py::arg("farthest") = range.farthest, py::arg("finest") = range.finest,
           py::arg("coarsest") = range.coarsest,
           "Tags fall linearly from finest to coarsest between two distances from a point.")
      .def("by_edge_length", &by_edge_length, py::arg("positions"), py::arg("pixels"), py::arg("eye"),
           py::arg("pixels_at_one"), py::kw_only(), py::arg("nearest") = 0.01F,
           "No segment of an edge is longer than `pixels`. pixels_at_one: height / (2 tan(field_of_view / 2)).")
      .def("by_curvature", &by_curvature, py::arg("positions"), py::arg("tolerance"), py::arg("normals") = py::none(),
           "Segments are closer than the tolerance to the arc of the larger principal curvature, in units of the mesh.")
      .def("by_curvature_on_screen", &by_curvature_on_screen, py::arg("positions"), py::arg("pixels"), py::arg("eye"),
           py::arg("pixels_at_one"), py::arg("normals") = py::none(), py::kw_only(), py::arg("nearest") = 0.01F,
           "As by_curvature, with a tolerance in pixels.")
      .def("by_displacement", &by_displacement, py::arg("texcoords"), py::arg("heights"), py::arg("tolerance"),
           "texcoords: (vertices, 2). heights: (height, width), the first row at v = 0.")
      .def("refined_triangles", &refined_triangles, py::arg("tags"), py::arg("geomorph") = false,
           "The number of triangles that the extension draws.")
      .def("keep_budget", &keep_budget, py::arg("tags"), py::arg("triangles"), py::arg("geomorph") = false,
           "Lowers all tags so that at most `triangles` are drawn. Returns the tags, the number, and whether it fits.");
}

}  // namespace glark::python
