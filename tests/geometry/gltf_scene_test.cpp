// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Nodes, textures and colours of glTF files.
#include <numbers>
#include <string>

#include "tests/geometry/material_files.h"
#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

// One triangle with normals, two sets of texture coordinates, and colours. Parts of the text are for the test to choose.
struct GltfText {
  std::string node = R"("mesh":0)";
  std::string more_nodes = {};
  std::string attributes = R"("POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":3)";
  std::string material = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
  std::string texture = R"("source":0)";
  std::string uri = "picture.png";
  std::string more = {};  // members of the file
  std::string primitives = {};

  std::string text() const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node + "}" + more_nodes +
           R"(],"meshes":[{"primitives":[{"attributes":{)" + attributes + R"(},"material":0})" + primitives +
           R"(]}],"materials":[{)" + material + R"(}],"textures":[{)" + texture + R"(}],"images":[{"uri":")" + uri +
           R"("}],"samplers":[{"wrapS":33648,"wrapT":33071}],)" + more +
           R"("buffers":[{"uri":"a.bin","byteLength":156}],"bufferViews":[)"
           R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},)"
           R"({"buffer":0,"byteOffset":72,"byteLength":24},{"buffer":0,"byteOffset":96,"byteLength":24},)"
           R"({"buffer":0,"byteOffset":120,"byteLength":36}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
           R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},)"
           R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},)"
           R"({"bufferView":3,"componentType":5126,"count":3,"type":"VEC2"},)"
           R"({"bufferView":4,"componentType":5126,"count":3,"type":"VEC3"}]})";
  }
};

class GltfScene : public TemporaryFolder {
 protected:
  Reading read(const GltfText& parts, bool images = true) {
    const std::array<float, 39> numbers{0, 0, 0, 1, 0,    0,    0,    1,   0,  //
                                        0, 0, 1, 0, 0.6F, 0.8F, 0,    0,   1,  // normals
                                        0, 1, 1, 1, 0,    0,                   // v is 1 - t
                                        0, 0, 0, 0, 0.5,  0.75,                //
                                        1, 1, 1, 1, 0,    0,    0.25, 0.5, 0.25};
    made("a.bin", {reinterpret_cast<const char*>(numbers.data()), sizeof(numbers)});
    made("picture.png", {png, sizeof(png) - 1});
    return read_file(made("a.gltf", parts.text()), {.images = images});
  }
};

void expect_near(const std::vector<float>& values, const std::vector<float>& wanted) {
  ASSERT_EQ(values.size(), wanted.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], wanted[i], 1e-6) << i;
}

TEST_F(GltfScene, ANodeThatMirrorsTurnsTriangles) {
  const Geometry geometry = read({.node = R"("mesh":0,"scale":[-1,2,1])"}).geometry;
  EXPECT_EQ(geometry.positions, (std::vector<float>{0, 0, 0, -1, 0, 0, 0, 2, 0}));
  EXPECT_EQ(geometry.triangles, (std::vector<std::uint32_t>{0, 2, 1}));  // seen from above as before
  // The inverse transpose halves y: (0, 0.3, 0.8).
  expect_near(geometry.normals, {0, 0, 1, 0, 0.35112344F, 0.93632918F, 0, 0, 1});
}

