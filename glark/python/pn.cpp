// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/pn.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<pn::TaggedMesh> = true;
namespace {

using pn::TaggedMesh;

py::object sources_of(const py::object& self) {
  const auto& sources = self.cast<TaggedMesh&>().sources;
  return view(std::span(sources.empty() ? nullptr : sources.front().data(), 2 * sources.size()), 2, self);
}

void bind_tagged_mesh(py::module_& module) {
  py::class_<TaggedMesh>(module, "TaggedMesh", "A mesh with the tags of GL_SCALAR_TAGGED_PN_ARK.")
      .def_property_readonly(
          "positions", [](const py::object& s) { return view(s.cast<TaggedMesh&>().positions, 3, s); },
          "(vertices, 3) float32")
      .def_property_readonly(
          "normals", [](const py::object& s) { return view(s.cast<TaggedMesh&>().normals, 3, s); },
          "(vertices, 3) float32, of unit length")
      .def_property_readonly(
          "discontinuities", [](const py::object& s) { return view(s.cast<TaggedMesh&>().discontinuities, 4, s); },
          "(vertices, 4): Delta and the number of the crease")
      .def_property_readonly(
          "tags", [](const py::object& s) { return view(s.cast<TaggedMesh&>().tags, 3, s); },
          "(vertices, 3): sharpness, tension, bias")
      .def_property_readonly(
          "triangles", [](const py::object& s) { return view(s.cast<TaggedMesh&>().triangles, 3, s); },
          "(triangles, 3) uint32: indices of vertices")
      .def_property_readonly("sources", &sources_of,
                             "(vertices, 2): each vertex lies half-way between these two vertices of the mesh")
      .def_property_readonly(
          "triangle_sources", [](const py::object& s) { return view(s.cast<TaggedMesh&>().triangle_sources, 1, s); },
          "(triangles,) uint32: the original triangle of each")
      .def_readonly("crease_vertices", &TaggedMesh::crease_vertices, "the number of points with two normals")
      .def_readonly("corners", &TaggedMesh::corners, "the number of points where several creases meet");
}

}  // namespace

void bind_pn(py::module_& parent) {
  py::module_ module = parent.def_submodule("pn", "Scalar-tagged PN triangles.");
  bind_tagged_mesh(module);
  const pn::Options defaults;
  module.def(
      "derive_tags",
      [](const Array<float>& positions, const Array<std::uint32_t>& triangles, const OptionalArray<float>& normals,
         const OptionalArray<std::uint32_t>& creases, float crease_degrees, float sharpness, float tension, float bias,
         bool split) {
        const pn::Mesh mesh{.positions = rows(positions, 3, "positions"),
                            .triangles = rows(triangles, 3, "triangles"),
                            .normals = rows(normals, 3, "normals"),
                            .creases = rows(creases, 2, "creases")};
        const pn::Options options{crease_degrees, sharpness, tension, bias, split};
        return without_gil([&] { return pn::derive_tags(mesh, options); });
      },
      py::arg("positions"), py::arg("triangles"), py::arg("normals") = py::none(), py::arg("creases") = py::none(),
      py::kw_only(), py::arg("crease_degrees") = defaults.crease_degrees, py::arg("sharpness") = defaults.sharpness,
      py::arg("tension") = defaults.tension, py::arg("bias") = defaults.bias, py::arg("split") = defaults.split,
      "Tags for a mesh with hard edges. creases: (creases, 2), the ends of each sharp edge.");
}

}  // namespace glark::python
