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

TEST(BadInput, EmptyClouds) {
  const Strips strips({});
  EXPECT_EQ(strips.indices().size(), 0U);
  ASSERT_EQ(strips.nodes().size(), 1U);
  Frame frame;
  strips.select({.clip_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, .width = 8, .height = 8}, frame);
  EXPECT_EQ(frame.draws(), 0);
}

TEST(BadInput, OnePointAndTwo) {
  Points points;
  points.add({1, 2, 3}, {0, 0, 1});
  EXPECT_EQ(Strips(points.cloud(), {.levels = 4}).indices().size(), 0U);
  points.add({1, 2, 4}, {0, 0, 1});
  EXPECT_EQ(Strips(points.cloud()).indices().size(), 0U);
}

TEST(BadInput, AMillionDuplicates) {
  Points points;
  for (int i = 0; i < 1000000; ++i) points.add({0.1F, 0.2F, 0.3F}, {0, 1, 0});
  const Strips strips(points.cloud(), {.levels = 3});
  EXPECT_EQ(strips.indices().size(), 0U);
  EXPECT_EQ(strips.nodes().front().representative, 0U);
}

TEST(BadInput, DuplicatesAmongOthersAreDrawnByTheFirst) {
  const Points once = sphere(2000);
  Points twice = once;
  for (std::size_t i = 0; i < once.positions.size(); ++i) {
    twice.positions.push_back(once.positions[i]);
    twice.normals.push_back(once.normals[i]);
  }
  const Strips strips(twice.cloud(), {.leaf_points = 80});
  for (const std::uint32_t point : strips.indices()) ASSERT_LT(point, 2000U);
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 2.0 * 2000 - 4, 10);
}

TEST(BadInput, PointsOnALine) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.add({0.37F * static_cast<float>(i), 0, 0}, {0, 0, 1});
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 0U);
  for (std::size_t i = 0; i < points.size(); ++i) {  // and one that rounding bends
    points.positions[3 * i + 1] = points.positions[3 * i] * 0.1234567F;
    points.positions[3 * i + 2] = points.positions[3 * i] * 0.7654321F;
  }
  for (const std::uint32_t point : Strips(points.cloud()).indices()) ASSERT_LT(point, 1000U);
}

TEST(BadInput, ZeroNormalsSayNothing) {
  Points points = plane(40, 0);
  for (std::size_t i = 0; i < points.normals.size(); i += 7) points.normals[i / 3 * 3 + 2] = 0;
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
  std::fill(points.normals.begin(), points.normals.end(), 0.0F);
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
}

TEST(BadInput, NormalsOfAnyLengthAndOpposed) {
  Points points = plane(40, 0);
  for (float& x : points.normals) x *= 1e-30F;
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
  for (std::size_t i = 0; i < points.size(); i += 2) points.normals[3 * i + 2] = -1;
  const Strips strips(points.cloud());  // two layers at one place
  EXPECT_GT(triangles(strips).size(), 0U);
}

TEST(BadInput, GreatAndSmallCoordinates) {
  for (const float scale : {1e18F, 1e-37F}) {
    Points points = sphere(500);
    for (float& x : points.positions) x *= 0.99F * scale;
    EXPECT_GT(triangles(Strips(points.cloud())).size(), 900U) << scale;
  }
}

TEST(BadInput, CoordinatesThatAreNoNumbers) {
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

TEST(BadInput, ArraysOfTheWrongSize) {
  const std::vector<float> seven(7), six(6);
  expect_error(Element::cloud, 0, "7 coordinates", [&] { Strips{Cloud{seven, {}}}; });
  expect_error(Element::cloud, 0, "of normals", [&] { Strips{Cloud{six, std::span(six).first(3)}}; });
}

TEST(BadInput, OptionsOutOfRange) {
  const auto with = [](const Options& options) { return [options] { Strips({}, options); }; };
  expect_error(Element::option, 0, "leaf_points", with({.leaf_points = 7}));
  expect_error(Element::option, 0, "delta_a", with({.delta_a = -0.1F}));
  expect_error(Element::option, 0, "delta_d", with({.delta_d = std::nanf("")}));
  expect_error(Element::option, 0, "inflation", with({.inflation = 9}));
  expect_error(Element::option, 0, "reach", with({.reach = 0}));
  expect_error(Element::option, 0, "levels", with({.levels = 0}));
}

TEST(BadInput, Views) {
  const Strips strips(sphere(100).cloud());
  Frame frame;
  expect_error(Element::view, 0, "width", [&] { strips.select({}, frame); });
  View view{.width = 1, .height = 1};
  view.clip_from_object[5] = std::nanf("");
  expect_error(Element::view, 0, "element 5", [&] { strips.select(view, frame); });
  expect_error(Element::option, 1, "levels", [&] { static_cast<void>(strips.nodes(1)); });
}

}  // namespace
}  // namespace glark::surfel::test
