// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/text/operations.h"

#include <fmt/format.h>

#include <limits>

namespace glark::edit {
namespace {

constexpr std::size_t most_samples = std::numeric_limits<std::uint32_t>::max();

Operation read_paint(Words& words) {
  Paint paint{.ball = words.ball()};
  constexpr const char* names[] = {"RED", "GREEN", "BLUE"};
  for (std::size_t k = 0; k < 3; ++k) paint.colour[k] = static_cast<std::uint8_t>(words.whole(names[k], 255));
  if (!words.at_end()) paint.strength = words.up_to_one("STRENGTH");
  return paint;
}

Operation read_inflate(Words& words) {
  const Ball ball = words.ball();
  return Inflate{ball, words.number("AMOUNT")};
}

Operation read_smooth(Words& words) {
  Smooth smooth{.ball = words.ball()};
  if (!words.at_end()) smooth.strength = words.up_to_one("STRENGTH");
  return smooth;
}

Operation read_move(Words& words) {
  const Ball ball = words.ball();
  return Move{ball, words.vector("D")};
}

Operation read_bend(Words& words) {
  Bend bend;
  bend.from = words.vector("FROM_");
  bend.to = words.vector("TO_");
  bend.towards = words.vector("TOWARDS_");
  bend.angle = words.number("DEGREES");
  return bend;
}

Operation read_twist(Words& words) {
  Twist twist;
  twist.from = words.vector("FROM_");
  twist.to = words.vector("TO_");
  twist.angle = words.number("DEGREES");
  return twist;
}

Operation read_deform(Words& words) {
  Deform deform;
  deform.handle = words.ball();
  deform.free = {words.vector("FREE_"), words.above_zero("FREE_RADIUS")};
  deform.by = words.vector("D");
  if (words.at_end()) return deform;
  deform.axis = words.vector("AXIS_");
  deform.angle = words.number("DEGREES");
  return deform;
}

Operation read_symmetric(Words& words) {
  Symmetric symmetric;
  const std::string_view word = words.word("on or off");
  if (word != "on" && word != "off") throw BadWord(fmt::format("\"{}\" is neither on nor off", word));
  symmetric.on = word == "on";
  if (!symmetric.on) return symmetric;
  const std::string_view axis = words.word("AXIS");
  if (axis != "x" && axis != "y" && axis != "z") throw BadWord(fmt::format("AXIS is \"{}\", not x, y or z", axis));
  symmetric.axis = static_cast<unsigned>(axis[0] - 'x');
  if (!words.at_end()) symmetric.at = words.number("AT");
  return symmetric;
}

Operation read_refine(Words& words) {
  Refine refine{.ball = words.ball()};
  if (!words.at_end()) refine.most = words.whole("MOST", most_samples);
  return refine;
}

Operation read_project(Words& words) {
  Project project;
  project.picture = words.file("PICTURE");
  project.eye = words.vector("EYE_");
  project.target = words.vector("TARGET_");
  project.up = words.vector("UP_");
  project.angle = words.above_zero("DEGREES");
  if (!(project.angle < 180)) throw BadWord(fmt::format("DEGREES is {}; it must be below 180", project.angle));
  if (!words.at_end()) project.strength = words.up_to_one("STRENGTH");
  return project;
}

constexpr Row table[] = {
    {{"paint", "paint X Y Z RADIUS RED GREEN BLUE [STRENGTH]", "Mix a colour, 0 to 255, into those in the ball"},
     read_paint},
    {{"inflate", "inflate X Y Z RADIUS AMOUNT", "Move along the normals, outwards if AMOUNT is above 0"}, read_inflate},
    {{"smooth", "smooth X Y Z RADIUS [STRENGTH]", "Remove bumps; STRENGTH is 0 to 1"}, read_smooth},
    {{"move", "move X Y Z RADIUS DX DY DZ", "Move by a vector, less towards the border of the ball"}, read_move},
    {{"bend", "bend FROM_X FROM_Y FROM_Z TO_X TO_Y TO_Z TOWARDS_X TOWARDS_Y TOWARDS_Z DEGREES",
      "Bend the part between two places into an arc, whose centre lies towards a direction"},
     read_bend},
    {{"twist", "twist FROM_X FROM_Y FROM_Z TO_X TO_Y TO_Z DEGREES",
      "Turn about a line, from nothing to all of the angle"},
     read_twist},
    {{"deform", "deform X Y Z RADIUS FREE_X FREE_Y FREE_Z FREE_RADIUS DX DY DZ [AXIS_X AXIS_Y AXIS_Z DEGREES]",
      "Move and turn a handle; the surface follows inside the free ball, and is frozen outside"},
     read_deform},
    {{"symmetric", "symmetric on AXIS [AT], or symmetric off", "Mirror the operations that follow, at x, y or z = AT"},
     read_symmetric},
    {{"refine", "refine X Y Z RADIUS [MOST]", "Take more samples of the scan, at most MOST"}, read_refine},
    {{"project", "project PICTURE EYE_X EYE_Y EYE_Z TARGET_X TARGET_Y TARGET_Z UP_X UP_Y UP_Z DEGREES [STRENGTH]",
      "Paint a picture as a projector shows it, which is DEGREES high"},
     read_project},
    {{"undo", "undo", "Undo the last operation"}, [](Words&) -> Operation { return Undo{}; }},
    {{"redo", "redo", "Do again what was undone"}, [](Words&) -> Operation { return Redo{}; }},
};

constexpr auto table_of_forms = [] {
  std::array<Form, std::size(table)> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = table[i].form;
  return all;
}();

}  // namespace

std::span<const Row> rows() { return table; }

std::span<const Form> forms() { return table_of_forms; }

}  // namespace glark::edit
