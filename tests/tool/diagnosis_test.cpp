// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/doctor/diagnosis.h"

#include <gtest/gtest.h>

#include <csignal>

#include "glark/tool/doctor/read_reports.h"

namespace glark::tool {
namespace {

std::string text_of(const Observation& observation) {
  std::string text;
  for (const std::string& line : diagnosis(observation)) text += line + "\n";
  return text;
}

bool says(const Observation& observation, const std::string& part) {
  return text_of(observation).find(part) != std::string::npos;
}

Observation game() {
  Observation o{.program = "game", .ending = {Ending::How::stopped, 0, 10}};
  o.reports = {{.name = "game", .number = 7, .contexts = {{"4.5", true}}, .frames = 100, .seen = 1000, .refined = 900}};
  o.reports[0].refinements = {{"pn", 900}};
  o.reports[0].left = {{"overlay", 99}, {"not_triangles", 1}};
  return o;
}

}  // namespace

TEST(Diagnosis, SaysWhatWasRefinedAndWhatWasNot) {
  const Observation o = game();
  EXPECT_TRUE(is_refined(o));
  EXPECT_TRUE(says(o, "game ran for 10.0 s and was stopped.\n")) << text_of(o);
  EXPECT_TRUE(says(o, "game (process 7): 100 frames, 1000 draws.\n")) << text_of(o);
  EXPECT_TRUE(says(o, "  Refined: 900 draws (90 %): 900 by pn.")) << text_of(o);
  EXPECT_TRUE(says(o, "  Left alone: 99 draws (10 %; overlay): ")) << text_of(o);
  EXPECT_TRUE(says(o, "  Left alone: 1 draw (less than 1 %; not_triangles): ")) << text_of(o);
  EXPECT_TRUE(says(o, "Try (overlay): --everything")) << text_of(o);
  EXPECT_FALSE(says(o, "nothing to do")) << text_of(o);
}

TEST(Diagnosis, AFallbackIsExplained) {
  Observation o = game();
  o.reports[0].fallbacks = {{"no_normal", 20}};
  EXPECT_TRUE(says(o, "  Not as wanted: 20 draws (no_normal): ")) << text_of(o);
  EXPECT_TRUE(says(o, "Try (no_normal): ")) << text_of(o);
}

TEST(Diagnosis, FlatRefinementIsInvisibleOnPurpose) {
  Observation o = game();
  EXPECT_FALSE(says(o, "--refine pn"));
  o.reports[0].refinements = {{"linear", 900}};
  EXPECT_TRUE(says(o, "--refine pn curves what has normals")) << text_of(o);
}

TEST(Diagnosis, ACrashIsNamed) {
  Observation o = game();
  o.ending = {Ending::How::crashed, SIGSEGV, 0.5};
  EXPECT_TRUE(says(o, "was ended by a signal after 0.5 s: Segmentation fault. Run it without glark")) << text_of(o);
}

TEST(Diagnosis, WithoutAContextItSaysWhyThatMayBe) {
  Observation o{.program = "tool", .ending = {Ending::How::left, 0, 0.2}};
  o.has_display = false;
  EXPECT_FALSE(is_refined(o));
  EXPECT_TRUE(says(o, "tool ended by itself after 0.2 s with exit status 0.\nNo process made an OpenGL context"))
      << text_of(o);
  EXPECT_TRUE(says(o, "Neither DISPLAY nor WAYLAND_DISPLAY is set")) << text_of(o);
  EXPECT_TRUE(says(o, "a copy of itself that runs already")) << text_of(o);
  o.processes = {{.number = 3, .name = "vkcube", .has_glark = true, .has_vulkan = true}};
  EXPECT_TRUE(says(o, "It uses Vulkan")) << text_of(o);
  o.processes = {{.number = 4, .name = "gpu", .has_gl = true}};
  EXPECT_TRUE(says(o, "gpu (process 4) uses OpenGL, but the library did not reach it")) << text_of(o);
}

TEST(Diagnosis, AContextThatCannotRefineOrDrawsNothing) {
  Observation o{.program = "old"};
  o.reports = {{.name = "old", .contexts = {{"3.1 Mesa", false}}}};
  EXPECT_TRUE(says(o, "context 3.1 Mesa cannot refine")) << text_of(o);
  EXPECT_TRUE(says(o, "drew nothing that glark sees")) << text_of(o);
}

TEST(Diagnosis, AnUnknownCauseOfANewerLibraryIsShownByItsKey) {
  Observation o = game();
  o.reports[0].left = {{"moon_phase", 100}};
  EXPECT_TRUE(says(o, "(10 %; moon_phase): moon_phase.")) << text_of(o);
}

TEST(ReadReport, TextThatIsNoStatisticsHasNoName) {
  for (const char* text : {"", "{", "[]", "3", "{\"draws\": 7}", "{\"program\": \"x\"}"})
    EXPECT_EQ(read_report(text).name, "");
}

}  // namespace glark::tool
