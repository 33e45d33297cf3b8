// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Whole models: a coarse sphere with the maps of a sphere with bumps.
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/maps/bumpy_errors.h"
#include "tests/maps/bumpy_sphere.h"
#include "tests/maps/seen_model.h"

namespace glark::maps::test {
namespace {

constexpr double spacing = 0.01;

Baked bake_bumps(const BakeOptions& options = {}, unsigned coarse_levels = 2) {
  const Sphere fine = sphere_of(6, true);
  const Sphere coarse = sphere_of(coarse_levels, false);
  return bake(coarse.coarse(), mesh_source(fine.fine(), spacing), options);
}

// The middles of the triangles, where the nearest texel of the map is at most half a texel away.
TEST(Bake, NormalsInObjectSpace) {
  const Baked model = bake_bumps();
  const std::vector<std::uint8_t> map = object_normals(model);
  ASSERT_EQ(map.size(), model.normal_map.size());
  const SeenModel seen_model(model);
  double squared = 0;
  const std::size_t triangles = model.triangles.size() / 3;
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<double, 2> at{};
    for (std::size_t k = 0; k < 6; ++k)
      at.at(k % 2) += static_cast<double>(model.texcoords[2 * std::size_t{model.triangles[3 * t + k / 2]} + k % 2]) / 3;
    const auto x = static_cast<std::size_t>(at[0] * model.width), y = static_cast<std::size_t>(at[1] * model.height);
    const std::uint8_t* const texel = &map[3 * (y * model.width + x)];
    const Precise normal = common::unit(Precise{texel[0] - 127.5, texel[1] - 127.5, texel[2] - 127.5});
    const Precise expected = bumpy_normal(common::unit(seen_model.at(t, {1.0 / 3, 1.0 / 3, 1.0 / 3}).position));
    const double degrees = std::acos(std::clamp(common::dot(normal, expected), -1.0, 1.0)) * 180 / std::numbers::pi;
    EXPECT_LT(degrees, 4) << "triangle " << t;
    squared += degrees * degrees / static_cast<double>(triangles);
  }
  EXPECT_LT(std::sqrt(squared), 1.2);
}

// Only one side of a ball has points: blue ones, and red ones at their edge. The other side is red, too, and has not the
// mean of all colours.
TEST(Bake, ChartsWithoutPointsHaveTheColoursOfTheirNeighbours) {
  const Sphere fine = sphere_of(6, false), coarse = sphere_of(2, false);
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < fine.positions.size(); i += 3) {
    if (fine.positions[i] < 0.75F) continue;
    positions.insert(positions.end(), &fine.positions[i], &fine.positions[i] + 3);
    normals.insert(normals.end(), &fine.normals[i], &fine.normals[i] + 3);
    const bool is_blue = fine.positions[i] > 0.85F;
    colours.insert(colours.end(), {std::uint8_t(is_blue ? 0 : 220), 0, std::uint8_t(is_blue ? 220 : 0)});
  }
  const Baked model =
      bake(coarse.coarse(), mesh_source({.positions = positions, .normals = normals, .colours = colours}, 1));
  ASSERT_GT(model.empty_charts, 0U);
  const SeenModel seen_model(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) {
    const Seen seen = seen_model.at(t, {0.4, 0.3, 0.3});
    if (seen.position.x > -0.3) continue;
    EXPECT_GT(seen.colour[0], 0.7) << "triangle " << t;
    EXPECT_LT(seen.colour[2], 0.15) << "triangle " << t;
  }
}

// Without normals, the fine mesh is smooth where its triangles meet in small angles, and has creases elsewhere.
TEST(Bake, CreasesOfAFineMeshWithoutNormals) {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  const std::vector<std::uint32_t> box = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                          1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  const auto reader = mesh_source({.positions = positions, .triangles = box}, 0.1).open({});
  const stream::Points points = reader->read(100000);
  ASSERT_GT(points.normals.size(), 3000U);
  for (std::size_t i = 0; i < points.normals.size(); i += 3) {
    const auto [least, most] = std::minmax_element(&points.normals[i], &points.normals[i] + 3,
                                                   [](float a, float b) { return std::abs(a) < std::abs(b); });
    EXPECT_NEAR(std::abs(*most), 1, 1e-5F);
    EXPECT_NEAR(*least, 0, 1e-5F);
  }
}

