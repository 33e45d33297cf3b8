// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The check of most draw tests: refinement changes the number of triangles, but not the picture.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/support/picture.h"

namespace glark::core::test {

inline GLuint generated_primitives = 0;  // of the last picture_of()

// The picture of draw() and, in generated_primitives, the triangles it took.
template <typename Draw>
Picture picture_of(Draw&& draw) {
  GLuint query = 0;
  glGenQueries(1, &query);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &generated_primitives);
  glDeleteQueries(1, &query);
  return read_picture();
}

struct SameScene {
  GLuint coarse_triangles = 0;  // 0: depends on the driver
  GLenum refinement = GL_LINEAR_OUTPUTS_ARK;
  GLuint level = 2;
};

// draw() gives the same picture with GL_ARK as without it, with 4^level times as many triangles, twice in a row.
template <typename Draw>
void expect_same_scene(const SameScene& scene, Draw&& draw) {
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw);
  const GLuint coarse = generated_primitives;
  EXPECT_GT(differing_pixels(plain, Picture(plain.size(), 0)), visible_pixels) << "the scene shows nothing";
  refine_uniformly(scene.level, scene.refinement);
  for (int repetition = 0; repetition < 2; ++repetition) {
    const Picture refined = picture_of(draw);
    EXPECT_LE(differing_pixels(plain, refined), tolerated_pixels) << "repetition " << repetition;
    if (scene.coarse_triangles > 0) {
      EXPECT_EQ(generated_primitives, scene.coarse_triangles << (2 * scene.level)) << "repetition " << repetition;
    } else {
      EXPECT_GT(generated_primitives, coarse) << "nothing was refined";
    }
  }
  glDisable(GL_ARK);
  EXPECT_EQ(differing_pixels(plain, picture_of(draw)), 0) << "state was lost";
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace glark::core::test
