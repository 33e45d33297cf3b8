// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/edit.h>
#include <glark/edit.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/c_api/shapes.h"
#include "tests/common/temporary_folder.h"

namespace glark::test {
namespace {

class EditInC : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    const std::vector<float> points = sphere(3000);
    made("scan.raw", {reinterpret_cast<const char*>(points.data()), points.size() * sizeof(float)});
    options_.target = 500;
  }
  std::string file(const char* name) const { return path(name).string(); }

  glark_edit_session_options options_ = glark_edit_default_session_options();
};

TEST_F(EditInC, SessionsAreThoseOfCpp) {
  glark_edit_session* session = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS,
            glark_edit_session_open(file("scan.raw").c_str(), file("c").c_str(), &options_, &session, &error))
      << error.message;
  edit::Session same(path("scan.raw"), path("cpp"), {.target = 500});
  for (const char* line : {"inflate 0 0 1 0.5 0.1", "twist 0 0 -1 0 0 1 30"}) {
    ASSERT_EQ(GLARK_SUCCESS, glark_edit_session_apply(session, line, &error)) << error.message;
    same.apply(edit::parse(line));
  }
  ASSERT_EQ(glark_edit_session_size(session), same.editor().size());
  EXPECT_EQ(glark_edit_session_operations(session), 2U);
  const auto positions = same.editor().positions();
  EXPECT_TRUE(std::equal(positions.begin(), positions.end(), glark_edit_session_positions(session)));
  EXPECT_EQ(glark_edit_session_normals(session).count, positions.size());
  EXPECT_EQ(glark_edit_session_colours(session).count, 0U);  // a .raw file has none
  EXPECT_EQ(GLARK_SUCCESS, glark_edit_session_save(session, file("out.raw").c_str(), nullptr));
  EXPECT_EQ(std::filesystem::file_size(path("out.raw")), std::filesystem::file_size(path("scan.raw")));
  glark_edit_session_free(session);
}

TEST_F(EditInC, MistakesAreExplained) {
  glark_edit_session* session = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_edit_session_open(nullptr, "a", nullptr, &session, &error));
  EXPECT_STREQ(error.message, "glark: the argument scan is NULL; pass its address");
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_edit_session_open(file("none.ply").c_str(), "a", nullptr, &session, &error));
  EXPECT_EQ(session, nullptr);
  ASSERT_EQ(GLARK_SUCCESS,
            glark_edit_session_open(file("scan.raw").c_str(), file("c").c_str(), &options_, &session, &error));
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_edit_session_apply(session, "inflate", &error));
  EXPECT_EQ(error.element, GLARK_EDIT_OPERATION);
  EXPECT_NE(std::strstr(error.message, "write: inflate X Y Z"), nullptr);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_edit_session_apply(nullptr, "undo", &error));
  glark_edit_session_free(session);
  glark_edit_session_free(nullptr);
  EXPECT_EQ(glark_edit_session_size(nullptr), 0U);
}

}  // namespace
}  // namespace glark::test
