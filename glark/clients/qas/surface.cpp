// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The class Surface of the public header.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "glark/clients/common/error_message.h"
#include "glark/clients/qas/frame.h"
#include "glark/clients/qas/limit_step/butterfly_step.h"
#include "glark/clients/qas/limit_step/limit_step.h"
#include "glark/clients/qas/limit_step/split.h"
#include "glark/clients/qas/shader/quadratic.h"
#include "glark/clients/qas/shader/quartic.h"

namespace glark::qas {
namespace {

const char* name_of(Element element) {
  switch (element) {
    case Element::vertex: return "vertex";
    case Element::triangle: return "triangle";
    case Element::crease: return "crease";
    case Element::array: return "array";
    case Element::mesh: break;
  }
  return "mesh";
}

std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element != Element::mesh && element != Element::array;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

std::array<float, 3> triple(const Vector& vector) { return {vector.x, vector.y, vector.z}; }

// Returns the matrix of a quartic corner: four points as columns, and the inner point in the last row.
std::array<std::array<float, 4>, 4> columns(const std::array<const Vector*, 5>& points) {
  std::array<std::array<float, 4>, 4> result{};
  const std::array<float, 3> inner = triple(*points[4]);
  for (std::size_t i = 0; i < 4; ++i) result[i] = {points[i]->x, points[i]->y, points[i]->z, i < 3 ? inner[i] : 0};
  return result;
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what)
    : ElementError(element, index,
                   common::error_message("glark-qas", name_of(element), number_of(element, index), what)) {}

struct Surface::State {
  Workers workers;
  std::unique_ptr<LimitStep> subdivision;  // from the coarse mesh to the mesh of the patches; null if both are the same
  std::unique_ptr<LimitStep> step;
  std::unique_ptr<ButterflyStep> butterfly_subdivision, butterfly;  // for the Butterfly scheme
  std::vector<std::array<std::uint32_t, 2>> corner_vertices;
  std::vector<std::vector<Float4>> levels;  // the scaled vertices, those of the coarse mesh first
  std::vector<Float4> shift;                // the shifts of Loop's step, or the points after a Butterfly step
  std::vector<Vector> positions, normals;

  State(const Mesh& mesh, const Options& options);
};

Surface::State::State(const Mesh& mesh, const Options& options) : workers(options.threads) {
  if (options.splits > 1) {
    throw Error(Element::mesh, 0, fmt::format("is to be split {} times; 0 and 1 are possible", options.splits));
  }
  Topology topology = analyse(mesh);
  std::vector<std::array<std::uint32_t, 2>> ancestors;
  levels.emplace_back(topology.vertex_count);
  const bool interpolates = options.scheme == Scheme::modified_butterfly;
  if (options.splits == 1) {
    subdivision = std::make_unique<LimitStep>(topology);
    if (interpolates) butterfly_subdivision = std::make_unique<ButterflyStep>(topology, *subdivision);
    ancestors = parents(topology);
    topology = split(topology, subdivision->patches());
    levels.emplace_back(topology.vertex_count);
  }
  step = std::make_unique<LimitStep>(topology);
  if (interpolates) butterfly = std::make_unique<ButterflyStep>(topology, *step);
  corner_vertices.reserve(topology.triangles.size());
  for (const std::uint32_t vertex : topology.triangles) {
    corner_vertices.push_back(ancestors.empty() ? std::array{vertex, vertex} : ancestors[vertex]);
  }
  shift.resize(interpolates ? step->position_count() : topology.vertex_count);
  positions.resize(step->position_count());
  normals.resize(step->normal_count());
}

Surface::Surface(const Mesh& mesh, const Options& options) : state_(std::make_unique<State>(mesh, options)) {}
Surface::~Surface() = default;
Surface::Surface(Surface&&) noexcept = default;
Surface& Surface::operator=(Surface&&) noexcept = default;

void Surface::update(std::span<const float> positions) {
  State& state = *state_;
  const Scaled scaled = take_positions(positions, state.levels.front());
  if (state.butterfly_subdivision) {
    state.butterfly_subdivision->subdivide(state.workers, state.levels[0].data(), state.levels[1].data());
  } else if (state.subdivision) {
    state.subdivision->subdivide(state.workers, state.levels[0].data(), state.levels[1].data());
  }
  const LimitStep::Frame frame{state.levels.back().data(), state.shift.data(), state.positions.data(),
                               state.normals.data(), scaled.unscale};
  if (state.butterfly) {
    state.butterfly->run(state.workers, frame, state.shift.data());
  } else {
    state.step->run(state.workers, frame);
  }
}

std::span<const Vector> Surface::limit_positions() const { return state_->positions; }
std::span<const Vector> Surface::limit_normals() const { return state_->normals; }
std::span<const Patch> Surface::patches() const { return state_->step->patches(); }
std::size_t Surface::corner_count() const { return 3 * patches().size(); }
std::span<const std::array<std::uint32_t, 2>> Surface::corner_vertices() const { return state_->corner_vertices; }

void Surface::write_corners(std::span<Corner> corners) const {
  if (corners.size() != corner_count()) {
    throw Error(Element::array, 0,
                fmt::format("of corners has {}; {} patches have {}", corners.size(), patches().size(), corner_count()));
  }
  state_->workers.evenly(patches().size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Patch& patch = patches()[p];
      for (std::size_t i = 0; i < 3; ++i) {
        corners[3 * p + i] = {triple(state_->positions[patch.positions[i]]),
                              triple(state_->positions[patch.positions[3 + i]]),
                              triple(state_->normals[patch.normals[i]]), triple(state_->normals[patch.normals[3 + i]])};
      }
    }
  });
}

