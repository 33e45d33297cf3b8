// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The limit surface at any parameter, by Stam's tiling. A triangle with an extraordinary vertex or a crease is
// subdivided. Three of its four children are regular, except near creases. The subdivision matrix is not diagonalised;
// steps are applied one by one. Patterns end at the eleventh step, so creases and corners need no special case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "glark/clients/common/workers.h"
#include "glark/clients/qas/float4.h"
#include "glark/clients/qas/frame.h"
#include "glark/clients/qas/loop_surface/loop_patch.h"

namespace glark::qas {
namespace {

constexpr int deepest_step = 24;  // further steps are nearer to a corner than floats resolve
constexpr unsigned deepest_level = 11;

Sample sample_of(const Jet& jet, const Point& coarse_normal) {
  const auto& [a, b] = jet.tangents;
  Point n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  double length = std::hypot(n[0], n[1], n[2]);
  const double scale = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
  if (!(length > 1e-9 * scale)) {
    n = coarse_normal;
    length = 1;
  }
  Sample sample{};
  for (std::size_t i = 0; i < 3; ++i) {
    sample.position[i] = static_cast<float>(jet.position[i]);
    sample.normal[i] = static_cast<float>(n[i] / length);
  }
  return sample;
}

// Lattice point (i, j) has the barycentric coordinates (w, u, v) = (2^level - i - j, i, j) / 2^level.
using LatticePoint = std::array<unsigned, 2>;

std::size_t lattice_index(unsigned level, LatticePoint at) {
  const std::size_t side = (std::size_t{1} << level) + 1;
  return at[0] * side - at[0] * (at[0] - std::size_t{1}) / 2 + at[1];
}

LatticePoint half_way(LatticePoint a, LatticePoint b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}; }

}  // namespace

struct LoopSurface::State {
  Topology topology;
  std::vector<std::uint32_t> first_about, about;  // the triangles around each vertex
  std::vector<Point> positions;
  std::vector<Float4> checked;

  explicit State(const Mesh& mesh);
  LoopPatch patch(std::uint32_t triangle) const;
  Point coarse_normal(std::uint32_t triangle) const;
  Sample evaluate(std::uint32_t triangle, std::array<double, 3> barycentric) const;
  Sample sample(std::uint32_t triangle,
                const std::array<double, 3>& barycentric) const;  // also of copies and degenerate triangles
  void fill(const LoopPatch& patch, const Point& normal, unsigned level, unsigned steps,
            const std::array<LatticePoint, 3>& corners, std::span<Sample> samples) const;
};

LoopSurface::State::State(const Mesh& mesh)
    : topology(analyse(mesh)), positions(topology.vertex_count), checked(topology.vertex_count) {
  first_about.assign(topology.vertex_count + std::size_t{1}, 0);
  const auto each = [&](const auto& visit) {
    for (std::uint32_t h = 0; h < topology.triangles.size(); ++h) {
      if (topology.same_as[h / 3] == h / 3) visit(topology.corner(h), h / 3);
    }
  };
  each([&](std::uint32_t vertex, std::uint32_t) { ++first_about[vertex + std::size_t{1}]; });
  for (std::size_t v = 1; v < first_about.size(); ++v) first_about[v] += first_about[v - 1];
  about.resize(first_about.back());
  std::vector<std::uint32_t> next = first_about;
  each([&](std::uint32_t vertex, std::uint32_t triangle) { about[next[vertex]++] = triangle; });
}

LoopPatch LoopSurface::State::patch(std::uint32_t triangle) const {
  std::vector<std::uint32_t> touching;
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    const std::uint32_t vertex = topology.corner(h);
    touching.insert(touching.end(), about.begin() + first_about[vertex], about.begin() + first_about[vertex + 1]);
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  std::iter_swap(touching.begin(), std::find(touching.begin(), touching.end(), triangle));
  Neighbourhood around;
  for (const std::uint32_t t : touching) {
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      around.triangles.push_back(topology.corner(h));
      const Edge& edge = topology.edges[topology.edge_of[h]];
      if (edge.marked) around.creases.insert(around.creases.end(), {edge.ends[0], edge.ends[1]});
    }
  }
  return LoopPatch(around, positions);
}

