// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/maps.h>
#include <glark/maps.h>

#include <memory>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
using glark::c::span_of;
namespace maps = glark::maps;
namespace stream = glark::stream;

struct glark_maps_model {
  maps::Baked baked;
};

namespace {

static_assert(static_cast<int>(maps::Element::option) == GLARK_MAPS_OPTION);
static_assert(static_cast<int>(maps::Element::array) == GLARK_MAPS_ARRAY);
static_assert(static_cast<int>(maps::Element::triangle) == GLARK_MAPS_TRIANGLE);
static_assert(static_cast<int>(maps::Element::point) == GLARK_MAPS_POINT);
static_assert(static_cast<int>(maps::Element::file) == GLARK_MAPS_FILE);
static_assert(static_cast<int>(maps::Texcoords::automatic) == GLARK_MAPS_TEXCOORDS_AUTOMATIC);
static_assert(static_cast<int>(maps::Texcoords::own) == GLARK_MAPS_TEXCOORDS_OWN);
static_assert(static_cast<int>(maps::Texcoords::charts) == GLARK_MAPS_TEXCOORDS_CHARTS);

glark_maps_element element_of(stream::Element element) {
  switch (element) {
    case stream::Element::file: return GLARK_MAPS_FILE;
    case stream::Element::point: return GLARK_MAPS_POINT;
    case stream::Element::option: break;
  }
  return GLARK_MAPS_OPTION;
}

// Errors of the source name its file or a point of it.
template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  int element = GLARK_NO_ELEMENT;
  std::size_t index = 0;
  const glark_code code = glark::c::guarded<maps::Error>(error, [&] {
    try {
      step();
    } catch (const stream::Error& bad) {
      element = element_of(bad.element());
      index = bad.index();
      throw;
    }
  });
  if (error != nullptr && element != GLARK_NO_ELEMENT) {
    error->element = element;
    error->index = index;
  }
  return code;
}

std::array<double, 3> origin_of(const double (&origin)[3]) { return {origin[0], origin[1], origin[2]}; }

maps::CoarseMesh coarse_of(const glark_maps_coarse_mesh& mesh) {
  return {.origin = origin_of(mesh.origin),
          .positions = span_of(mesh.positions, "positions"),
          .normals = span_of(mesh.normals, "normals"),
          .triangles = span_of(mesh.triangles, "triangles"),
          .texcoords = span_of(mesh.texcoords, "texcoords")};
}

maps::FineMesh fine_of(const glark_maps_fine_mesh& mesh) {
  return {.origin = origin_of(mesh.origin),
          .positions = span_of(mesh.positions, "positions of the fine mesh"),
          .normals = span_of(mesh.normals, "normals of the fine mesh"),
          .colours = span_of(mesh.colours, "colours of the fine mesh"),
          .triangles = span_of(mesh.triangles, "triangles of the fine mesh")};
}

maps::BakeOptions options_of(const glark_maps_options* given) {
  maps::BakeOptions options;
  if (given == nullptr) return options;
  options.texture_memory = given->texture_memory;
  options.most_side = given->most_side;
  options.noise = given->noise;
  options.texels_per_point = given->texels_per_point;
  options.reach = given->reach;
  options.skip_invalid = given->skip_invalid;
  options.threads = given->threads;
  options.width = given->width;
  options.height = given->height;
  options.texcoords = static_cast<maps::Texcoords>(given->texcoords);
  return options;
}

glark_maps_model* bake(const glark_maps_coarse_mesh& mesh, const stream::Source& source,
                       const glark_maps_options* options) {
  return std::make_unique<glark_maps_model>(glark_maps_model{maps::bake(coarse_of(mesh), source, options_of(options))})
      .release();
}

glark_maps_jump jump_of(const maps::Jump& jump) { return {jump.greatest, jump.root_mean_square}; }

}  // namespace

