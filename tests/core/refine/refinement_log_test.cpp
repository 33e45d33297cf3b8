// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/refinement_log.h"

#include <gtest/gtest.h>

namespace glark::refine {

TEST(RefinementLog, LinesOfTheRefinementShaderHaveTheirOwnNumbers) {
  EXPECT_EQ(log_for_author("0:1000003(7): error: `h' undeclared", "glark_"),
            "refinement shader:3(7): error: `h' undeclared");
  EXPECT_EQ(log_for_author("ERROR: 7001:1000001: 'h' : undeclared\n", "glark_"),
            "ERROR: refinement shader:1: 'h' : undeclared\n");
  EXPECT_EQ(log_for_author("7001(1000012) : error C1008", "glark_"), "refinement shader:12 : error C1008");
}

TEST(RefinementLog, NamesAreThoseOfTheAuthor) {
  EXPECT_EQ(log_for_author("no function with name 'glark_refine'", "glark_"), "no function with name 'refine'");
  EXPECT_EQ(log_for_author("`glark1_Vertex' and glark1_application_scale", "glark1_"), "`gl_Vertex' and scale");
  EXPECT_EQ(log_for_author("glark_refined my_glark_refine", "glark_"), "glark_refined my_glark_refine");
}

TEST(RefinementLog, WarningsAboutOtherTextAreLeftOut) {
  EXPECT_EQ(
      log_for_author("0:12(3): warning: ours\n0:1000002(1): warning: the author's\n0:2000004(1): error: x\n", "glark_"),
      "refinement shader:2(1): warning: the author's\n0:2000004(1): error: x\n");
}

TEST(RefinementLog, AnyTextIsTaken) {
  EXPECT_EQ(log_for_author("", "glark_"), "");
  EXPECT_EQ(log_for_author("99999999999999999999: 1000001", "glark_"), "99999999999999999999: refinement shader:1");
  EXPECT_EQ(log_for_author("a1000001 \n\n", "glark_"), "a1000001 \n\n");
}

}  // namespace glark::refine
