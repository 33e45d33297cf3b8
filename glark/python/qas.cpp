// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/qas.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/guarded.h"

namespace glark::python {

namespace {
struct Loop;
}
template <>
inline constexpr bool is_bound<Guarded<qas::Surface>> = true;
template <>
inline constexpr bool is_bound<Loop> = true;
namespace {

using qas::LoopSurface;
using Surface = Guarded<qas::Surface>;

constexpr std::array schemes = {std::pair{"loop", qas::Scheme::loop},
                                std::pair{"butterfly", qas::Scheme::modified_butterfly}};

qas::Mesh mesh_of(const Whole<std::size_t>& vertices, const Array<std::uint32_t>& triangles,
                  const OptionalArray<std::uint32_t>& creases) {
  return {.vertex_count = vertices.checked("vertices"),
          .triangles = rows(triangles, 3, "triangles"),
          .creases = rows(creases, 2, "creases")};
}

py::array_t<float> vectors(std::span<const qas::Vector> values, py::handle owner) {
  return view(std::span(reinterpret_cast<const float*>(values.data()), 4 * values.size()), 4, owner);
}

// `Corner` consists of floats only.
template <class Corner, class Write>
py::array_t<float> corners(std::size_t count, const Write& write) {
  constexpr std::size_t numbers = sizeof(Corner) / sizeof(float);
  std::vector<float> result(numbers * count);
  write(std::span(reinterpret_cast<Corner*>(result.data()), count));
  return owned(std::move(result), numbers);
}

py::tuple sample_of(const qas::Sample& sample) { return py::make_tuple(sample.position, sample.normal); }

// LoopSurface does not tell its number of triangles.
struct Loop {
  Guarded<LoopSurface> surface;
  std::size_t triangles;