glark_maps_options glark_maps_default_options(void) {
  const maps::BakeOptions options;
  return {options.texture_memory, options.most_side,
          options.noise,          options.texels_per_point,
          options.reach,          options.skip_invalid,
          options.threads,        options.width,
          options.height,         GLARK_MAPS_TEXCOORDS_AUTOMATIC};
}

glark_code glark_maps_bake_file(const glark_maps_coarse_mesh* mesh, const char* file, const char* format,
                                const glark_maps_options* options, glark_maps_model** model, glark_error* error) {
  return guarded(error, [&] {
    glark_maps_model*& result = needed(model, "model");
    const stream::Source source = stream::file_source(&needed(file, "file"), format == nullptr ? "" : format);
    result = bake(needed(mesh, "mesh"), source, options);
  });
}

glark_code glark_maps_bake_mesh(const glark_maps_coarse_mesh* mesh, const glark_maps_fine_mesh* fine, double spacing,
                                const glark_maps_options* options, glark_maps_model** model, glark_error* error) {
  return guarded(error, [&] {
    glark_maps_model*& result = needed(model, "model");
    result = bake(needed(mesh, "mesh"), maps::mesh_source(fine_of(needed(fine, "fine")), spacing), options);
  });
}

void glark_maps_model_free(glark_maps_model* model) { std::unique_ptr<glark_maps_model>{model}; }

glark_floats glark_maps_positions(const glark_maps_model* model) {
  return model == nullptr ? glark_floats{} : array_of(model->baked.positions);
}
glark_floats glark_maps_normals(const glark_maps_model* model) {
  return model == nullptr ? glark_floats{} : array_of(model->baked.normals);
}
glark_floats glark_maps_tangents(const glark_maps_model* model) {
  return model == nullptr ? glark_floats{} : array_of(model->baked.tangents);
}
glark_floats glark_maps_texcoords(const glark_maps_model* model) {
  return model == nullptr ? glark_floats{} : array_of(model->baked.texcoords);
}
glark_indices glark_maps_triangles(const glark_maps_model* model) {
  return model == nullptr ? glark_indices{} : array_of(model->baked.triangles);
}
glark_bytes glark_maps_normal_map(const glark_maps_model* model) {
  return model == nullptr ? glark_bytes{} : array_of(model->baked.normal_map);
}
glark_bytes glark_maps_colour_map(const glark_maps_model* model) {
  return model == nullptr ? glark_bytes{} : array_of(model->baked.colour_map);
}
glark_maps_heights glark_maps_displacement_map(const glark_maps_model* model) {
  if (model == nullptr) return {};
  return {model->baked.displacement_map.data(), model->baked.displacement_map.size()};
}

glark_maps_frame glark_maps_model_frame(const glark_maps_model* model) {
  if (model == nullptr) return {};
  const maps::Baked& baked = model->baked;
  return {{baked.origin[0], baked.origin[1], baked.origin[2]}, baked.width, baked.height, baked.scale, baked.bias};
}

glark_maps_counts glark_maps_model_counts(const glark_maps_model* model) {
  if (model == nullptr) return {};
  const maps::Baked& baked = model->baked;
  return {baked.points,       baked.left_out, baked.invalid, baked.charts,
          baked.empty_charts, baked.texels,   baked.filled,  baked.reach};
}

bool glark_maps_has_own_texcoords(const glark_maps_model* model) {
  return model != nullptr && model->baked.has_own_texcoords;
}

glark_maps_seams glark_maps_model_seams(const glark_maps_model* model) {
  if (model == nullptr) return {};
  const maps::SeamJumps& seams = model->baked.seams;
  return {jump_of(seams.colour), jump_of(seams.normal), jump_of(seams.displacement), seams.edges};
}

glark_code glark_maps_write_model(const char* file, const glark_maps_model* model, glark_error* error) {
  return guarded(error, [&] { maps::write_model(&needed(file, "file"), needed(model, "model").baked); });
}
