// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pictures of materials.
#include <string>

#include "tests/geometry/material_files.h"
#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using MaterialPictures = TemporaryFolder;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST_F(MaterialPictures, TrianglesOfObjHaveThoseOfTheirMaterials) {
  made("picture.png", {png, sizeof(png) - 1});
  made("a.mtl", "newmtl shown\nKd 1 1 1\nmap_Kd picture.png\nnewmtl plain\nKd 1 0 0.2\n");
  const std::filesystem::path file =
      made("a.obj", "mtllib a.mtl\n" + square +
                        "v nan 0 0\nusemtl shown\nf 1/1 2/2 3/3\nf 5/1 2/2 3/3\nusemtl plain\nf 1/1 3/3 4/4\n");
  const Reading reading = read_file(file, {.skip_invalid = true, .images = true});
  const Geometry& geometry = reading.geometry;
  ASSERT_EQ(geometry.triangle_images.size(), 2U);
  std::vector<std::vector<std::uint8_t>> seen;
  for (const std::uint32_t image : geometry.triangle_images) seen.push_back(geometry.images.at(image).pixels);
  EXPECT_EQ(seen[0], png_pixels);
  EXPECT_EQ(seen[1], (std::vector<std::uint8_t>{255, 0, 51}));
  EXPECT_TRUE(read_file(file, {.skip_invalid = true}).geometry.images.empty());
}

TEST_F(MaterialPictures, VerticesWithoutAColourAreSaid) {
  const Reading reading =
      read_file(made("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 \nv\t0 1 0 0 0 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"), {});
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_NE(reading.warnings[0].find("2 of 4 vertices have no colour"), std::string::npos) << reading.warnings[0];
}

TEST_F(MaterialPictures, GreyMaterialsWithoutPictureAreNone) {
  made("a.mtl", "newmtl grey\nKd 0.8 0.8 0.8\n");
  const auto file = made("a.obj", "mtllib a.mtl\n" + square + "usemtl grey\nf 1/1 2/2 3/3\n");
  EXPECT_TRUE(read_file(file, {.images = true}).geometry.images.empty());
}

TEST_F(MaterialPictures, OnesThatCannotBeReadAreSaid) {
  made("text.png", "no picture");
  made("a.mtl", "newmtl a\nKd 0 1 0\nmap_Kd missing.png\nnewmtl b\nKd 0 0 1\nmap_Kd text.png\n");
  const auto file = made("a.obj", "mtllib a.mtl\n" + square + "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n");
  const Reading reading = read_file(file, {.images = true});
  ASSERT_EQ(reading.warnings.size(), 2U);
  EXPECT_NE(reading.warnings[0].find("missing.png"), std::string::npos);
  EXPECT_NE(reading.warnings[1].find("is no picture"), std::string::npos);
  EXPECT_EQ(reading.geometry.images.at(reading.geometry.triangle_images.at(1)).pixels,
            (std::vector<std::uint8_t>{0, 0, 255}));
}

TEST_F(MaterialPictures, ThatOfGltfIsTinted) {
  made("picture.png", {png, sizeof(png) - 1});
  // Three positions, and three texture coordinates.
  const std::array<float, 15> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
  made("a.bin", {reinterpret_cast<const char*>(numbers.data()), sizeof(numbers)});
  const auto file = made("a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 0, 1, 1]}}],
    "textures": [{"source": 0}], "images": [{"uri": "picture.png"}], "buffers": [{"uri": "a.bin", "byteLength": 60}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]})");
  const Geometry geometry = read_file(file, {.images = true}).geometry;
  ASSERT_EQ(geometry.triangle_images.size(), 1U);
  EXPECT_EQ(geometry.images.at(geometry.triangle_images[0]).pixels,
            (std::vector<std::uint8_t>{255, 0, 0, 0, 0, 0, 0, 0, 255, 255, 0, 255}));
  EXPECT_EQ(geometry.texture_coordinates, (std::vector<float>{0, 1, 1, 1, 0, 0}));  // the lower left pixel is at 0 0
}

// Reads the square with a material whose text is given, and one triangle without it.
class MtlPictures : public TemporaryFolder {
 protected:
  Geometry read(const std::string& material, const std::string& vertices = square) {
    return reading(material, vertices).geometry;
  }
  Reading reading(const std::string& material, const std::string& vertices = square) {
    made("picture.png", {png, sizeof(png) - 1});
    made("alpha.png", {png_with_alpha, sizeof(png_with_alpha) - 1});
    made("a.mtl", "newmtl a b\n" + material + "\nnewmtl plain\nKd 1 1 1\n");
    return read_file(
        made("a.obj", "mtllib a.mtl\n" + vertices + "usemtl a b\nf 1/1 2/2 3/3\nusemtl plain\nf 1/1 3/3 4/4\n"),
        {.images = true});
  }
  static const Image& image_of(const Geometry& geometry) { return geometry.images.at(geometry.triangle_images.at(0)); }
};

TEST_F(MtlPictures, OptionsMoveTheCoordinates) {
  for (const char* options :
       {"-s 2 3 1 -o 0.25 0.5 0", "-o 0.25 0.5 -mm 0 1 -s 2 3", "-clamp off -s 2 3 -o 0.25 0.5"}) {
    const Geometry geometry = read(std::string("map_Kd ") + options + " picture.png");
    EXPECT_EQ(image_of(geometry).pixels, png_pixels) << options;
    EXPECT_EQ((std::vector<float>(geometry.texture_coordinates.begin(), geometry.texture_coordinates.begin() + 6)),
              (std::vector<float>{0.25, 0.5, 2.25, 0.5, 2.25, 3.5}))
        << options;
    EXPECT_EQ(image_of(geometry).wrap_s, Wrap::repeat) << options;
  }
}

TEST_F(MtlPictures, OptionsMayClamp) {
  const Geometry geometry = read("map_Kd -clamp on \"picture.png\"");
  EXPECT_EQ(image_of(geometry).wrap_s, Wrap::clamp);
  EXPECT_EQ(image_of(geometry).wrap_t, Wrap::clamp);
}

TEST_F(MtlPictures, TheColourMultipliesThePicture) {
  EXPECT_EQ(image_of(read("Kd 1 0.5 0\nmap_Kd picture.png")).pixels,
            (std::vector<std::uint8_t>{255, 0, 0, 0, 128, 0, 0, 0, 0, 255, 128, 0}));
  EXPECT_EQ(image_of(read("Kd 0 0 0\nmap_Kd picture.png")).pixels, png_pixels);  // many programs write black
}

TEST_F(MtlPictures, ColoursOfVerticesAreForTrianglesWithoutPictures) {
  const std::string coloured =
      "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  const Geometry geometry = read("map_Kd picture.png", coloured);
  EXPECT_FALSE(geometry.colours_tint_images);
  EXPECT_EQ(image_of(geometry).pixels, png_pixels);
  EXPECT_EQ(geometry.triangle_images.at(1), no_image);
  EXPECT_EQ(geometry.colours.size(), 4 * geometry.point_count());
}

TEST_F(MtlPictures, AlphaThatIsLostIsSaidOnce) {
  for (const char* material : {"map_Kd alpha.png", "d 0.5", "map_Kd picture.png\nmap_d alpha.png"}) {
    const Reading result = reading(material);
    ASSERT_EQ(result.warnings.size(), 1U) << material;
    EXPECT_NE(result.warnings[0].find("no alpha"), std::string::npos);
  }
  EXPECT_TRUE(reading("map_Kd picture.png\nd 1").warnings.empty());
}

}  // namespace
}  // namespace glark::geometry