  explicit Loop(const qas::Mesh& mesh) : surface(mesh), triangles(mesh.triangles.size() / 3) {}
};

py::tuple refine(const Loop& loop, const Whole<unsigned>& wanted, const Whole<unsigned>& threads) {
  const unsigned level = wanted.checked("level"), most_threads = threads.checked("threads");
  const std::size_t side = (std::size_t{1} << std::min(level, 11U)) + 1;
  std::vector<qas::Sample> samples(loop.triangles * side * (side + 1) / 2);
  loop.surface.read([&](const auto& surface) { surface.refine(level, samples, most_threads); });
  std::vector<float> positions;
  std::vector<float> normals;
  positions.reserve(3 * samples.size());
  normals.reserve(3 * samples.size());
  for (const qas::Sample& sample : samples) {
    positions.insert(positions.end(), sample.position.begin(), sample.position.end());
    normals.insert(normals.end(), sample.normal.begin(), sample.normal.end());
  }
  return py::make_tuple(owned(std::move(positions), 3), owned(std::move(normals), 3));
}

std::unique_ptr<Surface> make_surface(const Whole<std::size_t>& vertices, const Array<std::uint32_t>& triangles,
                                      const OptionalArray<std::uint32_t>& creases, const std::string& scheme,
                                      const Whole<unsigned>& splits, const Whole<unsigned>& threads) {
  const qas::Mesh mesh = mesh_of(vertices, triangles, creases);
  const qas::Options options{named(scheme, "scheme", schemes), splits.checked("splits"), threads.checked("threads")};
  return without_gil([&] { return std::make_unique<Surface>(mesh, options); });
}

void update_surface(Surface& surface, const Array<float>& positions) {
  const auto points = rows(positions, 3, "positions");
  surface.change([&](auto& all) { all.update(points); });
}

void bind_surface(py::module_& module) {
  py::class_<Surface>(module, "Surface", "A subdivision surface as quadratic patches, updated in real time.")
      .def(py::init(&make_surface), py::arg("vertices"), py::arg("triangles"), py::arg("creases") = py::none(),
           py::kw_only(), py::arg("scheme") = "loop", py::arg("splits") = 0, py::arg("threads") = 0,
           "vertices: their number. triangles: (triangles, 3). creases: (creases, 2). scheme: 'loop' or 'butterfly'.")
      .def("update", &update_surface, py::arg("positions"),
           "positions: (vertices, 3). Arrays that were taken before show the new values.")
      .def_property_readonly(
          "limit_positions",
          [](const py::object& self) { return vectors(self.cast<Surface&>().fixed().limit_positions(), self); },
          "(points, 4) float32: x, y, z, 1")
      .def_property_readonly(
          "limit_normals",
          [](const py::object& self) { return vectors(self.cast<Surface&>().fixed().limit_normals(), self); },
          "(points, 4) float32: x, y, z, 0")
      .def(
          "corners",
          [](const Surface& surface) {
            return corners<qas::Corner>(surface.fixed().corner_count(), [&](auto all) {
              surface.read([&](const auto& values) { values.write_corners(all); });
            });
          },
          "(corners, 12) float32: position, edge_position, normal, edge_normal; three corners for each patch")
      .def(
          "quartic_corners",
          [](const Surface& surface) {
            return corners<qas::QuarticCorner>(surface.fixed().quartic_corner_count(), [&](auto all) {
              surface.read([&](const auto& values) { values.write_quartic_corners(all); });
            });
          },
          "(corners, 32) float32: four points and four normals of four numbers; only with splits=1")
      .def(
          "evaluate",
          [](const Surface& surface, const Whole<std::size_t>& wanted, const std::array<float, 3>& barycentric) {
            const std::size_t patch = wanted.checked("patch");
            return sample_of(surface.read([&](const auto& all) { return all.evaluate(patch, barycentric); }));
          },
          py::arg("patch"), py::arg("barycentric"), "The position and the normal at (w, u, v).");
}

void bind_loop(py::module_& module) {
  py::class_<Loop>(module, "LoopSurface", "The exact limit surface of Loop's scheme.")
      .def(py::init([](const Whole<std::size_t>& vertices, const Array<std::uint32_t>& triangles,
                       const OptionalArray<std::uint32_t>& creases) {
             const qas::Mesh mesh = mesh_of(vertices, triangles, creases);
             return without_gil([&] { return std::make_unique<Loop>(mesh); });
           }),
           py::arg("vertices"), py::arg("triangles"), py::arg("creases") = py::none())
      .def(
          "update",
          [](Loop& loop, const Array<float>& positions) {
            const auto points = rows(positions, 3, "positions");
            loop.surface.change([&](auto& surface) { surface.update(points); });
          },
          py::arg("positions"))
      .def(
          "evaluate",
          [](const Loop& loop, const Whole<std::size_t>& wanted, const std::array<float, 3>& barycentric) {
            const std::size_t triangle = wanted.checked("triangle");
            return sample_of(
                loop.surface.read([&](const auto& surface) { return surface.evaluate(triangle, barycentric); }));
          },
          py::arg("triangle"), py::arg("barycentric"))
      .def("refine", &refine, py::arg("level"), py::arg("threads") = 0,
           "Positions and normals of all triangles at the vertices of the uniform pattern of a level, 0 to 11.");
}

}  // namespace

void bind_qas(py::module_& parent) {
  py::module_ module = parent.def_submodule("qas", "Subdivision surfaces in real time.");
  bind_surface(module);
  bind_loop(module);
  const qas::ShaderInputs names;
  module.def(
      "refinement_shader",
      [](const std::string& position, const std::string& edge_position, const std::string& normal,
         const std::string& edge_normal) {
        return qas::refinement_shader({position, edge_position, normal, edge_normal});
      },
      py::arg("position") = names.position, py::arg("edge_position") = names.edge_position,
      py::arg("normal") = names.normal, py::arg("edge_normal") = names.edge_normal,
      "The GLSL text for glRefinementShaderSourceARK.");
  module.def("quartic_refinement_shader", &qas::quartic_refinement_shader, py::arg("points") = "points",
             py::arg("normals") = "normals");
}

}  // namespace glark::python
