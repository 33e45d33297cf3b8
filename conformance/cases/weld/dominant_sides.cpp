// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement along seams with WELD_ARK (11.R.15): which side of an edge is dominant, and which coordinate a place has,
// if the values of both sides differ in one component only.
#include <fmt/core.h>

#include <cmath>
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr int seam_texels = 8;
constexpr GLint seam_unit = 2;
constexpr std::size_t seam_steps = 8;

// Values of one side at the lesser of both places, and at the other one.
struct SeamSide {
  Vec3 normal[2] = {{0.2F, 0.3F, 0.7F}, {0.2F, 0.3F, 0.7F}};
  Vec2 texture[2] = {{0.31F, 0.44F}, {0.56F, 0.69F}};
};

struct SeamOrder {
  const char* leaf;
  void (*set)(SeamSide& lesser, SeamSide& greater);  // the lesser side is dominant
};

// Where normals decide, the coordinates are in the opposite order.
void oppose_coordinates(SeamSide& lesser, SeamSide& greater) {
  lesser.texture[0] = {0.81F, 0.94F};
  lesser.texture[1] = {0.93F, 0.81F};
  greater.texture[0] = {0.19F, 0.06F};
  greater.texture[1] = {0.06F, 0.31F};
}

template <std::size_t end, std::size_t component>
void order_by_normal(SeamSide& lesser, SeamSide& greater) {
  oppose_coordinates(lesser, greater);
  greater.normal[end][component] += 0.25F;
  if (end == 0) lesser.normal[1][2] += 0.5F;
  for (std::size_t later = component + 1; later < 3; ++later) lesser.normal[end][later] += 0.125F;
}

template <std::size_t end, std::size_t component>
void order_by_coordinate(SeamSide& lesser, SeamSide& greater) {
  greater.texture[end][component] += 0.25F;
  if (end == 0) lesser.texture[1][0] += 0.25F;
  if (component == 0) lesser.texture[end][1] += 0.25F;
}

constexpr SeamOrder seam_orders[] = {
    {"normal.x", order_by_normal<0, 0>},
    {"normal.y", order_by_normal<0, 1>},
    {"normal.z", order_by_normal<0, 2>},
    {"other_normal.x", order_by_normal<1, 0>},
    {"other_normal.y", order_by_normal<1, 1>},
    {"other_normal.z", order_by_normal<1, 2>},
    {"coordinate.s", order_by_coordinate<0, 0>},
    {"coordinate.t", order_by_coordinate<0, 1>},
    {"other_coordinate.s", order_by_coordinate<1, 0>},
    {"other_coordinate.t", order_by_coordinate<1, 1>},
    // As bits, negative numbers are greater.
    {"coordinate.negative_s",
     [](SeamSide&, SeamSide& greater) {
       greater.texture[0] = {-0.81F, 0.06F};
     }},
    {"coordinate.negative_t", [](SeamSide&, SeamSide& greater) { greater.texture[0][1] = -0.81F; }},
    {"coordinate.zero_s",
     [](SeamSide& lesser, SeamSide& greater) {
       lesser.texture[0][0] = -0.0F;
       greater.texture[0] = {0, 0.81F};
     }},
};

std::uint32_t bits_without_sign_of_zero(float value) {
  value += 0.0F;  // -0 becomes 0
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

template <std::size_t n>
bool is_less(const std::array<float, n>& a, const std::array<float, n>& b) {
  for (std::size_t i = 0; i < n; ++i)
    if (bits_without_sign_of_zero(a[i]) != bits_without_sign_of_zero(b[i]))
      return bits_without_sign_of_zero(a[i]) < bits_without_sign_of_zero(b[i]);
  return false;
}

// In bent_mesh, the edge of vertices 0 and 2 is the edge of vertices 5 and 3.
Mesh mesh_of_seam(const SeamSide& first, const SeamSide& second) {
  Mesh mesh = bent_mesh();
  const std::size_t lesser = is_less(mesh[0].position, mesh[2].position) ? 0 : 1;
  constexpr std::size_t corners[2][2] = {{0, 2}, {5, 3}};
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t place = 0; place < 2; ++place) {
      const SeamSide& from = side == 0 ? first : second;
      const std::size_t end = place == lesser ? 0 : 1;
      mesh[corners[side][place]].normal = from.normal[end];
      mesh[corners[side][place]].texture = from.texture[end];
    }
  return mesh;
}

