// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/mapped_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

#include "glark/tool/scan/console.h"
#include "glark/tool/view/draw/gl.h"

namespace glark::tool {
namespace {

constexpr char vertex_source[] =
#include "glark/tool/view/draw/mapped.vert.glsl.inc"
    ;
constexpr char fragment_source[] =
#include "glark/tool/view/draw/mapped.frag.glsl.inc"
    ;

// Where generic attributes are those of the fixed functions, too, no fixed function has these two.
constexpr GLuint tangent_attribute = 6, base_direction_attribute = 7;
enum Unit : GLint { colours_unit, normals_unit, heights_unit };

const void* offset(std::size_t floats) { return std::bit_cast<const void*>(floats * sizeof(float)); }

GLuint compile(GLenum stage, const char* source) {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  return shader;
}

GLuint build_program() {
  const GLuint program = gl.CreateProgram();
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex_source), compile(GL_FRAGMENT_SHADER, fragment_source)}) {
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  }
  gl.BindAttribLocation(program, tangent_attribute, "tangent");
  gl.BindAttribLocation(program, base_direction_attribute, "base_direction");
  gl.LinkProgram(program);
  GLint is_linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return program;
  char log[1024] = "";
  gl.GetProgramInfoLog(program, sizeof(log), nullptr, log);
  gl.DeleteProgram(program);
  throw std::runtime_error(fmt::format("the shaders of maps do not build with this OpenGL: {}; use --maps plain", log));
}

struct Texels {
  GLint internal_format;
  GLenum format, type;
  const void* data;
};

// Returns 0, with a warning, if the picture is too large.
GLuint make_texture(const std::string& name, int width, int height, const Texels& texels, bool has_levels) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width > most || height > most) {
    warn(fmt::format("{}: it has {} x {} texels, and this OpenGL holds {} a side; it is left out, bake a smaller one",
                     name, width, height, most));
    return 0;
  }
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, texels.internal_format, width, height, 0, texels.format, texels.type, texels.data);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, has_levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  if (has_levels) gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

GLuint make_texture(const std::string& name, const std::optional<Picture>& picture) {
  if (!picture) return 0;
  return make_texture(name, picture->width, picture->height,
                      {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, picture->texels.data()}, true);
}

void bind_texture(Unit unit, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

MappedMesh::MappedMesh(const geometry::Geometry& geometry, const Maps& maps)
    : program_(build_program()), point_count_(geometry.point_count()), index_count_(geometry.triangles.size()) {
  upload(geometry, maps);
  colours_ = make_texture(maps.file + ": baseColorTexture", maps.colours);
  normals_ = make_texture(maps.file + ": normalTexture", maps.normals);
  if (!maps.displacement) return;
  const Heights& heights = maps.displacement->heights;
  heights_ = make_texture(maps.file + ": displacement", heights.width, heights.height,
                          {GL_R16, GL_RED, GL_UNSIGNED_SHORT, heights.texels.data()}, false);
  scale_ = maps.displacement->scale;
  bias_ = maps.displacement->bias;
}

MappedMesh::~MappedMesh() {
  for (const GLuint buffer : {points_, triangles_}) gl.DeleteBuffers(1, &buffer);
  for (const GLuint texture : {colours_, normals_, heights_}) gl.DeleteTextures(1, &texture);
  gl.DeleteProgram(program_);
}

MapsShown MappedMesh::most() const {
  if (heights_ != 0) return MapsShown::displaced;
  return colours_ != 0 || normals_ != 0 ? MapsShown::normal : MapsShown::plain;
}

float MappedMesh::greatest_displacement() const {
  return heights_ == 0 ? 0 : std::max(std::abs(bias_), std::abs(scale_ + bias_));
}

// Positions, normals, texture coordinates and tangents, one array after the other.
void MappedMesh::upload(const geometry::Geometry& geometry, const Maps& maps) {
  std::vector<float> values;
  values.reserve(point_count_ * 12);
  for (const std::vector<float>* array :
       {&geometry.positions, &geometry.normals, &maps.texture_coordinates, &maps.tangents})
    values.insert(values.end(), array->begin(), array->end());
  values.resize(point_count_ * 12);  // without tangents, they are zero
  gl.GenBuffers(1, &points_);
  gl.BindBuffer(GL_ARRAY_BUFFER, points_);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(), GL_STATIC_DRAW);
  gl.GenBuffers(1, &triangles_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index_count_ * sizeof(std::uint32_t)),
                geometry.triangles.data(), GL_STATIC_DRAW);
}

void MappedMesh::bind() const {
  gl.BindBuffer(GL_ARRAY_BUFFER, points_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) gl.EnableClientState(array);
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, offset(0));
  gl.NormalPointer(GL_FLOAT, 0, offset(3 * point_count_));
  gl.TexCoordPointer(2, GL_FLOAT, 0, offset(6 * point_count_));
  gl.EnableVertexAttribArray(tangent_attribute);
  gl.EnableVertexAttribArray(base_direction_attribute);
  gl.VertexAttribPointer(tangent_attribute, 4, GL_FLOAT, GL_FALSE, 0, offset(8 * point_count_));
  gl.VertexAttribPointer(base_direction_attribute, 3, GL_FLOAT, GL_FALSE, 0, offset(3 * point_count_));
  bind_texture(heights_unit, heights_);
  bind_texture(normals_unit, normals_);
  bind_texture(colours_unit, colours_);
  const auto uniform = [&](const char* name) { return gl.GetUniformLocation(program_, name); };
  gl.UseProgram(program_);
  gl.Uniform1i(uniform("colours"), colours_unit);
  gl.Uniform1i(uniform("normals"), normals_unit);
  gl.Uniform1i(uniform("has_colours"), colours_ != 0 ? 1 : 0);
  gl.Uniform1i(uniform("has_normals"), normals_ != 0 ? 1 : 0);
  gl.Uniform3f(uniform("colour"), colour_without_texture[0], colour_without_texture[1], colour_without_texture[2]);
}

void MappedMesh::unbind() const {
  gl.UseProgram(0);
  gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.DisableVertexAttribArray(tangent_attribute);
  gl.DisableVertexAttribArray(base_direction_attribute);
  for (const Unit unit : {heights_unit, normals_unit, colours_unit}) bind_texture(unit, 0);
}

// The charts of the pictures have vertices of their own where they meet. WELD_ARK closes the cracks between them.
void MappedMesh::displace(const DrawSettings& settings) const {
  need_patterns(deepest_measured_level);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, settings.edge_pixels > 0 ? GL_MEASURED_DEPTH_ARK : GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, std::clamp(settings.level, 0, deepest_level));
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, settings.edge_pixels);
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, settings.budget);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, heights_unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, scale_);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, bias_);
  gl.Enable(GL_ARK);
}

std::size_t MappedMesh::draw(MapsShown shown, const DrawSettings& settings) const {
  bind();
  const bool displaced = shown == MapsShown::displaced && heights_ != 0;
  if (displaced) displace(settings);
  gl.PolygonMode(GL_FRONT_AND_BACK, settings.lines ? GL_LINE : GL_FILL);
  const std::size_t triangles = triangles_made_by(
      [&] { gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(index_count_), GL_UNSIGNED_INT, nullptr); });
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  if (displaced) {
    gl.Disable(GL_ARK);
    gl.ARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
  }
  unbind();
  return triangles;
}

}  // namespace glark::tool
