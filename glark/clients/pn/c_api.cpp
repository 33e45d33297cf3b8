// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/pn.h>
#include <glark/pn.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
using glark::c::span_of;
namespace pn = glark::pn;

struct glark_pn_tagged_mesh {
  pn::TaggedMesh mesh;
};

namespace {

static_assert(static_cast<int>(pn::Element::option) == GLARK_PN_OPTION);

template <std::size_t Count, class Number>
std::array<Number, Count> copied(const Number (&values)[Count]) {
  std::array<Number, Count> result;
  std::copy_n(values, Count, result.begin());
  return result;
}

// Throws pn::Error, which names the corner, for the first number that is not finite.
void check_corners(const glark_pn_corner* corners) {
  const auto check = [](std::size_t corner, std::span<const float> values, const char* name) {
    for (const float value : values)
      if (!std::isfinite(value))
        throw pn::Error(pn::Element::vertex, corner,
                        std::string("has the ") + name + " " + std::to_string(value) + "; finite numbers are possible");
  };
  for (std::size_t i = 0; i < 3; ++i) {
    check(i, corners[i].position, "position");
    check(i, corners[i].normal, "normal");
    check(i, corners[i].discontinuity, "discontinuity");
    check(i, corners[i].tags, "tag");
  }
}

void check_weights(const double* weights) {
  constexpr double tolerance = 1e-4;  // for weights that were floats
  const double sum = weights[0] + weights[1] + weights[2];
  if (std::abs(sum - 1) <= tolerance && std::min({weights[0], weights[1], weights[2]}) >= -tolerance) return;
  throw pn::Error(pn::Element::array, 0,
                  "of barycentric coordinates (" + std::to_string(weights[0]) + ", " + std::to_string(weights[1]) +
                      ", " + std::to_string(weights[2]) + ") is not of a point of the triangle: 0 to 1, of sum 1");
}

pn::Corner corner_of(const glark_pn_corner& corner) {
  return {.position = copied(corner.position),
          .normal = copied(corner.normal),
          .discontinuity = copied(corner.discontinuity),
          .tags = copied(corner.tags)};
}

pn::Options options_of(const glark_pn_options& options) {
  return {.crease_degrees = options.crease_degrees,
          .sharpness = options.sharpness,
          .tension = options.tension,
          .bias = options.bias,
          .split = options.split};
}

}  // namespace

glark_pn_options glark_pn_default_options(void) {
  const pn::Options options;
  return {options.crease_degrees, options.sharpness, options.tension, options.bias, options.split};
}

glark_code glark_pn_derive_tags(const glark_pn_mesh* mesh, const glark_pn_options* options,
                                glark_pn_tagged_mesh** tagged, glark_error* error) {
  return glark::c::guarded<pn::Error>(error, [&] {
    const glark_pn_mesh& given = needed(mesh, "mesh");
    glark_pn_tagged_mesh*& result = needed(tagged, "tagged");
    result = std::make_unique<glark_pn_tagged_mesh>(
                 glark_pn_tagged_mesh{pn::derive_tags({.positions = span_of(given.positions, "positions"),
                                                       .triangles = span_of(given.triangles, "triangles"),
                                                       .normals = span_of(given.normals, "normals"),
                                                       .creases = span_of(given.creases, "creases")},
                                                      options == nullptr ? pn::Options{} : options_of(*options))})
                 .release();
  });
}

void glark_pn_tagged_mesh_free(glark_pn_tagged_mesh* tagged) { std::unique_ptr<glark_pn_tagged_mesh>{tagged}; }

glark_floats glark_pn_positions(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.positions);
}
glark_floats glark_pn_normals(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.normals);
}
glark_floats glark_pn_discontinuities(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.discontinuities);
}
glark_floats glark_pn_tags(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.tags);
}
glark_indices glark_pn_triangles(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.triangles);
}
glark_indices glark_pn_sources(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  const auto& sources = tagged->mesh.sources;
  return {sources.empty() ? nullptr : sources.front().data(), 2 * sources.size()};
}
glark_indices glark_pn_triangle_sources(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return array_of(tagged->mesh.triangle_sources);
}
size_t glark_pn_crease_vertices(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return tagged->mesh.crease_vertices;
}
size_t glark_pn_corners(const glark_pn_tagged_mesh* tagged) {
  if (tagged == nullptr) return {};
  return tagged->mesh.corners;
}

glark_code glark_pn_evaluate(const glark_pn_corner corners[3], const double barycentric[3], glark_pn_sample* sample,
                             glark_error* error) {
  return glark::c::guarded<pn::Error>(error, [&] {
    const glark_pn_corner* given = &needed(corners, "corners");
    const double* weights = &needed(barycentric, "barycentric");
    glark_pn_sample& result = needed(sample, "sample");
    check_corners(given);
    check_weights(weights);
    const pn::Sample found = pn::evaluate({corner_of(given[0]), corner_of(given[1]), corner_of(given[2])},
                                          {weights[0], weights[1], weights[2]});
    std::ranges::copy(found.position, result.position);
    std::ranges::copy(found.normal, result.normal);
  });
}
