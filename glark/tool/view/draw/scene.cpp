// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "glark/tool/view/draw/gl.h"
#include "glark/tool/view/draw/shading.h"

namespace glark::tool {
namespace {

constexpr float splat_overlap = 2.4F;
constexpr std::size_t most_points_to_strip_unasked = 1000000;

const void* offset(std::size_t bytes) { return std::bit_cast<const void*>(bytes); }

template <class Value>
std::uint32_t make_buffer(GLenum target, std::span<const Value> values) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STATIC_DRAW);
  return buffer;
}

GLint token_of(Refinement refinement) {
  switch (refinement) {
    case Refinement::phong: return GL_PHONG_ARK;
    case Refinement::linear: return GL_LINEAR_INPUTS_ARK;
    default: return GL_CURVED_PN_ARK;
  }
}

}  // namespace

void clear_window() {
  gl.ClearColor(0.16F, 0.17F, 0.19F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Scene::Scene(geometry::Geometry geometry, const std::optional<Maps>& maps) : geometry_(std::move(geometry)) {
  low_ = glm::vec3(std::numeric_limits<float>::infinity());
  high_ = -low_;
  for (std::size_t i = 0; i < geometry_.positions.size(); i += 3) {
    const glm::vec3 position = glm::make_vec3(&geometry_.positions[i]);
    low_ = glm::min(low_, position);
    high_ = glm::max(high_, position);
  }
  spacing_ = estimated_spacing(geometry_.positions, low_, high_);
  if (geometry_.normals.empty() && !geometry_.triangles.empty()) geometry_.normals = normals_of_triangles(geometry_);
  has_lighting_ = !geometry_.normals.empty();
  if (!has_lighting_ && geometry_.colours.empty())
    geometry_.colours = colours_by_height(geometry_.positions, low_.z, high_.z);
  upload();
  if (maps) mapped_ = std::make_unique<MappedMesh>(geometry_, *maps);
}

Scene::~Scene() {
  for (const GLuint buffer : {points_buffer_, triangles_buffer_, strips_buffer_}) gl.DeleteBuffers(1, &buffer);
}

Mode Scene::default_mode() const {
  if (!geometry_.triangles.empty()) return Mode::mesh;
  return geometry_.point_count() > most_points_to_strip_unasked ? Mode::splat : Mode::strip;
}

MapsShown Scene::most_maps() const { return mapped_ ? mapped_->most() : MapsShown::plain; }

Camera Scene::default_camera() const {
  Camera camera;
  const glm::vec3 size = high_ - low_;
  camera.target = (low_ + high_) / 2.0F;
  const float beyond = mapped_ ? mapped_->greatest_displacement() : 0;
  camera.radius = std::max(glm::length(size) / 2 + beyond, std::numeric_limits<float>::min() * 1e6F);
  // Flat terrain extends little in z and is seen from above.
  camera.z_is_up = 4 * size.z < std::min(size.x, size.y);
  if (camera.z_is_up) camera.pitch = 40;
  return camera;
}

void Scene::upload() {
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  gl.GenBuffers(1, &points_buffer_);
  gl.BindBuffer(GL_ARRAY_BUFFER, points_buffer_);
  const std::size_t normals_at = bytes(geometry_.positions);
  const std::size_t colours_at = normals_at + bytes(geometry_.normals);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(colours_at + bytes(geometry_.colours)), nullptr,
                GL_STATIC_DRAW);
  const auto put = [&](std::size_t at, const auto& values) {
    gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(at), static_cast<GLsizeiptr>(bytes(values)), values.data());
  };
  put(0, geometry_.positions);
  put(normals_at, geometry_.normals);
  put(colours_at, geometry_.colours);
  if (!geometry_.triangles.empty())
    triangles_buffer_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(geometry_.triangles));
}

