// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/surface.h"

#include <algorithm>

namespace glark::conformance {
namespace {

double distance(const reference::Vector& a, const reference::Vector& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

template <std::size_t n>
void attribute_array(GLenum attribute, const std::vector<std::array<float, n>>& values) {
  if (values.empty()) return;
  GLint index = 0;
  GLuint buffer = 0;
  gl.GetIntegerv(attribute, &index);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(values[0])), values.data(),
                GL_STATIC_DRAW);
  gl.VertexAttribPointer(static_cast<GLuint>(index), n, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(static_cast<GLuint>(index));
}

std::string place_of(const SurfaceVertex& vertex) {
  return "triangle " + as_text(vertex.triangle) + " at (" + as_text(vertex.weights[0]) + ", " +
         as_text(vertex.weights[1]) + ", " + as_text(vertex.weights[2]) + ")";
}

}  // namespace

GLuint surface_program(Test& t, const SurfaceNames& names) {
  return build_program(
      t,
      {.vertex = "layout(location = 0) in vec4 " + names.position + "; layout(location = 1) in vec3 " + names.normal +
                 ";\n"
                 "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                 "layout(location = 4) in vec2 " +
                 names.texture +
                 ";\n"
                 "out vec3 normal_out; out vec3 weights_out; out float triangle_out; out vec2 texture_out;\n"
                 "out vec4 colour;\n"
                 "void main() { gl_Position = " +
                 names.position + "; normal_out = " + names.normal +
                 "; weights_out = weights;\n"
                 "  triangle_out = triangle; texture_out = " +
                 names.texture + "; colour = vec4(weights, 1.0); }\n",
       .captured = {"gl_Position", "normal_out", "weights_out", "triangle_out", "texture_out"}});
}

Mesh bent_mesh() {
  const Vec4 places[4] = {
      {-0.7F, -0.6F, 0.1F, 1}, {0.8F, -0.5F, -0.2F, 1}, {0.15F, 0.75F, 0.3F, 1}, {-0.65F, 0.6F, -0.4F, 1}};
  const Vec3 normals[4] = {{-0.5F, -0.3F, 0.9F}, {0.6F, -0.2F, 1.3F}, {0.1F, 0.7F, 0.4F}, {-0.8F, 0.35F, 0.2F}};
  const Vec2 texture[4] = {{0.1F, 0.2F}, {0.85F, 0.15F}, {0.7F, 0.9F}, {0.05F, 0.75F}};
  Mesh mesh;
  for (const std::size_t i : {0U, 1U, 2U, 2U, 3U, 0U}) {
    MeshVertex vertex;
    vertex.position = places[i];
    vertex.normal = normals[i];
    vertex.texture = texture[i];
    mesh.push_back(vertex);
  }
  number_triangles(mesh);
  return mesh;
}

void upload_shape_tags(const ShapeTags& tags) {
  attribute_array(GL_DISCONTINUITY_ATTRIBUTE_ARK, tags.discontinuities);
  attribute_array(GL_SCALAR_TAG_ATTRIBUTE_ARK, tags.scalars);
}

reference::Corners corners_of(const Mesh& mesh, std::size_t triangle, const ShapeTags& tags) {
  reference::Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = 3 * triangle + i;
    corners[i].position = mesh[k].position;
    corners[i].normal = mesh[k].normal;
    if (!tags.discontinuities.empty()) corners[i].discontinuity = tags.discontinuities[k];
    if (!tags.scalars.empty()) corners[i].tags = tags.scalars[k];
  }
  return corners;
}

std::vector<SurfaceVertex> capture_surface(Test& t, const Mesh& mesh) {
  const auto count = static_cast<GLsizei>(mesh.size());
  return capture_as<SurfaceVertex>(t, 20000, [count] { gl.DrawArrays(GL_TRIANGLES, 0, count); });
}

void expect_surface(Test& t, const std::vector<SurfaceVertex>& vertices, const Mesh& mesh, const ShapeTags& tags,
                    SurfaceOf surface, double tolerance) {
  t.require(vertices.size() > mesh.size(), "the mesh is refined");
  std::vector<bool> has_failed(mesh.size() / 3, false);
  for (const SurfaceVertex& vertex : vertices) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    t.require(triangle < has_failed.size(), "every refined vertex belongs to a coarse triangle");
    if (has_failed[triangle]) continue;
    const reference::Surface expected = surface(corners_of(mesh, triangle, tags), vertex.weights);
    const double off = distance(reference::vector_of(vertex.position), expected.position);
    const double turned = distance(reference::vector_of(vertex.normal), expected.normal);
    const bool holds =
        t.expect(off <= tolerance, "the position in " + place_of(vertex) + " is off by " + as_text(off)) &&
        t.expect(turned <= tolerance, "the normal in " + place_of(vertex) + " is off by " + as_text(turned));
    has_failed[triangle] = !holds;
  }
}

bool same_position(const Vec4& a, const Vec4& b) { return a == b; }

}  // namespace glark::conformance