// A picture that repeats ten thousand times on a square does not take a sample for each pixel.
TEST(Bake, PicturesThatRepeatOftenTakeNoMoreSamplesThanSixteenMillion) {
  const std::vector<std::uint8_t> pixels(3 * 64 * 64, 100);
  const Picture picture{64, 64, pixels};
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
  const std::vector<float> texcoords = {0, 0, 1000, 0, 1000, 1000, 0, 1000, 1001, 0, 1001, 1};
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3, 1, 4, 5};
  const std::vector<std::uint32_t> pictures = {0, 0, no_picture};
  FineMesh fine{.positions = positions, .triangles = triangles};
  fine.pictures = {&picture, 1};
  fine.triangle_pictures = pictures;
  fine.texcoords = texcoords;
  const std::uint64_t count = mesh_source(fine, 0.5).open({})->count().value_or(0);
  EXPECT_LT(count, (std::uint64_t{1} << 24) + 20000);
  EXPECT_GT(count, std::uint64_t{1} << 23);
}

// A flat square in any direction has one normal in all texels of its chart, and in its gutter.
TEST(Bake, NormalsInObjectSpaceReachIntoTheGutter) {
  const std::vector<float> positions = {0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1};  // faces +x
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3};
  const FineMesh fine{.positions = positions, .triangles = triangles};
  const Baked model = bake({.positions = positions, .triangles = triangles}, mesh_source(fine, 0.02));
  const std::vector<std::uint8_t> map = object_normals(model);
  std::size_t with_normals = 0;
  for (std::size_t i = 0; i < map.size(); i += 3) {
    if (map[i] == 128 && map[i + 1] == 128 && map[i + 2] == 128) continue;
    ++with_normals;
    EXPECT_GE(map[i], 254);
    EXPECT_NEAR(map[i + 1], 127.5, 1.5);
    EXPECT_NEAR(map[i + 2], 127.5, 1.5);
  }
  EXPECT_GT(with_normals, model.texels / 2);
}

TEST(Bake, DisplacedSurfaceIsTheFineOne) {
  const Baked model = bake_bumps();
  const Errors errors = errors_of(model);
  EXPECT_LT(errors.distance, 0.0015);  // bumps are 0.05 high
  EXPECT_LT(errors.degrees, 4);
  EXPECT_LT(std::sqrt(errors.degrees_squared), 0.6);
  EXPECT_LT(errors.colour, 0.02);
  EXPECT_EQ(model.left_out, 0U);
  EXPECT_EQ(model.empty_charts, 0U);
}

TEST(Bake, CoarseMeshStaysAsItIs) {
  const Sphere coarse = sphere_of(2, false);
  const Baked model = bake_bumps();
  ASSERT_EQ(model.triangles.size(), coarse.triangles.size());
  for (std::size_t i = 0; i < coarse.triangles.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(model.positions[3 * model.triangles[i] + axis], coarse.positions[3 * coarse.triangles[i] + axis]);
      EXPECT_NEAR(model.normals[3 * model.triangles[i] + axis], coarse.normals[3 * coarse.triangles[i] + axis], 1e-6F);
    }
  }
}

TEST(Bake, TangentsAreOrthogonalToNormalsAndFollowTheTexture) {
  const Baked model = bake_bumps();
  const auto vector = [](const std::vector<float>& values, std::size_t width, std::size_t i) {
    return common::Vector3f{values[width * i], values[width * i + 1], values[width * i + 2]};
  };
  for (std::size_t i = 0; i < model.positions.size() / 3; ++i) {
    EXPECT_NEAR(common::dot(vector(model.tangents, 4, i), vector(model.normals, 3, i)), 0, 1e-5F);
    EXPECT_EQ(model.tangents[4 * i + 3], 1);
  }
  for (std::size_t t = 0; t < model.triangles.size(); t += 3) {
    const std::size_t a = model.triangles[t], b = model.triangles[t + 1], c = model.triangles[t + 2];
    const auto edge = vector(model.positions, 3, b) - vector(model.positions, 3, a);
    const auto other = vector(model.positions, 3, c) - vector(model.positions, 3, a);
    const float s1 = model.texcoords[2 * b] - model.texcoords[2 * a],
                s2 = model.texcoords[2 * c] - model.texcoords[2 * a];
    const float t1 = model.texcoords[2 * b + 1] - model.texcoords[2 * a + 1];
    const float t2 = model.texcoords[2 * c + 1] - model.texcoords[2 * a + 1];
    // The first row of a picture is the highest. So t grows downwards, and a triangle from outside is turned.
    EXPECT_LT(s1 * t2 - s2 * t1, 0);
    const auto along_s = common::unit((edge * t2 - other * t1) * (1 / (s1 * t2 - s2 * t1)));
    EXPECT_GT(common::dot(along_s, vector(model.tangents, 4, a)), 0.8F);
  }
}