// Client arrays belong to the context, so each model binds its own.
void Scene::bind() const {
  const std::size_t normals_at = geometry_.positions.size() * sizeof(float);
  const std::size_t colours_at = normals_at + geometry_.normals.size() * sizeof(float);
  const auto enable = [](GLenum array, bool on) { on ? gl.EnableClientState(array) : gl.DisableClientState(array); };
  gl.BindBuffer(GL_ARRAY_BUFFER, points_buffer_);
  enable(GL_VERTEX_ARRAY, true);
  enable(GL_NORMAL_ARRAY, has_lighting_);
  enable(GL_COLOR_ARRAY, !geometry_.colours.empty());
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  if (has_lighting_) gl.NormalPointer(GL_FLOAT, 0, offset(normals_at));
  if (!geometry_.colours.empty()) gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, offset(colours_at));
}

void Scene::upload_again() {
  gl.DeleteBuffers(1, &points_buffer_);
  gl.DeleteBuffers(1, &triangles_buffer_);
  upload();
}

void Scene::colour_by(std::span<const float> distances, float greatest) {
  geometry_.colours = colours_by_distance(distances, greatest);
  upload_again();
}

void Scene::replace_points(std::vector<float> positions, std::vector<float> normals,
                           std::vector<std::uint8_t> colours) {
  if (positions.size() != geometry_.positions.size()) strips_.reset();
  geometry_.positions = std::move(positions);
  geometry_.normals = std::move(normals);
  geometry_.colours = std::move(colours);
  has_lighting_ = !geometry_.normals.empty();
  upload_again();
}

void Scene::make_strips() {
  if (strips_) return;
  strips_.emplace(surfel::Cloud{geometry_.positions, geometry_.normals});
  gl.DeleteBuffers(1, &strips_buffer_);
  strips_buffer_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, strips_->indices());
}

void Scene::set_light(const Look& look) const {
  const float right = glm::radians(look.light_right);
  const float above = glm::radians(look.light_above);
  const GLfloat direction[4] = {std::sin(right) * std::cos(above), std::sin(above), std::cos(right) * std::cos(above),
                                0};
  const GLfloat shine[4] = {look.specular, look.specular, look.specular, 1};
  const GLfloat ambient[4] = {look.ambient, look.ambient, look.ambient, 1};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, direction);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, look.shininess);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
}

void Scene::set_up(const Camera& camera, const Look& look, const Part& part) const {
  bind();
  gl.Viewport(part.x, 0, part.width, part.height);
  gl.Enable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixf(glm::value_ptr(camera.projection(part.width, part.height)));
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  set_light(look);
  gl.LoadMatrixf(glm::value_ptr(camera.view()));
  gl.Color3fv(colour_without_texture.data());
  gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL, GL_NORMALIZE})
    if (has_lighting_)
      gl.Enable(capability);
    else
      gl.Disable(capability);
}

void Scene::draw_splats(const Camera& camera, int height) const {
  const float pixels =
      std::max(spacing_ * splat_overlap * camera.pixels_per_length(height), std::numeric_limits<float>::min());
  const GLfloat attenuation[3] = {0, 0, 1 / (pixels * pixels)};
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  gl.PointParameterf(GL_POINT_SIZE_MIN, 1);
  gl.PointSize(1);
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(geometry_.point_count()));
}

void Scene::draw_triangles() const {
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_buffer_);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(geometry_.triangles.size()), GL_UNSIGNED_INT, nullptr);
}

const surfel::Frame& Scene::select_strips(const Camera& camera, const DrawSettings& settings, const Part& part) {
  make_strips();
  bind();
  surfel::View view;
  const Camera& culled_from = settings.culled_from.value_or(camera);
  const glm::mat4 clip_from_object = culled_from.projection(part.width, part.height) * culled_from.view();
  std::copy_n(glm::value_ptr(clip_from_object), view.clip_from_object.size(), view.clip_from_object.begin());
  view.width = static_cast<unsigned>(part.width);
  view.height = static_cast<unsigned>(part.height);
  view.cull_frustum = settings.cull;
  view.cull_back_faces = settings.cull && has_lighting_;
  strips_->select(view, frame_);
  return frame_;
}