TEST_F(GltfScene, TwoMirrorsAreARotation) {
  const Geometry geometry = read({.node = R"("scale":[-1,1,1],"children":[1])",
                                  .more_nodes = R"(,{"mesh":0,"scale":[1,-1,1],"translation":[1,0,0]})"})
                                .geometry;
  EXPECT_EQ(geometry.positions, (std::vector<float>{-1, 0, 0, -2, 0, 0, -1, -1, 0}));
  EXPECT_EQ(geometry.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST_F(GltfScene, AMeshOfTwoNodesComesTwice) {
  const Geometry geometry =
      read({.node = R"("children":[1,2])", .more_nodes = R"(,{"mesh":0},{"mesh":0,"scale":[1,1,-1]})"}).geometry;
  EXPECT_EQ(geometry.triangles, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(geometry.triangle_images, (std::vector<std::uint32_t>{0, 0}));
}

TEST_F(GltfScene, TheMaterialChoosesItsTextureCoordinates) {
  expect_near(read({}).geometry.texture_coordinates, {0, 0, 1, 0, 0, 1});
  const Geometry geometry =
      read({.material = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}})"}).geometry;
  expect_near(geometry.texture_coordinates, {0, 1, 0, 1, 0.5, 0.25});
}

constexpr char uses_transforms[] = R"("extensionsUsed":["KHR_texture_transform"],)";

std::string with_transform(const std::string& transform) {
  return R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{)" +
         transform + "}}}}";
}

TEST_F(GltfScene, TransformsOfTexturesMoveTheirCoordinates) {
  const std::string material = with_transform(R"("offset":[0.5,0.25],"scale":[2,3])");
  // (u, v) becomes (2 u + 0.5, 3 v + 0.25), and t is 1 - v.
  expect_near(read({.material = material, .more = uses_transforms}).geometry.texture_coordinates,
              {0.5, -2.25, 2.5, -2.25, 0.5, 0.75});
}

TEST_F(GltfScene, TransformsOfTexturesTurnCounterClockwise) {
  const std::string material = with_transform(R"("rotation":1.5707963267948966)");
  // Seen on the picture, whose v points down, (u, v) becomes (v, -u).
  expect_near(read({.material = material, .more = uses_transforms}).geometry.texture_coordinates, {1, 1, 1, 2, 0, 1});
}

TEST_F(GltfScene, TransformsOfTexturesChooseOtherCoordinates) {
  const std::string material = with_transform(R"("texCoord":1,"offset":[1,0])");
  expect_near(read({.material = material, .more = uses_transforms}).geometry.texture_coordinates,
              {1, 1, 1, 1, 1.5, 0.25});
}

TEST_F(GltfScene, SamplersWrap) {
  const Image image = read({.texture = R"("source":0,"sampler":0)"}).geometry.images.at(0);
  EXPECT_EQ(image.wrap_s, Wrap::mirror);
  EXPECT_EQ(image.wrap_t, Wrap::clamp);
  EXPECT_EQ(read({}).geometry.images.at(0).wrap_s, Wrap::repeat);
}

TEST_F(GltfScene, ColoursOfVerticesTintPicturesAndFactors) {
  const std::string colours = R"("POSITION":0,"COLOR_0":4)";
  const Geometry geometry =
      read({.attributes = colours, .primitives = R"(,{"attributes":{"POSITION":0}},{"attributes":{"POSITION":1}})"})
          .geometry;
  EXPECT_TRUE(geometry.colours_tint_images);
  EXPECT_EQ(geometry.images.at(geometry.triangle_images.at(0)).pixels, png_pixels);
  EXPECT_EQ(geometry.images.at(geometry.triangle_images.at(1)).pixels, (std::vector<std::uint8_t>{255, 255, 255}));
  ASSERT_EQ(geometry.colours.size(), 28U);  // equal points are one
  EXPECT_EQ((std::vector<std::uint8_t>(geometry.colours.begin(), geometry.colours.begin() + 12)),
            (std::vector<std::uint8_t>{255, 255, 255, 255, 255, 0, 0, 255, 137, 188, 137, 255}));
  EXPECT_EQ(geometry.colours.at(12), 255);  // a mesh without colours is white

  // A grey factor counts if there are colours that it multiplies.
  const std::string grey = R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1]})";
  EXPECT_EQ(read({.attributes = colours, .material = grey}).geometry.images.size(), 2U);
  EXPECT_TRUE(read({.material = grey}).geometry.images.empty());
}

TEST_F(GltfScene, AlphaThatIsLostIsSaid) {
  const std::string factor = R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,0,0.5]})";
  const Reading blended = read({.material = factor + R"(,"alphaMode":"BLEND")"});
  ASSERT_EQ(blended.warnings.size(), 1U);
  EXPECT_NE(blended.warnings[0].find("no alpha"), std::string::npos);
  EXPECT_TRUE(read({.material = factor}).warnings.empty());  // an opaque material ignores its alpha
}

TEST_F(GltfScene, NamesOfPicturesAreUris) {
  made("sp ace %.png", {png, sizeof(png) - 1});
  EXPECT_EQ(read({.uri = "sp%20ace%20%25.png"}).geometry.images.at(0).width, 2U);
  made("50%25.png", {png, sizeof(png) - 1});  // some programs do not encode names
  EXPECT_EQ(read({.uri = "50%25.png"}).geometry.images.at(0).width, 2U);
  const Reading elsewhere = read({.uri = "http://x.invalid/a.png"});
  ASSERT_EQ(elsewhere.warnings.size(), 1U);
  EXPECT_NE(elsewhere.warnings[0].find("http://x.invalid/a.png is not on this machine"), std::string::npos);
}

TEST_F(GltfScene, NamesOfBuffersAreUris) {
  std::string text = GltfText().text();
  text.replace(text.find("a.bin"), 5, "b%20c.bin");
  made("b c.bin", std::string(156, '\0'));
  EXPECT_EQ(read_file(made("b.gltf", text), {}).geometry.triangle_count(), 1U);
}

TEST_F(GltfScene, PicturesOfExtensionsAreSaid) {
  const Reading reading = read({.texture = R"("extensions":{"KHR_texture_basisu":{"source":0}})"});
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_NE(reading.warnings[0].find("KHR_texture_basisu"), std::string::npos);
}

TEST_F(GltfScene, TheFirstVersionIsSaid) {
  const std::string problem =
      problem_with(made("a.glb", std::string("glTF\1\0\0\0\0\1\0\0", 12) + std::string(244, ' ')));
  EXPECT_NE(problem.find("is glTF 1.0"), std::string::npos) << problem;
  EXPECT_EQ(problem.find("$$$"), std::string::npos) << problem;
  const std::string text = problem_with(made("c.gltf", R"({"asset":{"version":"1.0"},"buffers":{"b":{}}})"));
  EXPECT_NE(text.find("is glTF 1.0"), std::string::npos) << text;
  const std::string empty = problem_with(made("b.glb", "x"));
  EXPECT_EQ(empty.find("$$$"), std::string::npos) << empty;
}

}  // namespace
}  // namespace glark::geometry
