// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/settings.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "glark/settings/names/nearest_name.h"
#include "glark/settings/table.h"

namespace glark::settings {
namespace {

Parsed parse_all(std::vector<const char*> environment) {
  environment.push_back(nullptr);
  return parse(environment.data());
}

std::string only_problem(const char* entry) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", entry});
  return parsed.problems.size() == 1 ? parsed.problems[0] : "";
}

}  // namespace

TEST(Settings, AnEmptyEnvironmentGivesTheDefaults) {
  const Parsed parsed = parse(nullptr);
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_FALSE(parsed.settings.context.transparent);
  EXPECT_EQ(parsed.settings.context.level, 2u);
  EXPECT_EQ(parsed.settings.log_level, core::LogLevel::warning);
  EXPECT_TRUE(parsed.settings.captures.empty());
}

TEST(Settings, SmoothIsTheDefault) {
  for (const core::ContextOptions& context :
       {parse(nullptr).settings.context, parse_all({"GLARK_REFINE=smooth"}).settings.context}) {
    EXPECT_TRUE(context.smooth);
    EXPECT_EQ(context.refinement, core::Refinement::pn);
  }
  const core::ContextOptions pn = parse_all({"GLARK_REFINE=pn"}).settings.context;
  EXPECT_FALSE(pn.smooth);
  EXPECT_EQ(pn.refinement, core::Refinement::pn);
  EXPECT_TRUE(parse_all({"GLARK_REFINE=cubic"}).settings.context.smooth) << "a wrong word changes nothing";
}

TEST(Settings, DefaultsOfTheTableAreThoseOfTheCore) {
  const Settings parsed = parse(nullptr).settings;
  const Settings constructed;
  EXPECT_EQ(parsed.context.max_level, constructed.context.max_level);
  EXPECT_EQ(parsed.context.left_draws, constructed.context.left_draws);
  EXPECT_EQ(parsed.context.weld, constructed.context.weld);
  EXPECT_EQ(parsed.context.crease, constructed.context.crease);
  EXPECT_EQ(parsed.context.measure.on(), constructed.context.measure.on());
  EXPECT_TRUE(parsed.given.empty());
}

TEST(Settings, EveryDefaultIsAValidValue) {
  for (const Setting& setting : table()) {
    Settings settings;
    EXPECT_FALSE(shown_default(setting).empty()) << setting.key;
    EXPECT_TRUE(setting.initial.empty() || setting.read(settings, setting.initial)) << setting.key;
  }
}

TEST(Settings, TheConformanceSuiteMakesItsOwnCalls) {
  const char* const environment[] = {"GLARK_ENABLE=1", nullptr};
  const std::string names[] = {"glark-conformance"};
  EXPECT_FALSE(parse(environment, names).settings.context.transparent);
  const char* const wanted[] = {"GLARK_ENABLE=1", "GLARK_LEAVE_ALONE=0", nullptr};
  EXPECT_TRUE(parse(wanted, names).settings.context.transparent);
}

TEST(Settings, EveryVariableIsRead) {
  const Parsed parsed =
      parse_all({"GLARK_ENABLE=1", "GLARK_LEVEL=4", "GLARK_MAX_LEVEL=9", "GLARK_REFINE=outputs", "GLARK_WIREFRAME=1",
                 "GLARK_LOG=debug", "GLARK_STATS=s.json", "GLARK_CAPTURE=7:a.png"});
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_TRUE(parsed.settings.context.transparent);
  EXPECT_EQ(parsed.settings.context.level, 4u);
  EXPECT_EQ(parsed.settings.context.max_level, 9u);
  EXPECT_EQ(parsed.settings.context.refinement, core::Refinement::linear_outputs);
  EXPECT_TRUE(parsed.settings.context.wireframe);
  EXPECT_EQ(parsed.settings.log_level, core::LogLevel::debug);
  EXPECT_EQ(parsed.settings.statistics_file, "s.json");
  EXPECT_EQ(parsed.settings.captures, (std::vector<CaptureRequest>{{7, "a.png"}}));
}

