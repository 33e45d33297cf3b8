// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/facet_normals.h"

#include <gtest/gtest.h>

namespace glark::refine {

TEST(FacetNormals, AreCrossProductsOfTwoDerivatives) {
  EXPECT_TRUE(computes_facet_normals({"void main() { n = normalize(cross(dFdx(at), dFdy(at))); }"}));
  EXPECT_TRUE(computes_facet_normals({"", "vec3 x = dFdx(at); vec3 y = dFdy(at); vec3 n = normalize(cross(x, y));"}));
  EXPECT_TRUE(computes_facet_normals({"vec3 x = normalize((dFdxFine(at.xyz))); n = cross(x, normalize(dFdy(at)));"}));
}

TEST(FacetNormals, BumpMapsComputeOthers) {
  EXPECT_FALSE(computes_facet_normals({"vec3 x = dFdx(at); vec3 y = dFdy(at); r = cross(y, n); s = cross(n, x);"}));
  EXPECT_FALSE(computes_facet_normals({"float w = fwidth(u); n = cross(a, b);"}));
  EXPECT_FALSE(computes_facet_normals({"vec3 x = dFdx(at); n = cross(x"}));
  EXPECT_FALSE(computes_facet_normals({}));
}

}  // namespace glark::refine
