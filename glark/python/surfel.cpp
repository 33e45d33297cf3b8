// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/surfel.h>

#include "glark/python/convert/arrays.h"
#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/guarded.h"

namespace glark::python {

template <>
inline constexpr bool is_bound<surfel::Frame> = true;
template <>
inline constexpr bool is_bound<Guarded<surfel::Strips>> = true;
namespace {

using surfel::Frame;
using Strips = Guarded<surfel::Strips>;

surfel::Cloud cloud_of(const Array<float>& positions, const OptionalArray<float>& normals) {
  return {.positions = rows(positions, 3, "positions"), .normals = rows(normals, 3, "normals")};
}

py::dict counts_of(const Strips& strips, const Whole<unsigned>& wanted) {
  const unsigned level = wanted.checked("level");
  const surfel::Counts counts = strips.read([&](const auto& all) { return all.counts(level); });
  py::dict result;
  result["outer"] = counts.outer;
  result["redundant"] = counts.redundant;
  result["dual"] = counts.dual;
  result["valid"] = counts.valid;
  result["out_of_reach"] = counts.out_of_reach;
  result["turned"] = counts.turned;
  result["strips"] = counts.strips;
  result["indices"] = counts.indices;
  result["loose_points"] = counts.loose_points;
  return result;
}

// `matrix` is (4, 4) in rows, as in mathematics; GL has columns.
Frame select(const Strips& strips, const Array<float>& matrix, const Whole<unsigned>& width,
             const Whole<unsigned>& height, bool cull_frustum, bool cull_back_faces, float point_pixels,
             float level_pixels) {
  const std::span<const float> numbers = rows(matrix, 4, "clip_from_object");
  if (numbers.size() != 16) {
    throw ArgumentError(
        fmt::format("glark: clip_from_object has {} rows; give it the shape (4, 4)", numbers.size() / 4));
  }
  surfel::View given{.width = width.checked("width"),
                     .height = height.checked("height"),
                     .cull_frustum = cull_frustum,
                     .cull_back_faces = cull_back_faces,
                     .point_pixels = point_pixels,
                     .level_pixels = level_pixels};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      given.clip_from_object.at(4 * column + row) = numbers[4 * row + column];
    }
  }
  Frame frame;
  strips.read([&](const auto& all) { all.select(given, frame); });
  return frame;
}

template <class Values>
auto copied(const Values& values) {
  return std::vector(values.begin(), values.end());
}

py::array_t<std::uint64_t> ranges_of(const std::vector<surfel::Range>& ranges) {
  std::vector<std::uint64_t> numbers;
  for (const surfel::Range& range : ranges) numbers.insert(numbers.end(), {range.first, range.count});
  return owned(std::move(numbers), 2);
}

void bind_frame(py::module_& module) {
  py::class_<Frame>(module, "Frame",
                    "What a view draws: glMultiDrawElements(GL_TRIANGLE_STRIP, counts, GL_UNSIGNED_INT, offsets).")
      .def_property_readonly(
          "counts", [](const py::object& self) { return view(self.cast<Frame&>().counts, 1, self); },
          "(strips,) int32: the number of indices of each strip")
      .def_property_readonly(
          "offsets",
          [](const py::object& self) {
            const std::vector<const void*>& offsets = self.cast<Frame&>().offsets;
            static_assert(sizeof(void*) == sizeof(std::uintptr_t));
            return view(std::span(reinterpret_cast<const std::uintptr_t*>(offsets.data()), offsets.size()), 1, self);
          },
          "in bytes from the beginning of the indices")
      .def_property_readonly(
          "points", [](const py::object& self) { return view(self.cast<Frame&>().points, 1, self); },
          "drawn as GL_POINTS")
      .def_readonly("level", &Frame::level, "the level of detail that is drawn; 0 is the finest")
      .def_readonly("indices", &Frame::indices, "the number of all indices, the sum of counts")
      .def_readonly("strips", &Frame::strips, "the number of strips")
      .def_readonly("visited", &Frame::visited, "the number of nodes that were looked at")
      .def_readonly("out_of_frustum", &Frame::out_of_frustum,
                    "the number of nodes that were left out, because they lie outside of the view")
      .def_readonly("back_faces", &Frame::back_faces, "the number of nodes that were left out, because they face away");
}