// Programs such as Blender leave the tangents of a file out and compute them again from the texture coordinates.
TEST(Bake, TangentsAreThoseOfMikkTSpace) {
  const Baked model = bake_bumps();
  const auto vector = [](const std::vector<float>& values, std::size_t width, std::size_t i) {
    return common::Vector3f{values[width * i], values[width * i + 1], values[width * i + 2]};
  };
  const auto within = [](common::Vector3f v, common::Vector3f n) { return common::unit(v - n * common::dot(v, n)); };
  std::vector<common::Vector3f> sums(model.positions.size() / 3);
  for (std::size_t t = 0; t < model.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = model.triangles[t + k], b = model.triangles[t + (k + 1) % 3];
      const std::size_t c = model.triangles[t + (k + 2) % 3];
      const auto edge = vector(model.positions, 3, b) - vector(model.positions, 3, a);
      const auto other = vector(model.positions, 3, c) - vector(model.positions, 3, a);
      const auto along = [&](std::size_t vertex, std::size_t axis) {
        return model.texcoords[2 * vertex + axis] - model.texcoords[2 * a + axis];
      };
      const float area = along(b, 0) * along(c, 1) - along(c, 0) * along(b, 1);
      const auto along_s = (edge * along(c, 1) - other * along(b, 1)) * (1 / area);
      const auto n = vector(model.normals, 3, a);
      const float cosine = common::dot(within(edge, n), within(other, n));
      sums[a] += within(along_s, n) * std::acos(std::clamp(cosine, -1.0F, 1.0F));
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_GT(common::dot(common::unit(sums[i]), vector(model.tangents, 4, i)), 0.9999F) << i;
}

TEST(Bake, ChartsWithoutPointsHaveTheMeanColour) {
  const Sphere fine = sphere_of(5, false), coarse = sphere_of(2, false);
  std::vector<float> positions, normals;
  for (std::size_t i = 0; i < fine.positions.size(); i += 3) {
    if (fine.positions[i] < 0.8F) continue;
    positions.insert(positions.end(), &fine.positions[i], &fine.positions[i] + 3);
    normals.insert(normals.end(), &fine.normals[i], &fine.normals[i] + 3);
  }
  const std::vector<std::uint8_t> colours(positions.size(), 200);
  const Baked model =
      bake(coarse.coarse(), mesh_source({.positions = positions, .normals = normals, .colours = colours}, 1));
  ASSERT_GT(model.empty_charts, 0U);
  const SeenModel seen(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen.at(t, {0.4, 0.3, 0.3}).colour[k], 200 / 255.0, 0.01) << t;
}

TEST(Bake, SeamsAgree) {
  const Baked model = bake_bumps();
  EXPECT_GT(model.seams.edges, 0U);
  EXPECT_LE(model.seams.colour.greatest, 2.0F / 255);
  EXPECT_LE(model.seams.normal.greatest, 1);
  EXPECT_LE(model.seams.displacement.greatest, model.scale / 2000);
  ASSERT_EQ(model.mip_seams.size(), 2U);
  for (const SeamJumps& jumps : model.mip_seams) {
    EXPECT_EQ(jumps.edges, model.seams.edges);
    EXPECT_LE(jumps.colour.root_mean_square, 1.0F / 255);
    EXPECT_LE(jumps.normal.root_mean_square, 1);
  }
}

// The colour of a picture is finer than the triangles: a wave of one hundredth of the sphere's diameter.
TEST(Bake, PicturesOfAMeshGiveItsColours) {
  constexpr unsigned side = 1024;
  std::vector<std::uint8_t> pixels;
  const auto shade = [](double s, double t) {
    return std::array<double, 3>{s, t, 0.5 + 0.5 * std::sin(100 * std::numbers::pi * s)};
  };
  for (unsigned row = 0; row < side; ++row)
    for (unsigned column = 0; column < side; ++column)
      for (const double value : shade((column + 0.5) / side, 1 - (row + 0.5) / side))
        pixels.push_back(static_cast<std::uint8_t>(255 * value + 0.5));
  const Sphere sphere = sphere_of(3, false);
  std::vector<float> texcoords;  // those of the projection along z, in the middle of the picture
  for (std::size_t i = 0; i < sphere.positions.size(); i += 3)
    texcoords.insert(texcoords.end(), {0.5F + 0.4F * sphere.positions[i], 0.5F + 0.4F * sphere.positions[i + 1]});
  const Picture picture{side, side, pixels};
  std::vector<std::uint32_t> pictures(sphere.triangles.size() / 3, 0);
  pictures[0] = no_picture;
  const Baked model = bake(sphere.coarse(), mesh_source({.positions = sphere.positions,
                                                         .normals = sphere.normals,
                                                         .triangles = sphere.triangles,
                                                         .pictures = {&picture, 1},
                                                         .triangle_pictures = pictures,
                                                         .texcoords = texcoords},
                                                        0.1));
  const SeenModel seen_model(model);
  std::array<double, 3> squares{};
  std::size_t places = 0;
  for (std::size_t t = 1; t < model.triangles.size() / 3; ++t) {
    const Seen seen = seen_model.at(t, {1 / 3.0, 1 / 3.0, 1 / 3.0});
    double z = 0, s = 0, v = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = 3 * std::size_t{sphere.triangles[3 * t + k]};
      s += (0.5 + 0.4 * static_cast<double>(sphere.positions[corner])) / 3;
      v += (0.5 + 0.4 * static_cast<double>(sphere.positions[corner + 1])) / 3;
      z += static_cast<double>(sphere.positions[corner + 2]) / 3;
    }
    if (std::abs(z) < 0.3) continue;  // there the picture is seen from the side
    for (std::size_t k = 0; k < 3; ++k) squares.at(k) += std::pow(seen.colour[k] - shade(s, v).at(k), 2);
    ++places;
  }
  ASSERT_GT(places, 500U);
  const auto mean = [&](std::size_t channel) { return std::sqrt(squares.at(channel) / static_cast<double>(places)); };
  EXPECT_LT(mean(0), 0.01);
  EXPECT_LT(mean(1), 0.01);
  EXPECT_LT(mean(2), 0.1);
}

