// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The colours that samples of a fine mesh get from pictures.
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace glark::maps::test {
namespace {

// Three pixels in a row: red, green, blue.
constexpr std::array<std::uint8_t, 9> row{255, 0, 0, 0, 255, 0, 0, 0, 255};
constexpr Picture picture{3, 1, row};

// The colours of a triangle's first three samples, which are its corners.
std::vector<double> colours_of(const std::array<float, 6>& texcoords, const std::vector<PictureWrap>& wraps,
                               const std::vector<std::uint8_t>& tints = {}) {
  const std::array<float, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::array<std::uint32_t, 3> triangle{0, 1, 2};
  const std::array<std::uint32_t, 1> pictures{0};
  const stream::Source source = mesh_source({.positions = positions,
                                             .triangles = triangle,
                                             .pictures = {&picture, 1},
                                             .triangle_pictures = pictures,
                                             .texcoords = texcoords,
                                             .picture_wraps = wraps,
                                             .tints = tints},
                                            2);
  const auto reader = source.open({});
  const stream::Points points = reader->read(3);
  return {points.channels.begin(), points.channels.end()};
}

// Centres of pixels: 1/6, 3/6, 5/6.
constexpr float red = 1 / 6.0F, blue = 5 / 6.0F;
constexpr std::array<float, 6> beyond{1 + red, 0.5F, -red, 0.5F, 2 + red, 0.5F};

void expect_colours(const std::vector<double>& colours, const std::vector<double>& wanted) {
  ASSERT_EQ(colours.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(colours[i], wanted[i], 1e-3) << i;
}

TEST(PictureUse, WithoutAWrapPicturesRepeat) {
  expect_colours(colours_of(beyond, {}), {255, 0, 0, 0, 0, 255, 255, 0, 0});
}

TEST(PictureUse, PicturesMirror) {
  expect_colours(colours_of(beyond, {{.s = Wrap::mirror}}), {0, 0, 255, 255, 0, 0, 255, 0, 0});
}

TEST(PictureUse, PicturesClamp) {
  expect_colours(colours_of(beyond, {{.s = Wrap::clamp}}), {0, 0, 255, 255, 0, 0, 0, 0, 255});
}

// At the border, a picture that repeats shows the mean of its first and its last pixel.
TEST(PictureUse, BordersFollowTheWrap) {
  constexpr std::array<float, 6> border{0, 0.5F, 1, 0.5F, 0, 0.5F};
  expect_colours(colours_of(border, {}), {127.5, 0, 127.5, 127.5, 0, 127.5, 127.5, 0, 127.5});
  expect_colours(colours_of(border, {{.s = Wrap::mirror}}), {255, 0, 0, 0, 0, 255, 255, 0, 0});
}

TEST(PictureUse, TheTwoWrapsAreForTheTwoAxes) {
  constexpr std::array<float, 6> across{red, 7, blue, -3.25F, 1 + blue, 0.5F};
  expect_colours(colours_of(across, {{.s = Wrap::mirror, .t = Wrap::clamp}}), {255, 0, 0, 0, 0, 255, 255, 0, 0});
}

// The half of linear light is 188 of 255.
TEST(PictureUse, TintsMultiplyAsLinearColours) {
  constexpr std::array<float, 6> inside{red, 0.5F, blue, 0.5F, red, 0.5F};
  const std::vector<double> colours = colours_of(inside, {}, {188, 0, 0, 255, 255, 255, 0, 255, 255});
  expect_colours({colours[0] / 188, colours[1], colours[2]}, {1, 0, 0});
  expect_colours({colours.begin() + 3, colours.end()}, {0, 0, 255, 0, 0, 0});
}

TEST(PictureUse, NumbersOfWrapsAndTintsAreChecked) {
  constexpr std::array<float, 6> inside{};
  EXPECT_THROW(colours_of(inside, {{}, {}}), Error);
  EXPECT_THROW(colours_of(inside, {}, {1, 2, 3}), Error);
}

}  // namespace
}  // namespace glark::maps::test