Statistics Scene::draw_strips(const Camera& camera, const DrawSettings& settings, const Part& part) {
  select_strips(camera, settings, part);
  const GLfloat none[3] = {1, 0, 0};
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, none);
  gl.PointSize(1);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, strips_buffer_);
  gl.MultiDrawElements(GL_TRIANGLE_STRIP, frame_.counts.data(), GL_UNSIGNED_INT, frame_.offsets.data(), frame_.draws());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  gl.DrawElements(GL_POINTS, static_cast<GLsizei>(frame_.points.size()), GL_UNSIGNED_INT, frame_.points.data());
  return {1,
          frame_.indices,
          frame_.points.size(),
          frame_.strips,
          frame_.visited,
          frame_.out_of_frustum,
          frame_.back_faces,
          {},
          0};
}

// Every coarse triangle has corners of its own here, which have its colour.
Statistics Scene::draw_patterns(const Camera& camera, const DrawSettings& settings, const Part& part) {
  const bool has_triangles = !geometry_.triangles.empty();
  std::vector<std::uint32_t> strip_triangles;
  if (!has_triangles) {
    const surfel::Frame& frame = select_strips(camera, settings, part);
    strip_triangles = triangles_of_strips(strips_->indices(), frame);
  }
  const EdgeDepths depths(camera.projection(part.width, part.height) * camera.view(), settings, part.width,
                          part.height);
  const ColouredTriangles coloured = colour_by_pattern(geometry_.positions, geometry_.normals,
                                                       has_triangles ? geometry_.triangles : strip_triangles, depths);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, coloured.positions.data());
  if (has_lighting_) gl.NormalPointer(GL_FLOAT, 0, coloured.normals.data());
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, coloured.colours.data());
  const std::size_t corners = coloured.positions.size() / 3;
  const std::size_t refined = triangles_made_by([&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners)); });
  return {1, corners, 0, 0, 0, 0, 0, coloured.counts, refined};
}

// Refines what is drawn until GL_ARK is off again.
void Scene::refine(const DrawSettings& settings) const {
  need_patterns(deepest_level);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, settings.edge_pixels > 0 ? GL_MEASURED_DEPTH_ARK : GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, std::clamp(settings.level, 0, deepest_level));
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, settings.edge_pixels);
  // The viewer cannot compute the depths of patterns that a budget chooses.
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, settings.mode == Mode::patterns ? 0 : settings.budget);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, has_lighting_ ? token_of(settings.refinement) : GL_LINEAR_OUTPUTS_ARK);
  gl.Enable(GL_ARK);
}

Statistics Scene::draw(const Camera& camera, const DrawSettings& settings, const Part& part) {
  set_up(camera, settings.look, part);
  if (const MapsShown shown = std::min(settings.maps, most_maps()); shown != MapsShown::plain) {
    const std::size_t triangles = mapped_->draw(shown, settings);
    return {1, geometry_.triangles.size(), 0, 0, 0, 0, 0, {}, shown == MapsShown::displaced ? triangles : 0};
  }
  if (settings.mode == Mode::splat) {
    draw_splats(camera, part.height);
    return {1, 0, geometry_.point_count(), 0, 0, 0, 0, {}, 0};
  }
  const bool patterns = settings.mode == Mode::patterns;
  const bool refined = patterns || settings.mode == Mode::refined;
  if (refined) refine(settings);
  const bool lines = settings.mode == Mode::wireframe || (refined && settings.lines);
  gl.PolygonMode(GL_FRONT_AND_BACK, lines ? GL_LINE : GL_FILL);
  Statistics statistics{1, geometry_.triangles.size(), 0, 0, 0, 0, 0, {}, 0};
  if (patterns)
    statistics = draw_patterns(camera, settings, part);
  else if (geometry_.triangles.empty())
    statistics = draw_strips(camera, settings, part);
  else
    draw_triangles();
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  if (refined) gl.Disable(GL_ARK);
  return statistics;
}

}  // namespace glark::tool