TEST(Bake, ResultDoesNotDependOnThreads) {
  const Baked one = bake_bumps({.threads = 1});
  const Baked two = bake_bumps({.threads = 2});
  EXPECT_EQ(one.normal_map, two.normal_map);
  EXPECT_EQ(one.colour_map, two.colour_map);
  EXPECT_EQ(one.displacement_map, two.displacement_map);
  EXPECT_EQ(one.texcoords, two.texcoords);
}

TEST(Bake, MissingNormalsComeFromTheDisplacedSurface) {
  const Sphere fine = sphere_of(7, true);
  const Sphere coarse = sphere_of(2, false);
  const Baked model = bake(coarse.coarse(), mesh_source({.positions = fine.positions}, 1));
  const Errors errors = errors_of(model);
  EXPECT_LT(errors.distance, 0.002);
  EXPECT_LT(std::sqrt(errors.degrees_squared), 4);
  EXPECT_TRUE(model.colour_map.empty());
}

TEST(Bake, ScanOfOneSideLeavesTheOtherFlat) {
  const Sphere fine = sphere_of(6, true);
  std::vector<float> positions, normals;
  for (std::size_t i = 0; i < fine.positions.size(); i += 3) {
    if (fine.positions[i + 2] < 0.8F) continue;
    positions.insert(positions.end(), {fine.positions[i], fine.positions[i + 1], fine.positions[i + 2]});
    normals.insert(normals.end(), {fine.normals[i], fine.normals[i + 1], fine.normals[i + 2]});
  }
  const Sphere coarse = sphere_of(2, false);
  const Baked model = bake(coarse.coarse(), mesh_source({.positions = positions, .normals = normals}, 1));
  EXPECT_GT(model.empty_charts, 0U);
  EXPECT_LT(model.empty_charts, model.charts);
  const SeenModel seen_model(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) {
    const Seen seen = seen_model.at(t, {0.4, 0.3, 0.3});
    if (seen.position.z > -0.9) continue;
    EXPECT_GT(common::dot(seen.normal, common::unit(seen.position)), 0.99);
    EXPECT_NEAR(common::length(seen.position), 0.98, 0.03);  // between a flat triangle and the sphere
  }
}

TEST(Bake, PointsBeyondTheReachAreLeftOut) {
  Sphere fine = sphere_of(6, true);
  const std::size_t points = fine.positions.size() / 3;
  for (int i = 0; i < 50; ++i) {
    fine.positions.insert(fine.positions.end(), {0, 0, 3});
    fine.normals.insert(fine.normals.end(), {0, 0, 1});
  }
  const Sphere coarse = sphere_of(2, false);
  const Baked model = bake(coarse.coarse(), mesh_source({.positions = fine.positions, .normals = fine.normals}, 1));
  EXPECT_EQ(model.points, points + 50);
  EXPECT_EQ(model.left_out, 50U);
}

