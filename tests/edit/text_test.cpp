// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Operations as lines of text.
#include "tests/edit/samplings.h"

namespace glark::edit {
namespace {

TEST(Lines, GiveTheSameOperation) {
  for (const char* line : {"paint 0.1 -2e-09 3 0.25 255 0 1 0.5", "inflate 1 2 3 4 -0.125", "smooth 1 2 3 4 1",
                           "move 1 2 3 4 5 6 7", "bend 1 2 3 4 5 6 7 8 9 -90", "twist 1 2 3 4 5 6 30",
                           "deform 1 2 3 4 5 6 7 8 9 10 11 0 0 1 45", "symmetric on y -0.5", "symmetric off",
                           "refine 1 2 3 4 500", "project \"a b.png\" 1 2 3 4 5 6 0 1 0 45 1", "undo", "redo"})
    EXPECT_EQ(text_of(parse(line)), line);
  const double third = 1.0 / 3;
  const auto move = std::get<Move>(parse(text_of(Move{{{third, -third, 1e300}, 5e-324}, {0.1, 0.2, 0.3}})));
  EXPECT_EQ(move.ball.centre, (Vector{third, -third, 1e300}));
  EXPECT_EQ(move.ball.radius, 5e-324);
  EXPECT_EQ(move.by, (Vector{0.1, 0.2, 0.3}));
}

TEST(Lines, BlanksAndDefaultsAreFree) {
  EXPECT_EQ(text_of(parse("  paint\t0 0 0  1 1 2 3 \r")), "paint 0 0 0 1 1 2 3 1");
  EXPECT_EQ(text_of(parse("symmetric on x")), "symmetric on x 0");
  EXPECT_EQ(text_of(parse("deform 0 0 0 1 0 0 0 2 1 0 0")), "deform 0 0 0 1 0 0 0 2 1 0 0 0 0 1 0");
}

TEST(Lines, BadOnesAreExplained) {
  const std::pair<const char*, const char*> wrong[] = {
      {"", "there is no operation; write one of paint, inflate"},
      {"pant 0 0 0 1", "\"pant\" is no operation; write one of paint"},
      {"paint 0 0 0 1 1 2", "paint: BLUE is missing; write: paint X Y Z RADIUS RED GREEN BLUE [STRENGTH]"},
      {"paint 0 0 0 1 1 2 256", "BLUE is \"256\", no whole number from 0 to 255"},
      {"paint 0 0 0 1 1 2 3 1.5", "STRENGTH is 1.5; 0 to 1 is possible"},
      {"paint 0 0 0 1 1 2 3 1 9", "\"9\" is one word too many"},
      {"inflate 0 a 0 1 1", "Y is \"a\", no number"},
      {"inflate 0 0 0 0 1", "RADIUS is 0; it must be above 0"},
      {"inflate 0 0 nan 1 1", "Z is \"nan\", no number"},
      {"inflate 0 0 0 inf 1", "RADIUS is \"inf\", no number"},
      {"move 0 0 0 1 1 2", "DZ is missing"},
      {"symmetric", "on or off is missing"},
      {"symmetric on w", "AXIS is \"w\", not x, y or z"},
      {"refine 0 0 0 1 -3", "MOST is \"-3\""},
      {"project \"a 0 0 0", "PICTURE has no quote at its end"},
      {"project a.png 0 0 0 0 0 1 0 1 0 180", "DEGREES is 180; it must be below 180"},
      {"undo 2", "\"2\" is one word too many; write: undo"}};
  for (const auto& [line, message] : wrong) {
    const std::string problem = problem_of([line = line] { parse(line); });
    EXPECT_NE(problem.find(message), std::string::npos) << problem;
  }
}

TEST(Lines, FormsAreThoseOfTheOperations) {
  EXPECT_EQ(forms().size(), std::variant_size_v<Operation>);
  for (const Form& form : forms()) {
    EXPECT_TRUE(std::string_view(form.form).starts_with(form.name));
    EXPECT_EQ(problem_of([&] { parse(form.name); }).find("is no operation"), std::string::npos);
  }
}

}  // namespace
}  // namespace glark::edit
