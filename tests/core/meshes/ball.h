// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An octahedron with the normals of a ball, drawn from the places where programs keep their vertices.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/support/picture.h"
#include "tests/core/support/programs.h"

namespace glark::core::test {

enum class Source { buffer, client_memory, list, immediate };

inline std::string source_name(const testing::TestParamInfo<Source>& parameter) {
  constexpr std::array names{"buffer", "client_memory", "list", "immediate"};
  return names.at(static_cast<std::size_t>(parameter.param));
}

inline constexpr float ball_radius = 0.75F;
// The octahedron's outline is a square, the ball's a circle. Curved triangles lie between them.
inline constexpr double octahedron_pixels = 2.0 * (ball_radius * picture_size / 2) * (ball_radius * picture_size / 2);
inline constexpr double round_pixels = 1.25 * octahedron_pixels;

// +x, -x, +y, -y, +z, -z.
inline const std::vector<std::array<GLfloat, 3>>& ball_points() {
  constexpr float r = ball_radius;
  static const std::vector<std::array<GLfloat, 3>> points{{r, 0, 0},  {-r, 0, 0}, {0, r, 0},
                                                          {0, -r, 0}, {0, 0, r},  {0, 0, -r}};
  return points;
}

inline std::vector<std::array<GLfloat, 3>> ball_corners() {
  std::vector<std::array<GLfloat, 3>> corners;
  for (const int z : {4, 5}) {
    for (const auto& [x, y] : {std::pair(0, 2), {2, 1}, {1, 3}, {3, 0}}) {
      for (const int point : {z == 4 ? x : y, z == 4 ? y : x, z}) {
        corners.push_back(ball_points().at(static_cast<std::size_t>(point)));
      }
    }
  }
  return corners;
}

class Ball {
 public:
  explicit Ball(Source source) : source_(source), corners_(ball_corners()) {
    if (source == Source::buffer) {
      buffer_ = make_buffer(GL_ARRAY_BUFFER, corners_);
      glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    if (source == Source::list) {
      list_ = glGenLists(1);
      glNewList(list_, GL_COMPILE);
      give_vertices();
      glEndList();
    }
  }

  void draw() const {
    if (source_ == Source::list) {
      glCallList(list_);
    } else if (source_ == Source::immediate) {
      give_vertices();
    } else {
      draw_arrays(true);
    }
  }
  void draw_positions() const { draw_arrays(false); }

 private:
  // The position, divided by the radius, is the normal.
  void give_vertices() const {
    glBegin(GL_TRIANGLES);
    for (const auto& corner : corners_) {
      glNormal3fv(corner.data());
      glVertex3fv(corner.data());
    }
    glEnd();
  }
  void draw_arrays(bool normals) const {
    const void* const data = buffer_ != 0 ? nullptr : corners_.data();
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glVertexPointer(3, GL_FLOAT, 0, data);
    glNormalPointer(GL_FLOAT, 0, data);
    glEnableClientState(GL_VERTEX_ARRAY);
    (normals ? glEnableClientState : glDisableClientState)(GL_NORMAL_ARRAY);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_NORMAL_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

  Source source_;
  std::vector<std::array<GLfloat, 3>> corners_;
  GLuint buffer_ = 0;
  GLuint list_ = 0;
};

// A framebuffer with nothing but depth.
class DepthFramebuffer {
 public:
  DepthFramebuffer() {
    GLuint depth = 0;
    glGenTextures(1, &depth);
    glBindTexture(GL_TEXTURE_2D, depth);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, picture_size, picture_size);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &name_);
    bind();
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    unbind();
  }
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name_); }
  static void unbind() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }

 private:
  GLuint name_ = 0;
};

// Draws that many frames and returns their pictures.
inline std::vector<Picture> draw_frames(int count, const std::function<void()>& draw) {
  std::vector<Picture> frames;
  for (int frame = 0; frame < count; ++frame) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    draw();
    glFinish();
    frames.push_back(read_picture());
  }
  EXPECT_EQ(pending_errors(), "");
  return frames;
}

inline int covered_pixels(const Picture& picture) { return differing_pixels(picture, Picture(picture.size(), 0)); }

inline int red_pixels(const Picture& picture) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < picture.size(); pixel += 4) {
    count += picture[pixel] > 128 && picture[pixel + 1] < 16 ? 1 : 0;
  }
  return count;
}

}  // namespace glark::core::test