// Two sheets whose normals are opposite do not mix, even if they are nearer to each other than to the coarse mesh.
TEST(Bake, PointsOfTheOtherSideOfAThinWallAreLeftOut) {
  const Sphere coarse = sphere_of(2, false);
  Sphere fine = sphere_of(6, true);
  const std::size_t points = fine.positions.size();
  for (std::size_t i = 0; i < points; ++i) {
    fine.positions.push_back(0.99F * fine.positions[i]);
    fine.normals.push_back(-fine.normals[i]);
  }
  const Baked model = bake(coarse.coarse(), mesh_source({.positions = fine.positions, .normals = fine.normals}, 1));
  EXPECT_EQ(model.left_out, points / 3);
  EXPECT_LT(errors_of(model).distance, 0.003);
}

TEST(Bake, SmallTextureMemoryGivesSmallMaps) {
  const Baked large = bake_bumps();
  const Baked small = bake_bumps({.texture_memory = std::size_t{1} << 20});
  EXPECT_LE(std::size_t{small.width} * small.height * 8 * 4 / 3, std::size_t{1} << 20);
  EXPECT_LT(small.width * small.height, large.width * large.height);
  EXPECT_LT(errors_of(small).distance, 0.004);
}

TEST(Bake, TexelsAreWiderThanTheNoise) {
  const Baked exact = bake_bumps();
  const Baked noisy = bake_bumps({.noise = 0.01});
  EXPECT_LT(noisy.texels, exact.texels / 8);
  // The sphere's area is 12.6, a texel's at least the square of 0.035. Places are larger than charts.
  EXPECT_LT(static_cast<double>(noisy.texels), 4 * 12.6 / (0.035 * 0.035));
}

TEST(Bake, SidesArePowersOfTwoWithinTheLimit) {
  const Baked model = bake_bumps({.most_side = 128});
  EXPECT_LE(model.width, 128U);
  EXPECT_LE(model.height, 128U);
  EXPECT_EQ(model.width & (model.width - 1), 0U);
  EXPECT_EQ(model.height & (model.height - 1), 0U);
}

TEST(Bake, ResultDoesNotDependOnTheUnit) {
  const Baked model = bake_bumps();
  for (const int exponent : {-40, 40}) {
    Sphere fine = sphere_of(6, true);
    Sphere coarse = sphere_of(2, false);
    for (Sphere* sphere : {&fine, &coarse})
      for (float& x : sphere->positions) x = std::ldexp(x, exponent);
    const Baked other = bake(coarse.coarse(), mesh_source(fine.fine(), std::ldexp(spacing, exponent)));
    EXPECT_EQ(other.normal_map, model.normal_map);
    EXPECT_EQ(other.displacement_map, model.displacement_map);
    EXPECT_EQ(other.scale, std::ldexp(model.scale, exponent));
    EXPECT_EQ(other.positions[0], std::ldexp(model.positions[0], exponent));
  }
}

TEST(Bake, FlatModelsHaveNoDisplacement) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
  const Baked model = bake({.positions = positions, .triangles = triangles},
                           mesh_source({.positions = positions, .triangles = triangles}, 0.05));
  EXPECT_EQ(model.scale, 0);
  EXPECT_EQ(model.bias, 0);
}

TEST(Bake, OriginIsKeptInDoublePrecision) {
  const Sphere fine = sphere_of(5, true);
  const Sphere coarse = sphere_of(2, false);
  const std::array<double, 3> far{5e6, -3e6, 1e5};
  CoarseMesh mesh = coarse.coarse();
  mesh.origin = far;
  FineMesh shifted = fine.fine();
  shifted.origin = far;
  const Baked model = bake(mesh, mesh_source(shifted, spacing));
  EXPECT_EQ(model.origin, far);
  EXPECT_LT(errors_of(model).distance, 0.003);
}

TEST(Bake, ReportsProgressInOrder) {
  std::vector<double> fractions;
  bake_bumps({.progress = [&](double fraction) { fractions.push_back(fraction); }});
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_THROW(bake_bumps({.progress = [](double) { throw std::runtime_error("stop"); }}), std::runtime_error);
}

}  // namespace
}  // namespace glark::maps::test
