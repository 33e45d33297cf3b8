// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/reconstruct.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<reconstruct::Reconstructed> = true;

using reconstruct::Reconstructed;

namespace {

void bind_reconstructed(py::module_& module) {
  py::class_<Reconstructed>(module, "Reconstructed", "A mesh from points.")
      .def_property_readonly(
          "positions", [](const py::object& s) { return view(s.cast<Reconstructed&>().positions, 3, s); },
          "(vertices, 3) float32; those of the coarse mesh come first")
      .def_property_readonly(
          "normals", [](const py::object& s) { return view(s.cast<Reconstructed&>().normals, 3, s); },
          "(vertices, 3) float32, of unit length")
      .def_property_readonly(
          "colours", [](const py::object& s) { return view_or_none(s.cast<Reconstructed&>().colours, 3, s); },
          "(vertices, 3) float32, 0 to 1; None if the points have none")
      .def_property_readonly(
          "triangles", [](const py::object& s) { return view(s.cast<Reconstructed&>().triangles, 3, s); },
          "(triangles, 3) uint32: indices of vertices")
      .def_readonly("base_vertices", &Reconstructed::base_vertices, "the number of vertices of the coarse mesh")
      .def_readonly("base_triangles", &Reconstructed::base_triangles, "the number of triangles of the coarse mesh")
      .def_readonly("levels", &Reconstructed::levels, "how often the coarse mesh was refined")
      .def_readonly("node_side", &Reconstructed::node_side,
                    "the side of the finest transition nodes, in the positions' unit")
      .def_readonly("noise", &Reconstructed::noise, "root mean square distance of the samples from the nodes' planes")
      .def_readonly("left_out", &Reconstructed::left_out, "the number of parts that were left out")
      .def_readonly("area_left_out", &Reconstructed::area_left_out, "their share of the area of all parts, 0 to 1")
      .def_readonly("outliers", &Reconstructed::outliers, "the number of points on no surface, which were left out");
}

}  // namespace

void bind_reconstruct(py::module_& module) {
  bind_reconstructed(module);
  const reconstruct::ReconstructOptions defaults;
  module.def(
      "reconstruct",
      [](const Array<float>& positions, const OptionalArray<float>& normals, const OptionalArray<std::uint8_t>& colours,
         float threshold, float error, const Whole<unsigned>& levels, float node_samples, float delta_a, float delta_d,
         float least_part, const Whole<std::uint32_t>& gap_edges, const Whole<unsigned>& threads) {
        const vstree::PointSet points{.positions = rows(positions, 3, "positions"),
                                      .normals = rows(normals, 3, "normals"),
                                      .colours = rows(colours, 3, "colours")};
        const reconstruct::ReconstructOptions options{threshold,
                                                      error,
                                                      levels.checked("levels"),
                                                      node_samples,
                                                      delta_a,
                                                      delta_d,
                                                      least_part,
                                                      gap_edges.checked("gap_edges"),
                                                      threads.checked("threads")};
        return without_gil([&] { return reconstruct::reconstruct(points, options); });
      },
      py::arg("positions"), py::arg("normals") = py::none(), py::arg("colours") = py::none(), py::kw_only(),
      py::arg("threshold") = defaults.threshold, py::arg("error") = defaults.error, py::arg("levels") = defaults.levels,
      py::arg("node_samples") = defaults.node_samples, py::arg("delta_a") = defaults.delta_a,
      py::arg("delta_d") = defaults.delta_d, py::arg("least_part") = defaults.least_part,
      py::arg("gap_edges") = defaults.gap_edges, py::arg("threads") = 0,
      "A mesh from points.\n\n"
      "positions: (points, 3). normals: (points, 3), towards the outside; estimated if they are missing.\n"
      "error: how near the mesh is to the samples, relative to the diagonal; 0: as dense as the samples.\n"
      "levels: the most levels of refinement, 0 to 6. least_part: parts with less of the area are left out.");
}

}  // namespace glark::python
