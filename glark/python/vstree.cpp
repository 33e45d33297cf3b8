// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/vstree.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<vstree::Simplified> = true;
template <>
inline constexpr bool is_bound<vstree::Tree> = true;
namespace {

using vstree::Clustering;
using vstree::Method;
using vstree::Metric;
using vstree::Representative;
using vstree::Simplified;
using vstree::Tree;

constexpr std::array metrics = {std::pair{"l2", Metric::l2}, std::pair{"l21", Metric::l21},
                                std::pair{"qef", Metric::qef}, std::pair{"density", Metric::density}};
constexpr std::array clusterings = {std::pair{"vstree", Clustering::volume_surface},
                                    std::pair{"octree", Clustering::octree}, std::pair{"grid", Clustering::grid}};
constexpr std::array representatives = {std::pair{"qef", Representative::qef},
                                        std::pair{"centroid", Representative::centroid}};
constexpr std::array methods = {std::pair{"cluster", Method::cluster}, std::pair{"collapse", Method::collapse},
                                std::pair{"automatic", Method::automatic}};

std::unique_ptr<Tree> make_tree(const Array<float>& positions, const OptionalArray<float>& normals, bool surface,
                                const std::string& metric, float threshold, float delta_a, float delta_d,
                                const Whole<std::uint32_t>& least_samples, const Whole<std::uint32_t>& most_leaves,
                                const Whole<unsigned>& threads) {
  const vstree::PointSet points{.positions = rows(positions, 3, "positions"), .normals = rows(normals, 3, "normals")};
  const vstree::Options options{surface,
                                named(metric, "metric", metrics),
                                threshold,
                                delta_a,
                                delta_d,
                                least_samples.checked("least_samples"),
                                most_leaves.checked("most_leaves"),
                                threads.checked("threads")};
  return without_gil([&] { return std::make_unique<Tree>(points, options); });
}

void bind_tree(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(vstree::Node, begin, end, first_child, frame, error, kind, level, children, joined);
  PYBIND11_NUMPY_DTYPE(vstree::Frame, origin, u, v, normal, low, size, node);
  py::class_<Tree>(module, "Tree", "A volume-surface tree over samples of a surface.")
      .def(py::init(&make_tree), py::arg("positions"), py::arg("normals") = py::none(), py::kw_only(),
           py::arg("surface") = true, py::arg("metric") = "l2", py::arg("threshold") = 1e-4F, py::arg("delta_a") = 0.0F,
           py::arg("delta_d") = 0.25F, py::arg("least_samples") = 1, py::arg("most_leaves") = 0, py::arg("threads") = 0,
           "positions: (points, 3). normals: (points, 3); estimated if they are missing.\n"
           "metric: 'l2', 'l21', 'qef' or 'density'. threshold: a node with this error or less is a leaf; relative to "
           "the\n"
           "diagonal of the bounding box. most_leaves: if not 0, replaces the threshold. threads: 0 for all.")
      .def_property_readonly(
          "nodes", [](const py::object& self) { return view(self.cast<Tree&>().nodes(), 1, self); },
          "(nodes,) records: begin, end, first_child, frame, error, kind, level, children, joined. The root is the "
          "first;\n"
          "a leaf has first_child 0. kind: 0 volume, 1 transition, 2 surface")
      .def_property_readonly(
          "frames", [](const py::object& self) { return view(self.cast<Tree&>().frames(), 1, self); },
          "(frames,) records: origin, u, v, normal, low, size, node")
      .def_property_readonly(
          "order", [](const py::object& self) { return view(self.cast<Tree&>().order(), 1, self); },
          "(points,) uint32: node i has the samples order[begin:end]")
      .def_property_readonly("leaf_count", &Tree::leaf_count, "the number of leaves")
      .def_property_readonly("bytes", &Tree::bytes, "the memory of the tree")
      .def_property_readonly("diagonal", &Tree::diagonal, "the diagonal of the bounding box, in the positions' unit")
      .def(
          "leaf_of",
          [](const Tree& tree, const std::array<float, 3>& position) -> std::optional<std::uint32_t> {
            const std::uint32_t leaf = tree.leaf_of(position);
            return leaf == vstree::none ? std::nullopt : std::optional(leaf);
          },
          py::arg("position"), "The index of the leaf that has the position, or None outside of the root.");
}

void bind_simplified(py::module_& module) {
  py::class_<Simplified>(module, "Simplified", "The result of simplify(). An attribute that the input lacks is None.")
      .def_property_readonly(
          "positions", [](const py::object& s) { return view(s.cast<Simplified&>().positions, 3, s); },
          "(vertices, 3) float32")
      .def_property_readonly(
          "normals", [](const py::object& s) { return view(s.cast<Simplified&>().normals, 3, s); },
          "(vertices, 3) float32, of unit length")
      .def_property_readonly(
          "colours", [](const py::object& s) { return view_or_none(s.cast<Simplified&>().colours, 3, s); },
          "(vertices, 3) float32, 0 to 1, or None")
      .def_property_readonly(
          "texcoords", [](const py::object& s) { return view_or_none(s.cast<Simplified&>().texcoords, 2, s); },
          "(vertices, 2) float32, or None")
      .def_property_readonly(
          "triangles", [](const py::object& s) { return view_or_none(s.cast<Simplified&>().triangles, 3, s); },
          "(triangles, 3) uint32: indices of vertices; None for points")
      .def_property_readonly(
          "representatives", [](const py::object& s) { return view(s.cast<Simplified&>().representatives, 1, s); },
          "(points of the input,) uint32: the vertex of each point; 0xFFFFFFFF if no triangle uses the point")
      .def_property_readonly(
          "method", [](const Simplified& s) { return s.method == Method::collapse ? "collapse" : "cluster"; },
          "the method that was used: 'cluster' or 'collapse'")
      .def_readonly("error", &Simplified::error, "collapse: the estimated error, relative to the diagonal");
}

void bind_estimate_normals(py::module_& module) {
  module.def(
      "estimate_normals",
      [](const Array<float>& positions, const OptionalArray<float>& normals, const Whole<unsigned>& neighbours,
         const std::optional<std::array<float, 3>>& scanner, const Whole<unsigned>& threads) {
        const vstree::PointSet points{.positions = rows(positions, 3, "positions"),
                                      .normals = rows(normals, 3, "normals")};
        const vstree::NormalOptions options{neighbours.checked("neighbours"), scanner ? &*scanner : nullptr,
                                            threads.checked("threads")};
        return owned(without_gil([&] { return vstree::estimate_normals(points, options); }), 3);
      },
      py::arg("positions"), py::arg("normals") = py::none(), py::kw_only(), py::arg("neighbours") = 16,
      py::arg("scanner") = py::none(), py::arg("threads") = 0,
      "Unit normals, (points, 3). Normals that are given and not zero are kept.\n\n"
      "neighbours: 3 to 256. scanner: the position to which normals point; without it, they agree with their "
      "neighbours.");
}

Simplified simplify(const Array<float>& positions, const OptionalArray<std::uint32_t>& triangles,
                    const OptionalArray<float>& normals, const OptionalArray<std::uint8_t>& colours,
                    const OptionalArray<float>& texcoords, const Whole<std::size_t>& target,
                    const std::string& clustering, const std::string& representative, const std::string& metric,
                    float threshold, float delta_a, float delta_d, bool cut, const Whole<unsigned>& threads,
                    const std::string& method, float max_error) {
  const vstree::Mesh mesh{.points = {.positions = rows(positions, 3, "positions"),
                                     .normals = rows(normals, 3, "normals"),
                                     .colours = rows(colours, 3, "colours"),
                                     .texcoords = rows(texcoords, 2, "texcoords")},
                          .triangles = rows(triangles, 3, "triangles")};
  const vstree::SimplifyOptions options{named(clustering, "clustering", clusterings),
                                        named(representative, "representative", representatives),
                                        target.checked("target"),
                                        named(metric, "metric", metrics),
                                        threshold,
                                        delta_a,
                                        delta_d,
                                        cut,
                                        threads.checked("threads"),
                                        named(method, "method", methods),
                                        max_error};
  return without_gil([&] { return vstree::simplify(mesh, options); });
}

void bind_simplify(py::module_& module) {
  module.def(
      "simplify", &simplify, py::arg("positions"), py::arg("triangles") = py::none(), py::arg("normals") = py::none(),
      py::arg("colours") = py::none(), py::arg("texcoords") = py::none(), py::kw_only(), py::arg("target") = 0,
      py::arg("clustering") = "vstree", py::arg("representative") = "qef", py::arg("metric") = "l2",
      py::arg("threshold") = 1e-4F, py::arg("delta_a") = 0.0F, py::arg("delta_d") = 0.25F, py::arg("cut") = true,
      py::arg("threads") = 0, py::arg("method") = "cluster", py::arg("max_error") = 0.0F,
      "Fewer triangles, or fewer points where there are no triangles.\n\n"
      "target: the most triangles or points; 0: threshold is used, relative to the diagonal of the bounding box.\n"
      "clustering: 'vstree', 'octree' or 'grid'. representative: 'qef' or 'centroid'.\n"
      "method: 'cluster', 'collapse' or 'automatic': collapse below 200000 triangles. max_error: collapse stops before "
      "the\n"
      "estimated error is greater, relative to the diagonal; 0: no limit.");
}

}  // namespace

void bind_vstree(py::module_& parent) {
  py::module_ module = parent.def_submodule("vstree", "Volume-surface trees, normals of points, simplification.");
  bind_tree(module);
  bind_simplified(module);
  bind_estimate_normals(module);
  bind_simplify(module);
}

}  // namespace glark::python