TEST(Settings, ANameIsNotTakenForALongerOne) {
  EXPECT_EQ(parse_all({"GLARK_LEVELS=4", "XGLARK_LEVEL=5"}).settings.context.level, 2u);
}

TEST(Settings, AProblemNamesVariableValueAndLimit) {
  EXPECT_EQ(only_problem("GLARK_LEVEL=x"), "GLARK_LEVEL is \"x\"; an integer from 0 to 11 is needed");
  EXPECT_EQ(only_problem("GLARK_MAX_LEVEL=12"), "GLARK_MAX_LEVEL is \"12\"; an integer from 0 to 11 is needed");
  EXPECT_EQ(only_problem("GLARK_REFINE=cubic"),
            "GLARK_REFINE is \"cubic\"; smooth, linear, outputs, pn, stpn or phong is needed");
  EXPECT_EQ(parse_all({"GLARK_ENABLE=maybe"}).problems,
            (std::vector<std::string>{"GLARK_ENABLE is \"maybe\"; 0 or 1 is needed"}));
  EXPECT_EQ(only_problem("GLARK_LOG=loud"), "GLARK_LOG is \"loud\"; error, warning, info or debug is needed");
  EXPECT_EQ(only_problem("GLARK_CAPTURE=a.png"),
            "GLARK_CAPTURE is \"a.png\"; FRAME:FILE.png, with frames counted from 1, is needed");
}

TEST(Settings, AProblemLeavesTheDefault) { EXPECT_EQ(parse_all({"GLARK_LEVEL=-1"}).settings.context.level, 2u); }

// The same pictures in each run: a frame that is captured does not depend on how fast the driver compiles.
TEST(Settings, CapturesWaitForTheCompiler) {
  EXPECT_FALSE(parse_all({"GLARK_ENABLE=1"}).settings.context.wait);
  EXPECT_TRUE(parse_all({"GLARK_ENABLE=1", "GLARK_WAIT=1"}).settings.context.wait);
  EXPECT_TRUE(parse_all({"GLARK_ENABLE=1", "GLARK_CAPTURE=3:x.png"}).settings.context.wait);
}

TEST(Settings, ALevelRaisesTheLimitThatNobodySet) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_LEVEL=8"});
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_EQ(parsed.settings.context.level, 8u);
  EXPECT_EQ(parsed.settings.context.max_level, 8u);
}

TEST(Settings, ALimitThatIsSetHoldsTheLevelBack) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_LEVEL=8", "GLARK_MAX_LEVEL=3"});
  EXPECT_EQ(parsed.settings.context.level, 3u);
  ASSERT_EQ(parsed.problems.size(), 1u);
  EXPECT_EQ(parsed.problems[0], "--level 8 exceeds --max-level 3; level 3 is used; raise --max-level");
}

TEST(Settings, Measures) {
  const Parsed parsed =
      parse_all({"GLARK_ENABLE=1", "GLARK_EDGE_PIXELS=7.5", "GLARK_CURVATURE=12", "GLARK_BUDGET=50000"});
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_EQ(parsed.settings.context.measure, (core::EdgeMeasure{.pixels = 7.5F, .degrees = 12, .budget = 50000}));
  EXPECT_FALSE(parse_all({}).settings.context.measure.on());
  EXPECT_FALSE(parse_all({"GLARK_EDGE_PIXELS=0"}).settings.context.measure.on());
}

TEST(Settings, AScreenErrorIsAMeasure) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_SCREEN_ERROR=0.75", "GLARK_BUDGET=50000"});
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_EQ(parsed.settings.context.measure, (core::EdgeMeasure{.error = 0.75F, .budget = 50000}));
  EXPECT_TRUE(parsed.settings.context.measure.on());
}

TEST(Settings, ABudgetNeedsAMeasure) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_BUDGET=50000"});
  ASSERT_EQ(parsed.problems.size(), 1u);
  EXPECT_EQ(parsed.problems[0], "--budget has no effect without --edge-pixels, --curvature or --screen-error");
}