// The positions along the seam, the same on both sides.
std::vector<Vec4> drawn_seam(Test& t, const Mesh& mesh) {
  upload(mesh);
  std::vector<Vec4> seam(seam_steps + 1);
  std::vector<Vec4> other(seam_steps + 1);
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    if (vertex.weights[1] != 0) continue;
    const bool is_second = vertex.triangle >= 1;
    const float along = vertex.weights[is_second ? 0 : 2];
    (is_second ? other : seam)[static_cast<std::size_t>(std::lround(seam_steps * along))] = vertex.position;
  }
  for (std::size_t i = 0; i <= seam_steps; ++i)
    t.expect(same_position(seam[i], other[i]), fmt::format("step {} has the same position on both sides", i));
  return seam;
}

void displace_seam(Test& t) {
  gl.UseProgram(surface_program(t));
  std::vector<GLubyte> texels;
  for (int i = 0; i < seam_texels * seam_texels; ++i)
    texels.insert(texels.end(), 4, static_cast<GLubyte>(i * 67 % 251));
  bind_nearest_texture(seam_unit, seam_texels, texels);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, seam_unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  refine_uniformly(3);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
}

// The seam is as if both sides had the coordinates of the dominant one; its ends are as if all had those of the place.
void check_order(Test& t, const SeamOrder& order, bool is_second) {
  displace_seam(t);
  SeamSide lesser;
  SeamSide greater;
  order.set(lesser, greater);
  const auto seam_of = [&](const SeamSide& least, const SeamSide& greatest) {
    return drawn_seam(t, is_second ? mesh_of_seam(greatest, least) : mesh_of_seam(least, greatest));
  };
  const auto with_textures_of = [](SeamSide side, const SeamSide& other) {
    for (std::size_t end = 0; end < 2; ++end) side.texture[end] = other.texture[end];
    return side;
  };
  const std::vector<Vec4> actual = seam_of(lesser, greater);
  const std::vector<Vec4> expected = seam_of(lesser, with_textures_of(greater, lesser));
  const std::vector<Vec4> wrong = seam_of(with_textures_of(lesser, greater), greater);
  int differ = 0;
  for (std::size_t i = 1; i < seam_steps; ++i) {
    t.expect(same_position(actual[i], expected[i]), fmt::format("step {} has the height of the dominant side", i));
    differ += same_position(expected[i], wrong[i]) ? 0 : 1;
  }
  t.expect(differ > 0, "the sides have different heights");
  SeamSide of_places = lesser;
  for (std::size_t end = 0; end < 2; ++end)
    if (is_less(greater.texture[end], lesser.texture[end])) of_places.texture[end] = greater.texture[end];
  const std::vector<Vec4> ends = seam_of(with_textures_of(lesser, of_places), with_textures_of(greater, of_places));
  for (const std::size_t i : {std::size_t{0}, seam_steps})
    t.expect(same_position(actual[i], ends[i]), fmt::format("the end {} has the height of its place", i));
}

}  // namespace

Cases dominant_sides_cases() {
  Cases cases;
  for (const SeamOrder& order : seam_orders)
    for (const bool is_second : {false, true})
      cases.push_back(
          {.name = std::string("ark.weld.displacement.order.") + order.leaf + (is_second ? ".second" : ".first"),
           .clauses = {"11.R.15-26", "11.R.15-27", "11.R.15-34"},
           .plan = "The two sides of a seam differ in this component: compare with a draw in which both "
                   "have the coordinates of the dominant side, and with one that has those of the places.",
           .wrong = "Only the first component, or only one end, is compared.",
           .check = [&order, is_second](Test& t) { check_order(t, order, is_second); }});
  return cases;
}

}  // namespace glark::conformance
