// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

void expect_error(Element element, std::size_t index, const std::string& part, const std::function<void()>& body) {
  try {
    body();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.element(), element);
    EXPECT_EQ(error.index(), index);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(SurfelInputValidation, RejectsCoordinatesThatAreNotFinite) {
  Points points = sphere(100);
  points.positions[3 * 17 + 1] = std::nanf("");
  expect_error(Element::point, 17, "y coordinate", [&] { Strips{points.cloud()}; });
  points.positions[3 * 17 + 1] = std::numeric_limits<float>::infinity();
  expect_error(Element::point, 17, "leave the point out", [&] { Strips{points.cloud()}; });
  points.positions[3 * 17 + 1] = 1e30F;
  expect_error(Element::point, 17, "1e18", [&] { Strips{points.cloud()}; });
  points.positions[3 * 17 + 1] = 0;
  points.normals[3 * 99 + 2] = std::nanf("");
  expect_error(Element::normal, 99, "z coordinate", [&] { Strips{points.cloud()}; });
}

TEST(SurfelInputValidation, RejectsArraysOfWrongSize) {
  const std::vector<float> seven(7), six(6);
  expect_error(Element::cloud, 0, "7 coordinates", [&] { Strips{Cloud{seven, {}}}; });
  expect_error(Element::cloud, 0, "of normals", [&] { Strips{Cloud{six, std::span(six).first(3)}}; });
}

TEST(SurfelInputValidation, RejectsOptionsOutOfRange) {
  const auto with = [](const Options& options) { return [options] { Strips({}, options); }; };
  expect_error(Element::option, 0, "leaf_points", with({.leaf_points = 7}));
  expect_error(Element::option, 0, "delta_a", with({.delta_a = -0.1F}));
  expect_error(Element::option, 0, "delta_d", with({.delta_d = std::nanf("")}));
  expect_error(Element::option, 0, "inflation", with({.inflation = 9}));
  expect_error(Element::option, 0, "reach", with({.reach = 0}));
  expect_error(Element::option, 0, "levels", with({.levels = 0}));
}

TEST(SurfelInputValidation, RejectsViewsWithoutSizeAndMissingLevels) {
  const Strips strips(sphere(100).cloud());
  Frame frame;
  expect_error(Element::view, 0, "width", [&] { strips.select({}, frame); });
  View view{.width = 1, .height = 1};
  view.clip_from_object[5] = std::nanf("");
  expect_error(Element::view, 0, "element 5", [&] { strips.select(view, frame); });
  for (const float bad : {-1.0F, std::nanf("")}) {
    const View sound{.width = 8, .height = 8};
    View pixels = sound;
    pixels.point_pixels = bad;
    expect_error(Element::view, 0, "point_pixels", [&] { strips.select(pixels, frame); });
    pixels = sound;
    pixels.level_pixels = bad;
    expect_error(Element::view, 0, "level_pixels", [&] { strips.select(pixels, frame); });
  }
  expect_error(Element::option, 1, "levels", [&] { static_cast<void>(strips.nodes(1)); });
}

}  // namespace
}  // namespace glark::surfel::test