TEST(Settings, Tension) {
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_REFINE=stpn", "GLARK_TENSION=-0.5"});
  EXPECT_EQ(parsed.settings.context.refinement, core::Refinement::scalar_tagged_pn);
  EXPECT_EQ(parsed.settings.context.shape_numbers[static_cast<std::size_t>(core::Refinement::scalar_tagged_pn)], -0.5F);
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_EQ(only_problem("GLARK_TENSION=1.5"), "GLARK_TENSION is \"1.5\"; a number from -1 to 1 is needed");
  EXPECT_EQ(only_problem("GLARK_TENSION=1"), "--tension has no effect without --refine stpn");
  EXPECT_EQ(only_problem("GLARK_PHONG_SHAPE=1"), "--phong-shape has no effect without --refine phong");
}

TEST(Settings, GeomorphingNeedsAMeasure) {
  EXPECT_EQ(only_problem("GLARK_GEOMORPH=1"),
            "--geomorph has no effect without --edge-pixels, --curvature or --screen-error");
  const Parsed parsed = parse_all({"GLARK_ENABLE=1", "GLARK_GEOMORPH=1", "GLARK_CURVATURE=5"});
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_TRUE(parsed.settings.context.geomorph);
}

TEST(Settings, NormalsAreGivenOrFromGeometry) {
  EXPECT_FALSE(parse_all({}).settings.context.geometry_normals);
  EXPECT_TRUE(parse_all({"GLARK_NORMALS=geometry"}).settings.context.geometry_normals);
  EXPECT_FALSE(parse_all({"GLARK_NORMALS=given"}).settings.context.geometry_normals);
  for (const char* text : {"", "none", "Geometry"}) EXPECT_FALSE(parse_normals(text)) << text;
}

TEST(Settings, CreasesAreAngles) {
  EXPECT_EQ(parse_all({"GLARK_CREASE=0"}).settings.context.crease, 0);
  EXPECT_EQ(parse_all({"GLARK_CREASE=62.5"}).settings.context.crease, 62.5F);
  EXPECT_EQ(only_problem("GLARK_CREASE=sharp"), "GLARK_CREASE is \"sharp\"; degrees from 0 to 180 is needed");
}

TEST(Settings, PolygonsAreSplitInOneOfTwoWays) {
  EXPECT_TRUE(parse_all({"GLARK_POLYGONS=centroid"}).settings.context.centroids);
  EXPECT_FALSE(parse_all({"GLARK_POLYGONS=triangles"}).settings.context.centroids);
  EXPECT_EQ(only_problem("GLARK_POLYGONS=fan"), "GLARK_POLYGONS is \"fan\"; triangles or centroid is needed");
}

TEST(Settings, AnUnknownVariableIsToldWithTheNearestName) {
  EXPECT_EQ(only_problem("GLARK_LEVLE=3"),
            "GLARK_LEVLE is not a variable of glark and has no effect; is GLARK_LEVEL meant?");
  EXPECT_EQ(only_problem("GLARK_MAXLEVEL=3"),
            "GLARK_MAXLEVEL is not a variable of glark and has no effect; is GLARK_MAX_LEVEL meant?");
  EXPECT_EQ(only_problem("GLARK_BANANAS_AND_PEARS=3"),
            "GLARK_BANANAS_AND_PEARS is not a variable of glark and has no effect; man glark lists them");
  EXPECT_EQ(only_problem("GLARK_LIBRARY=/lib/libGLARK.so"), "");
  EXPECT_EQ(only_problem("GLARKLEVEL=3"), "");
}

