// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/qas.h>
#include <glark/qas.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

#include "glark/clients/common/c_boundary.h"

using glark::c::enumeration_of;
using glark::c::needed;
using glark::c::span_of;
namespace qas = glark::qas;

struct glark_qas_surface {
  qas::Surface surface;
};
struct glark_qas_loop_surface {
  qas::LoopSurface surface;
};

namespace {

// Arrays of these types are passed through the C interface without conversion, so both languages need the same layout.
static_assert(sizeof(qas::Vector) == 4 * sizeof(float));
static_assert(sizeof(glark_qas_patch) == sizeof(qas::Patch));
static_assert(offsetof(glark_qas_patch, normals) == offsetof(qas::Patch, normals));
static_assert(sizeof(glark_qas_corner) == sizeof(qas::Corner));
static_assert(offsetof(glark_qas_corner, edge_normal) == offsetof(qas::Corner, edge_normal));
static_assert(sizeof(glark_qas_quartic_corner) == sizeof(qas::QuarticCorner));
static_assert(offsetof(glark_qas_quartic_corner, normals) == offsetof(qas::QuarticCorner, normals));
static_assert(sizeof(glark_qas_sample) == sizeof(qas::Sample));
static_assert(offsetof(glark_qas_sample, normal) == offsetof(qas::Sample, normal));
static_assert(static_cast<int>(qas::Scheme::modified_butterfly) == GLARK_QAS_MODIFIED_BUTTERFLY);
static_assert(static_cast<int>(qas::Element::array) == GLARK_QAS_ARRAY);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<qas::Error>(error, step);
}

qas::Mesh mesh_of(const glark_qas_mesh& mesh) {
  return {.vertex_count = mesh.vertex_count,
          .triangles = span_of(mesh.triangles, "triangles"),
          .creases = span_of(mesh.creases, "creases")};
}

qas::Options options_of(const glark_qas_options& options) {
  return {.scheme = enumeration_of(options.scheme, qas::Scheme::modified_butterfly, "scheme"),
          .splits = options.splits,
          .threads = options.threads};
}

glark_floats floats_of(std::span<const qas::Vector> vectors) {
  return {reinterpret_cast<const float*>(vectors.data()), 4 * vectors.size()};
}

std::array<float, 3> weights_of(const float* barycentric) {
  const float* weights = &needed(barycentric, "barycentric");
  return {weights[0], weights[1], weights[2]};
}

void store(const qas::Sample& found, glark_qas_sample* sample) {
  glark_qas_sample& result = needed(sample, "sample");
  std::ranges::copy(found.position, result.position);
  std::ranges::copy(found.normal, result.normal);
}