Point LoopSurface::State::coarse_normal(std::uint32_t triangle) const {
  std::array<Float4, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = checked[topology.triangles[3 * std::size_t{triangle} + i]];
  const Float4 normal = unit_or_z(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return {normal[0], normal[1], normal[2]};
}

Sample LoopSurface::State::evaluate(std::uint32_t triangle, std::array<double, 3> barycentric) const {
  LoopPatch here = patch(triangle);
  // Each step doubles the error of the coordinates' sum. So the greatest coordinate is set to make the sum 1.
  const auto greatest =
      static_cast<std::size_t>(std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin());
  barycentric[greatest] = 1 - barycentric[(greatest + 1) % 3] - barycentric[(greatest + 2) % 3];
  for (int step = 0; step < deepest_step && !here.regular(); ++step) {
    auto& [w, u, v] = barycentric;
    if (w >= 1 || u >= 1 || v >= 1) break;
    if (w >= 0.5) {
      barycentric = {2 * w - 1, 2 * u, 2 * v};
      here = here.child(0);
    } else if (u >= 0.5) {
      barycentric = {2 * w, 2 * u - 1, 2 * v};
      here = here.child(1);
    } else if (v >= 0.5) {
      barycentric = {2 * w, 2 * u, 2 * v - 1};
      here = here.child(2);
    } else {
      barycentric = {1 - 2 * v, 1 - 2 * w, 1 - 2 * u};
      here = here.child(3);
    }
  }
  const Point normal = coarse_normal(triangle);
  if (here.regular()) return sample_of(here.box_spline(barycentric), normal);
  const auto nearest = std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin();
  return sample_of(here.limit(static_cast<std::uint32_t>(nearest)), normal);
}

Sample LoopSurface::State::sample(std::uint32_t triangle, const std::array<double, 3>& barycentric) const {
  const std::uint32_t source = topology.same_as[triangle];
  if (source == triangle) return evaluate(triangle, barycentric);
  const auto place = [&](std::uint32_t in, std::uint32_t vertex) {
    const auto first = topology.triangles.begin() + 3 * std::ptrdiff_t{in};
    return static_cast<std::size_t>(std::find(first, first + 3, vertex) - first);
  };
  const std::uint32_t* const vertices = &topology.triangles[3 * std::size_t{triangle}];
  std::array<double, 3> there{};
  if (source == none) {  // the triangle is a point
    const std::uint32_t vertex = vertices[0];
    Sample point = sample_of({positions[vertex], {}}, {0, 0, 1});
    if (first_about[vertex] == first_about[vertex + 1]) return point;
    const std::uint32_t beside = about[first_about[vertex]];
    there[place(beside, vertex)] = 1;
    point.position = evaluate(beside, there).position;
    return point;
  }
  for (std::size_t i = 0; i < 3; ++i) there[place(source, vertices[i])] = barycentric[i];
  Sample result = evaluate(source, there);
  if ((place(source, vertices[0]) + 1) % 3 != place(source, vertices[1])) {
    for (float& component : result.normal) component = -component;
  }
  return result;
}

// Fills the lattice between three of its points, `steps` subdivisions apart.
void LoopSurface::State::fill(const LoopPatch& patch, const Point& normal, unsigned level, unsigned steps,
                              const std::array<LatticePoint, 3>& corners, std::span<Sample> samples) const {
  if (patch.regular()) {
    const unsigned side = 1U << steps;
    for (unsigned i = 0; i <= side; ++i) {
      for (unsigned j = 0; i + j <= side; ++j) {
        LatticePoint at{};
        for (std::size_t k = 0; k < 2; ++k)
          at[k] = ((side - i - j) * corners[0][k] + i * corners[1][k] + j * corners[2][k]) / side;
        const double length = side;
        samples[lattice_index(level, at)] =
            sample_of(patch.box_spline({(side - i - j) / length, i / length, j / length}), normal);
      }
    }
  } else if (steps == 0) {
    for (std::uint32_t i = 0; i < 3; ++i) samples[lattice_index(level, corners[i])] = sample_of(patch.limit(i), normal);
  } else {
    const LatticePoint a = half_way(corners[0], corners[1]), b = half_way(corners[1], corners[2]),
                       c = half_way(corners[2], corners[0]);
    fill(patch.child(0), normal, level, steps - 1, {corners[0], a, c}, samples);
    fill(patch.child(1), normal, level, steps - 1, {a, corners[1], b}, samples);
    fill(patch.child(2), normal, level, steps - 1, {c, b, corners[2]}, samples);
    fill(patch.child(3), normal, level, steps - 1, {a, b, c}, samples);
  }
}

LoopSurface::LoopSurface(const Mesh& mesh) : state_(std::make_unique<State>(mesh)) {}
LoopSurface::~LoopSurface() = default;
LoopSurface::LoopSurface(LoopSurface&&) noexcept = default;
LoopSurface& LoopSurface::operator=(LoopSurface&&) noexcept = default;

void LoopSurface::update(std::span<const float> positions) {
  static_cast<void>(take_positions(positions, state_->checked));
  for (std::size_t v = 0; v < state_->positions.size(); ++v)
    state_->positions[v] = {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
}

Sample LoopSurface::evaluate(std::size_t triangle, std::array<float, 3> barycentric) const {
  const Topology& topology = state_->topology;
  if (triangle >= topology.same_as.size()) {
    throw Error(Element::triangle, triangle, fmt::format("is not one of the {}", topology.same_as.size()));
  }
  check_barycentric(barycentric);
  return state_->sample(static_cast<std::uint32_t>(triangle), {barycentric[0], barycentric[1], barycentric[2]});
}

void LoopSurface::refine(unsigned level, std::span<Sample> samples, unsigned threads) const {
  const Topology& topology = state_->topology;
  if (level > deepest_level) {
    throw Error(Element::array, 0, fmt::format("of level {} is deeper than patterns are, which end at 11", level));
  }
  const std::size_t side = std::size_t{1} << level, each = (side + 1) * (side + 2) / 2;
  if (samples.size() != topology.same_as.size() * each) {
    throw Error(Element::array, 0,
                fmt::format("of samples has {}; {} triangles of level {} have {}", samples.size(),
                            topology.same_as.size(), level, topology.same_as.size() * each));
  }
  const unsigned last = 1U << level;
  Workers(threads).evenly(
      topology.same_as.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          const auto triangle = static_cast<std::uint32_t>(t);
          const std::span<Sample> mine = samples.subspan(t * each, each);
          if (topology.same_as[t] == t) {
            state_->fill(state_->patch(triangle), state_->coarse_normal(triangle), level, level,
                         {{{0, 0}, {last, 0}, {0, last}}}, mine);
            continue;
          }
          for (unsigned i = 0; i <= last; ++i) {
            for (unsigned j = 0; i + j <= last; ++j) {
              const double length = last;
              mine[lattice_index(level, {i, j})] =
                  state_->sample(triangle, {(last - i - j) / length, i / length, j / length});
            }
          }
        }
      },
      1);
}

}  // namespace glark::qas