TEST(Settings, SettingsThatChangeNothingAreTold) {
  EXPECT_EQ(only_problem("GLARK_LEVEL=0"), "--level 0 refines nothing; give a level of 1 or more");
  EXPECT_EQ(only_problem("GLARK_MAX_LEVEL=3"),
            "--max-level has no effect without --level, --edge-pixels, --curvature or --screen-error");
  const auto problems = [](std::vector<const char*> environment) {
    environment.push_back("GLARK_ENABLE=1");
    return parse_all(std::move(environment)).problems;
  };
  using Problems = std::vector<std::string>;
  EXPECT_EQ(problems({"GLARK_LEVEL=3", "GLARK_EDGE_PIXELS=8"}),
            (Problems{"--level has no effect on draws that --edge-pixels or --screen-error measures; --max-level "
                      "limits their depth"}));
  EXPECT_EQ(
      problems({"GLARK_NO_WELD=1", "GLARK_REFINE=outputs"}),
      (Problems{"--no-weld has no effect without --curvature, --screen-error or a --refine that curves triangles"}));
  EXPECT_EQ(problems({"GLARK_EVERYTHING=1", "GLARK_LEAVE_DRAWS=none"}),
            (Problems{"--leave-draws has no effect beside --everything"}));
  EXPECT_EQ(problems({"GLARK_EVERYTHING=1", "GLARK_LEAVE_ALONE=1"}),
            (Problems{"--everything has no effect beside --leave-alone"}));
  EXPECT_EQ(problems({"GLARK_NO_WELD=1", "GLARK_REFINE=pn", "GLARK_LEVEL=3", "GLARK_MAX_LEVEL=9"}), Problems());
}

TEST(Settings, AVariableThatIsSetToItsDefaultIsToldToo) {
  EXPECT_EQ(only_problem("GLARK_TENSION=0"), "--tension has no effect without --refine stpn");
}

TEST(Settings, RefinementThatIsNotEnabledIsTold) {
  EXPECT_EQ(parse_all({"GLARK_LEVEL=3", "GLARK_REFINE=pn"}).problems,
            (std::vector<std::string>{
                "GLARK_LEVEL has no effect without GLARK_ENABLE=1 on a program that does not call the extension"}));
}

TEST(NearestName, IsTheOneWithTheFewestDifferences) {
  constexpr std::array<std::string_view, 3> names{"level", "leave-draws", "log"};
  EXPECT_EQ(nearest_name("levle", names), "level");
  EXPECT_EQ(nearest_name("leave_draw", names), "leave-draws");
  EXPECT_EQ(nearest_name("LEVEL", names), "level");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("colour", names), "");
  EXPECT_EQ(nearest_name(std::string(1000, 'l'), names), "");
}

TEST(ParseMeasures, RejectWhatIsNoMeasure) {
  for (const char* text : {"", "-1", "0.1", "10001", "1e2", "8px", "nan", "inf", " 8", "0x8", "8,5"})
    EXPECT_FALSE(parse_edge_pixels(text)) << text;
  for (const char* text : {"", "181", "-5", "0.4", "nan"}) EXPECT_FALSE(parse_curvature(text)) << text;
  for (const char* text : {"", "181", "-1", "nan", "80deg"}) EXPECT_FALSE(parse_crease(text)) << text;
  for (const char* text : {"", "-1", "1.5", "1000000001", "1e6"}) EXPECT_FALSE(parse_budget(text)) << text;
}

TEST(ParseLevel, RejectsWhatIsNoLevel) {
  EXPECT_EQ(parse_level("11"), 11u);
  for (const char* text : {"", "12", "-1", "1.5", "2x", " 2", "0x2", "99999999999"})
    EXPECT_FALSE(parse_level(text)) << text;
}

TEST(ParseCaptures, ACommaSeparatesOnlyBeforeAFrame) {
  EXPECT_EQ(parse_captures("1:a.png,20:b,c.png"), (std::vector<CaptureRequest>{{1, "a.png"}, {20, "b,c.png"}}));
}

TEST(ParseCaptures, RejectsWhatIsNoRequest) {
  for (const char* text : {"a.png", "0:a.png", "x:a.png", "1:a.jpg", "1:", "1:.png", "1:a.png,b"})
    EXPECT_FALSE(parse_captures(text)) << text;
}

}  // namespace glark::settings