std::unique_ptr<Strips> make_strips(const Array<float>& positions, const OptionalArray<float>& normals,
                                    const Whole<unsigned>& leaf_points, float delta_a, float delta_d, float inflation,
                                    float reach, bool turn_edges, const Whole<unsigned>& levels,
                                    const Whole<unsigned>& threads) {
  const surfel::Cloud cloud = cloud_of(positions, normals);
  const surfel::Options options{
      leaf_points.checked("leaf_points"), delta_a, delta_d, inflation, reach, turn_edges, levels.checked("levels"),
      threads.checked("threads")};
  return without_gil([&] { return std::make_unique<Strips>(cloud, options); });
}

auto update_strips(Strips& strips, const Array<float>& positions, const OptionalArray<float>& normals,
                   const Array<std::uint32_t>& moved) {
  const surfel::Cloud cloud = cloud_of(positions, normals);
  const std::span<const std::uint32_t> indices = rows(moved, 1, "moved");
  return ranges_of(strips.change([&](auto& all) { return all.update(cloud, indices); }));
}

}  // namespace

void bind_surfel(py::module_& parent) {
  py::module_ module = parent.def_submodule("surfel", "A point cloud as triangle strips.");
  PYBIND11_NUMPY_DTYPE(surfel::Node, low, high, cone_axis, cone_apex, cone_sine, left, right, first, count,
                       representative);
  bind_frame(module);
  const surfel::Options defaults;
  py::class_<Strips>(module, "Strips", "Triangle strips that interpolate points, with a tree for culling.")
      .def(py::init(&make_strips), py::arg("positions"), py::arg("normals") = py::none(), py::kw_only(),
           py::arg("leaf_points") = defaults.leaf_points, py::arg("delta_a") = defaults.delta_a,
           py::arg("delta_d") = defaults.delta_d, py::arg("inflation") = defaults.inflation,
           py::arg("reach") = defaults.reach, py::arg("turn_edges") = defaults.turn_edges, py::arg("levels") = 1,
           py::arg("threads") = 0, "positions: (points, 3). normals: (points, 3), or none. levels: of detail, 1 to 16.")
      .def_property_readonly(
          "point_count",
          [](const Strips& strips) { return strips.read([](const auto& all) { return all.point_count(); }); },
          "the number of points, with those that update() added")
      .def_property_readonly(
          "level_count", [](const Strips& strips) { return strips.fixed().level_count(); },
          "the number of levels of detail")
      .def_property_readonly(
          "indices",
          [](const Strips& strips) {
            return owned(strips.read([](const auto& all) { return copied(all.indices()); }), 1);
          },
          "uint32, all strips of all levels: a copy, because update() changes them.")
      .def(
          "nodes",
          [](const Strips& strips, const Whole<unsigned>& wanted) {
            const unsigned level = wanted.checked("level");
            return owned(strips.read([&](const auto& all) { return copied(all.nodes(level)); }), 1);
          },
          py::arg("level") = 0, "(nodes,) records of the stripping tree, a copy; level 0 is the finest")
      .def("counts", &counts_of, py::arg("level") = 0)
      .def("select", &select, py::arg("clip_from_object"), py::arg("width"), py::arg("height"), py::kw_only(),
           py::arg("cull_frustum") = true, py::arg("cull_back_faces") = true, py::arg("point_pixels") = 1.0F,
           py::arg("level_pixels") = 1.0F,
           "What to draw for a view. clip_from_object: (4, 4), projection @ model-view. width, height: pixels.")
      .def("update", &update_strips, py::arg("positions"), py::arg("normals"), py::arg("moved"),
           "Points moved or are new. Returns (ranges, 2): first and count of the indices that changed.");
}

}  // namespace glark::python
