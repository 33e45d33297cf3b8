// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Pictures that are projected onto a sampling.
#include "tests/edit/scan_folder.h"

namespace glark::edit {
namespace {

// A folder with a picture of 2 x 2 pixels: red green over blue white. It is a TGA file without compression.
class Projecting : public ScanFolder {
 protected:
  void SetUp() override {
    ScanFolder::SetUp();
    std::string bytes(18, '\0');
    bytes[2] = 2;                                                                  // true colour
    bytes[12] = bytes[14] = 2;                                                     // width and height
    bytes[16] = 24;                                                                // bits
    bytes[17] = 0x20;                                                              // rows from the top
    bytes += std::string("\x00\x00\xff\x00\xff\x00\xff\x00\x00\xff\xff\xff", 12);  // blue green red of each pixel
    made("four.tga", bytes);
  }
  // From above, onto the square [-1, 1]^2 and a little more.
  std::string from_above() const { return "project \"" + path("four.tga").string() + "\" 0 0 1.001 0 0 0 0 1 0 90"; }
};

Colour colour_at(const Editor& editor, double x, double y, double z) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < editor.size(); ++i)
    if (distance(position(editor.positions(), i), {x, y, z}) < distance(position(editor.positions(), best), {x, y, z}))
      best = i;
  return {editor.colours()[3 * best], editor.colours()[3 * best + 1], editor.colours()[3 * best + 2]};
}

TEST_F(Projecting, PixelsLieWhereTheProjectorShowsThem) {
  Editor editor(plane(41));
  edit::apply(editor, from_above());
  EXPECT_EQ(colour_at(editor, -1, 1, 0), (Colour{255, 0, 0}));
  EXPECT_EQ(colour_at(editor, 1, 1, 0), (Colour{0, 255, 0}));
  EXPECT_EQ(colour_at(editor, -1, -1, 0), (Colour{0, 0, 255}));
  EXPECT_EQ(colour_at(editor, 1, -1, 0), (Colour{255, 255, 255}));
  EXPECT_EQ(colour_at(editor, 0, 1, 0), (Colour{128, 128, 0}));  // half-way between the centres of two pixels
}

TEST_F(Projecting, HiddenSamplesKeepTheirColour) {
  Sampling two = plane(41);  // and a smaller square below it, which the first one hides
  for (std::size_t i = 0; i < 41 * 41; ++i) {
    for (std::size_t k = 0; k < 2; ++k) two.positions.push_back(0.8 * two.positions[3 * i + k]);
    two.positions.push_back(-0.9);
    two.normals.insert(two.normals.end(), {0, 0, 1});
  }
  two.colours.assign(two.positions.size(), 7);
  Editor editor(two);
  edit::apply(editor, from_above());
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const bool is_painted =
        !std::equal(&editor.colours()[3 * i], &editor.colours()[3 * i] + 3, Colour{7, 7, 7}.begin());
    EXPECT_EQ(is_painted, i < 41 * 41) << i;
  }
}

TEST_F(Projecting, SamplesThatFaceAwayKeepTheirColour) {
  Editor editor(sphere(2000));
  edit::apply(editor, "project \"" + path("four.tga").string() + "\" 0 0 5 0 0 0 0 1 0 45");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const double z = editor.positions()[3 * i + 2];
    const int sum = editor.colours()[3 * i] + editor.colours()[3 * i + 1] + editor.colours()[3 * i + 2];
    if (z < 0.15) {
      EXPECT_EQ(sum, 765) << i;
    }
  }
  EXPECT_EQ(editor.colours()[2], 128);  // the top sample is in the middle of the picture
}

TEST_F(Projecting, TheMirrorShowsItToo) {
  Editor editor(plane(41));
  edit::apply(editor, "symmetric on x");
  edit::apply(editor, "project \"" + path("four.tga").string() + "\" 0.61 0 0.307 0.61 0 0 0 1 0 90");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d p = position(editor.positions(), i);
    const Colour a = colour_at(editor, p.x, p.y, p.z), b = colour_at(editor, -p.x, p.y, p.z);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1) << i;  // the samples are mirrored but for rounding
  }
  EXPECT_NE(colour_at(editor, 0.4, -0.2, 0), (Colour{255, 255, 255}));
}

TEST_F(Projecting, ASessionKeepsThePicture) {
  std::string live;
  {
    Session session = open();
    session.apply(parse("project \"" + path("four.tga").string() + "\" 0 0 5 0 0 0 0 1 0 45"));
    live = bytes_of(session.editor());
  }
  std::filesystem::remove(path("four.tga"));
  EXPECT_TRUE(bytes_of(open().editor()) == live);
}

TEST_F(Projecting, MistakesAreExplained) {
  Editor editor(plane(5));
  made("no.png", "no picture");
  const std::string no = path("no.png").string(), four = path("four.tga").string();
  const auto problem = [&](const std::string& line) { return problem_of([&] { edit::apply(editor, line); }); };
  EXPECT_NE(problem("project " + no + " 0 0 1 0 0 0 0 1 0 90").find("cannot be read as a picture"), std::string::npos);
  EXPECT_NE(problem("project " + four + " 0 0 1 0 0 1 0 1 0 90").find("at the target"), std::string::npos);
  EXPECT_NE(problem("project " + four + " 0 0 1 0 0 0 0 0 1 90").find("along the up direction"), std::string::npos);
  EXPECT_NE(problem("project " + four + " 0 0 1 0 0 9 0 1 0 90").find("meets no sample"), std::string::npos);
  EXPECT_TRUE(editor.colours().empty());
}

}  // namespace
}  // namespace glark::edit