Sample Surface::evaluate(std::size_t patch, std::array<float, 3> barycentric) const {
  if (patch >= patches().size()) {
    throw Error(Element::triangle, patch, fmt::format("is not one of the {} patches", patches().size()));
  }
  check_barycentric(barycentric);
  std::array<Float4, 6> points, normals;
  for (std::size_t i = 0; i < 6; ++i) {
    points[i] = load(state_->positions[patches()[patch].positions[i]]);
    normals[i] = load(state_->normals[patches()[patch].normals[i]]);
  }
  const Float4 position = quadratic(points, barycentric);
  const Float4 normal = unit_or_z(quadratic(normals, barycentric));
  return {{position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}};
}

std::size_t Surface::quartic_corner_count() const { return state_->levels.size() > 1 ? corner_count() / 4 : 0; }

void Surface::write_quartic_corners(std::span<QuarticCorner> corners) const {
  if (corners.size() != quartic_corner_count()) {
    throw Error(
        Element::array, 0,
        fmt::format("of quartic corners has {}; the triangles have {}", corners.size(), quartic_corner_count()));
  }
  state_->workers.evenly(corners.size() / 3, [&](std::size_t begin, std::size_t end) {
    for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner) {
      std::array<const Vector*, 5> points{}, normals{};
      const auto places = quartic_points(corner / 3, corner % 3);
      for (std::size_t i = 0; i < 5; ++i) {
        const Patch& patch = patches()[places[i].patch];
        points[i] = &state_->positions[patch.positions[places[i].point]];
        normals[i] = &state_->normals[patch.normals[places[i].point]];
      }
      corners[corner] = {columns(points), columns(normals)};
    }
  });
}

Sample Surface::evaluate_quartic(std::size_t triangle, std::array<float, 3> barycentric) const {
  if (triangle >= quartic_corner_count() / 3) {
    throw Error(Element::triangle, triangle,
                fmt::format("is not one of the {} with a quartic (splits 1)", quartic_corner_count() / 3));
  }
  check_barycentric(barycentric);
  std::array<QuarticPoints, 3> points{}, normals{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto places = quartic_points(triangle, corner);
    for (std::size_t i = 0; i < 5; ++i) {
      const Patch& patch = patches()[places[i].patch];
      (i < 4 ? points[corner].edge[i] : points[corner].inner) =
          load(state_->positions[patch.positions[places[i].point]]);
      (i < 4 ? normals[corner].edge[i] : normals[corner].inner) = load(state_->normals[patch.normals[places[i].point]]);
    }
  }
  const Float4 position = quartic(points, barycentric);
  const Float4 normal = unit_or_z(quartic(normals, barycentric));
  return {{position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}};
}

}  // namespace glark::qas
