// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A scan as a coarse mesh with a displacement map, as `glark bake` writes it, without any shader. OpenGL refines edges into
// segments of a few pixels, and moves the refined vertices along their normals by the heights in the map. Vertices are
// there twice where two charts of the map meet, so the draw is welded.
//
//   relief MODEL.glb [OUT.png]
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <GL/glark.h>
#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

std::string file;
std::vector<float> positions, normals, coordinates;
std::vector<std::uint32_t> triangles;
float middle[3] = {}, radius = 1;
bool displaces = true;
GLint pixels = 4;  // the longest segment of an edge

[[noreturn]] void fail(const std::string& fault) { throw std::runtime_error(file + " " + fault + "; bake it again"); }

// The values of an accessor, packed as bake writes them.
template <class Value>
std::vector<Value> values_of(const tinygltf::Model& model, int index, std::size_t width) {
  if (index < 0) fail("lacks an attribute or the indices");
  const tinygltf::Accessor& accessor = model.accessors.at(index);
  const tinygltf::BufferView& view = model.bufferViews.at(accessor.bufferView);
  const std::vector<unsigned char>& bytes = model.buffers.at(view.buffer).data;
  const std::size_t first = view.byteOffset + accessor.byteOffset, size = accessor.count * width * sizeof(Value);
  if (accessor.ByteStride(view) != static_cast<int>(width * sizeof(Value)) || first + size > bytes.size())
    fail("has an attribute of another type");
  std::vector<Value> values(accessor.count * width);
  std::memcpy(values.data(), &bytes[first], size);
  return values;
}

// Makes a texture in a unit. The first row is the upper one, as in glTF, so texture coordinates are as in the file.
void make_texture(GLenum unit, int width, int height, GLint kept, GLenum format, GLenum type, const void* texels) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, kept, width, height, 0, format, type, texels);
}

// Texture unit 0 has the colours. Unit 1 has the heights, and is not enabled, so that the fixed function ignores it.
void load_heights(const tinygltf::Value& displacement) {
  if (!displacement.Has("uri") || !displacement.Get("uri").IsString()) fail("names no displacement file");
  const std::string path = std::filesystem::path(file).replace_filename(displacement.Get("uri").Get<std::string>());
  int width = 0, height = 0, channels = 0;
  stbi_us* heights = stbi_is_16_bit(path.c_str()) ? stbi_load_16(path.c_str(), &width, &height, &channels, 1) : nullptr;
  if (heights == nullptr || channels != 1) fail("needs 16-bit grey in " + path);
  make_texture(1, width, height, GL_R16, GL_RED, GL_UNSIGNED_SHORT, heights);
  stbi_image_free(heights);
  if (!displacement.Has("scale") || !displacement.Has("bias")) fail("has no scale or bias");
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, float(displacement.Get("scale").GetNumberAsDouble()));
  glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, float(displacement.Get("bias").GetNumberAsDouble()));
}

void begin() {
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error, warning;
  if (!reader.LoadBinaryFromFile(&model, &error, &warning, file))
    fail("is no GLB file (" + error.substr(0, error.find('\n')) + ")");
  if (model.meshes.size() != 1 || model.materials.size() != 1) fail("has not one mesh and one material");
  tinygltf::Primitive& primitive = model.meshes[0].primitives.at(0);
  const auto attribute = [&](const char* name) { return primitive.attributes.try_emplace(name, -1).first->second; };
  positions = values_of<float>(model, attribute("POSITION"), 3);
  normals = values_of<float>(model, attribute("NORMAL"), 3);
  coordinates = values_of<float>(model, attribute("TEXCOORD_0"), 2);
  triangles = values_of<std::uint32_t>(model, primitive.indices, 1);
  const tinygltf::Accessor& box = model.accessors[attribute("POSITION")];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] = static_cast<float>(box.minValues.at(axis) + box.maxValues.at(axis)) / 2;
    radius = std::hypot(axis == 0 ? 0 : radius, static_cast<float>(box.maxValues[axis]) - middle[axis]);
  }

  glARKinit(7);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const tinygltf::Material& material = model.materials[0];
  if (!material.extras.Has("displacement")) fail("has no extras.displacement");
  load_heights(material.extras.Get("displacement"));
  lesson::light();
  const int colours = material.pbrMetallicRoughness.baseColorTexture.index;
  if (colours < 0) return;
  const tinygltf::Image& image = model.images.at(model.textures.at(colours).source);
  make_texture(0, image.width, image.height, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, image.image.data());
  glEnable(GL_TEXTURE_2D);
}

void draw_mesh() {
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) glEnableClientState(array);
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  glNormalPointer(GL_FLOAT, 0, normals.data());
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.size()), GL_UNSIGNED_INT, triangles.data());
}

void draw(double) {
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, displaces ? 1 : -1);
  lesson::look(2.8F * radius, 30, 20);
  glTranslatef(-middle[0], -middle[1], -middle[2]);
  draw_mesh();
  lesson::say("%zu coarse triangles, %u refined ones", triangles.size() / 3, lesson::count_triangles(draw_mesh));
}

}  // namespace

int main(int argc, char** argv) {
  const lesson::Lesson relief{
      .title = "relief",
      .keys = {{'d', "displacement on or off", [] { displaces = !displaces; }},
               {'p', "longer segments, then short ones", [] { pixels = pixels < 64 ? 2 * pixels : 2; }}},
      .begin = begin,
      .draw = draw};
  if (argc < 2) std::puts("relief draws what `glark bake SCAN -o MODEL.glb` wrote. Usage: relief MODEL.glb [OUT.png]");
  if (argc < 2) return 2;
  if (argv[1][0] == '-') return lesson::run(argc, argv, relief);  // --help
  file = std::exchange(argv[1], argv[0]);
  return lesson::run(argc - 1, argv + 1, relief);
}