// A copy for the caller; NULL if there is no memory.
template <class MakeText>
char* text_of(const MakeText& make) {
  try {
    const std::string text = make();
    char* copy = new char[text.size() + 1];
    std::memcpy(copy, text.c_str(), text.size() + 1);
    return copy;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void name(std::string& input, const char* given) {
  if (given != nullptr) {
    input = given;
  }
}

}  // namespace

glark_qas_options glark_qas_default_options(void) {
  const qas::Options options;
  return {static_cast<glark_qas_scheme>(options.scheme), options.splits, options.threads};
}

glark_code glark_qas_surface_create(const glark_qas_mesh* mesh, const glark_qas_options* options,
                                    glark_qas_surface** surface, glark_error* error) {
  return guarded(error, [&] {
    const qas::Mesh given = mesh_of(needed(mesh, "mesh"));
    glark_qas_surface*& result = needed(surface, "surface");
    const qas::Options wanted = options == nullptr ? qas::Options{} : options_of(*options);
    result = std::make_unique<glark_qas_surface>(glark_qas_surface{qas::Surface(given, wanted)}).release();
  });
}

void glark_qas_surface_free(glark_qas_surface* surface) { std::unique_ptr<glark_qas_surface>{surface}; }

glark_code glark_qas_surface_update(glark_qas_surface* surface, glark_floats positions, glark_error* error) {
  return guarded(error, [&] { needed(surface, "surface").surface.update(span_of(positions, "positions")); });
}

glark_floats glark_qas_surface_limit_positions(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  return floats_of(surface->surface.limit_positions());
}
glark_floats glark_qas_surface_limit_normals(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  return floats_of(surface->surface.limit_normals());
}
glark_qas_patches glark_qas_surface_patches(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  const auto patches = surface->surface.patches();
  return {reinterpret_cast<const glark_qas_patch*>(patches.data()), patches.size()};
}
glark_indices glark_qas_surface_corner_vertices(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  const auto vertices = surface->surface.corner_vertices();
  return {vertices.empty() ? nullptr : vertices.front().data(), 2 * vertices.size()};
}

size_t glark_qas_surface_corner_count(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  return surface->surface.corner_count();
}
glark_code glark_qas_surface_write_corners(const glark_qas_surface* surface, glark_qas_corner* corners, size_t count,
                                           glark_error* error) {
  return guarded(error, [&] {
    needed(surface, "surface")
        .surface.write_corners(span_of(reinterpret_cast<qas::Corner*>(corners), count, "corners"));
  });
}
size_t glark_qas_surface_quartic_corner_count(const glark_qas_surface* surface) {
  if (surface == nullptr) return {};
  return surface->surface.quartic_corner_count();
}
glark_code glark_qas_surface_write_quartic_corners(const glark_qas_surface* surface, glark_qas_quartic_corner* corners,
                                                   size_t count, glark_error* error) {
  return guarded(error, [&] {
    needed(surface, "surface")
        .surface.write_quartic_corners(span_of(reinterpret_cast<qas::QuarticCorner*>(corners), count, "corners"));
  });
}

glark_code glark_qas_surface_evaluate(const glark_qas_surface* surface, size_t patch, const float barycentric[3],
                                      glark_qas_sample* sample, glark_error* error) {
  return guarded(error,
                 [&] { store(needed(surface, "surface").surface.evaluate(patch, weights_of(barycentric)), sample); });
}
glark_code glark_qas_surface_evaluate_quartic(const glark_qas_surface* surface, size_t triangle,
                                              const float barycentric[3], glark_qas_sample* sample,
                                              glark_error* error) {
  return guarded(error, [&] {
    store(needed(surface, "surface").surface.evaluate_quartic(triangle, weights_of(barycentric)), sample);
  });
}

glark_code glark_qas_loop_surface_create(const glark_qas_mesh* mesh, glark_qas_loop_surface** surface,
                                         glark_error* error) {
  return guarded(error, [&] {
    const qas::Mesh given = mesh_of(needed(mesh, "mesh"));
    glark_qas_loop_surface*& result = needed(surface, "surface");
    result = std::make_unique<glark_qas_loop_surface>(glark_qas_loop_surface{qas::LoopSurface(given)}).release();
  });
}

void glark_qas_loop_surface_free(glark_qas_loop_surface* surface) { std::unique_ptr<glark_qas_loop_surface>{surface}; }

glark_code glark_qas_loop_surface_update(glark_qas_loop_surface* surface, glark_floats positions, glark_error* error) {
  return guarded(error, [&] { needed(surface, "surface").surface.update(span_of(positions, "positions")); });
}
glark_code glark_qas_loop_surface_evaluate(const glark_qas_loop_surface* surface, size_t triangle,
                                           const float barycentric[3], glark_qas_sample* sample, glark_error* error) {
  return guarded(
      error, [&] { store(needed(surface, "surface").surface.evaluate(triangle, weights_of(barycentric)), sample); });
}
glark_code glark_qas_loop_surface_refine(const glark_qas_loop_surface* surface, unsigned level,
                                         glark_qas_sample* samples, size_t count, unsigned threads,
                                         glark_error* error) {
  return guarded(error, [&] {
    needed(surface, "surface")
        .surface.refine(level, span_of(reinterpret_cast<qas::Sample*>(samples), count, "samples"), threads);
  });
}

char* glark_qas_refinement_shader(const glark_qas_shader_inputs* inputs) {
  return text_of([&] {
    qas::ShaderInputs names;
    if (inputs != nullptr) {
      name(names.position, inputs->position);
      name(names.edge_position, inputs->edge_position);
      name(names.normal, inputs->normal);
      name(names.edge_normal, inputs->edge_normal);
    }
    return qas::refinement_shader(names);
  });
}

char* glark_qas_quartic_refinement_shader(const char* points, const char* normals) {
  return text_of([&] {
    return points == nullptr || normals == nullptr ? qas::quartic_refinement_shader()
                                                   : qas::quartic_refinement_shader(points, normals);
  });
}

void glark_qas_text_free(char* text) { std::unique_ptr<char[]>{text}; }
