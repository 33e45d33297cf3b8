// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks which role each vertex attribute gets.
#include <gtest/gtest.h>

#include "glark/core/capture/layout.h"

namespace glark::capture {
namespace {

// Takes names; the location of each is its index. All are vec3, except names that end in 2 or 4.
std::string roles(const std::vector<std::string>& names, const core::AttributeRoles& told = {}) {
  std::vector<Field> fields;
  for (const std::string& name : names) {
    const GLenum type = name.ends_with('2') ? GL_FLOAT_VEC2 : name.ends_with('4') ? GL_FLOAT_VEC4 : GL_FLOAT_VEC3;
    fields.push_back({.name = name, .type = type, .location = static_cast<int>(fields.size())});
  }
  assign_roles(fields, told);
  std::string text;
  for (const Role role : {Role::position, Role::normal, Role::texture_coordinate}) {
    std::string found = "-";
    for (const Field& field : fields) {
      if (field.role == role) found = field.name;
    }
    text += (text.empty() ? "" : " ") + found;
  }
  return text;
}

}  // namespace

TEST(Roles, AreFoundByName) {
  EXPECT_EQ(roles({"gl_Vertex", "gl_Normal", "gl_MultiTexCoord0"}), "gl_Vertex gl_Normal gl_MultiTexCoord0");
  EXPECT_EQ(roles({"aNormal", "aPos", "aTex2"}), "aPos aNormal aTex2");
  EXPECT_EQ(roles({"vertex", "color", "uv2"}), "vertex - uv2");
  EXPECT_EQ(roles({"vert", "Pos"}), "Pos - -");
  EXPECT_EQ(roles({"pos", "vertex"}), "vertex - -");
  EXPECT_EQ(roles({"vertexColor", "vertexNormal", "vertexPosition"}), "vertexPosition vertexNormal -");
}

TEST(Roles, APartOfALongerWordIsNoName) {
  EXPECT_EQ(roles({"position", "color", "normalization"}), "position - -");
  EXPECT_EQ(roles({"position", "isNormalised", "d2"}), "position - -");
  EXPECT_EQ(roles({"position", "normalizedNormal"}), "position normalizedNormal -");
  EXPECT_EQ(roles({"vertex_pos", "vertex2"}), "vertex_pos - -");
}

TEST(Roles, WhatAngleAddsToNamesIsNoWord) {
  EXPECT_EQ(roles({"_uvertex_position", "_uvertex_normal", "_uvertex_texCoord0_2"}),
            "_uvertex_position _uvertex_normal _uvertex_texCoord0_2");
  EXPECT_EQ(roles({"_uvPosition", "_uvNormal", "_uuv2"}), "_uvPosition _uvNormal _uuv2");
  EXPECT_EQ(roles({"position", "_uv2"}), "position - _uv2") << "not all names have it";
}

TEST(Roles, AreGuessedByLocation) {
  EXPECT_EQ(roles({"a", "b", "c2"}), "a b -");
  EXPECT_EQ(roles({"a", "b2", "c"}), "a c -");
}

TEST(Roles, ANormalIsNotGuessedFromTwoOrFromWhatIsNamedOtherwise) {
  EXPECT_EQ(roles({"a", "b", "c"}), "a - -");
  EXPECT_EQ(roles({"a", "color", "tangent"}), "a - -");
  EXPECT_EQ(roles({"a", "b4"}), "a - -");
}

TEST(Roles, WhatIsToldWins) {
  EXPECT_EQ(roles({"normal", "position", "c", "d2"}, {"c", "1", "d2"}), "c position d2");
  EXPECT_EQ(roles({"a", "b", "c"}, {"", "c", ""}), "a c -");
}

TEST(Roles, WhatIsToldAndNotThereIsGuessed) { EXPECT_EQ(roles({"pos", "nrm"}, {"elsewhere", "7", "x"}), "pos nrm -"); }

}  // namespace glark::capture
