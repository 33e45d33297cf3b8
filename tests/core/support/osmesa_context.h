// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A separate GL context for every test, and the picture that it draws into.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/support/gl.h"

namespace glark::core::test {

enum class Profile { compatibility, core };

inline constexpr int picture_size = 128;

class OsmesaContext {
 public:
  // The context is current from the beginning.
  explicit OsmesaContext(Profile profile, const OsmesaContext* share = nullptr);
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current();
  bool valid() const { return context_ != nullptr; }

 private:
  OSMesaContext context_ = nullptr;
  std::vector<GLubyte> image_;
};

inline std::string profile_name(const testing::TestParamInfo<Profile>& parameter) {
  return parameter.param == Profile::core ? "core" : "compatibility";
}

// All pending errors, "" if there is none.
std::string pending_errors();

// glARKinit, uniform depth, GL_ARK enabled.
void refine_uniformly(GLuint level, GLenum refinement = GL_LINEAR_INPUTS_ARK);

}  // namespace glark::core::test
