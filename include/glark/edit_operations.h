// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The operations of an edited sampling, as values and as lines of text. Link to glark-edit.
//
// Lengths are in the unit of the scan's positions, angles in degrees. Positions are those of the edited sampling.
#ifndef GLARK_EDIT_OPERATIONS_H
#define GLARK_EDIT_OPERATIONS_H

#include <glark/error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace glark::edit {

enum class Element { option, array, operation, file };

// An error in an argument, an operation or a file: its name, its value, and the remedy.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

using Vector = std::array<double, 3>;
using Colour = std::array<std::uint8_t, 3>;  // red green blue

// The samples of a brush are those whose distance from the centre is at most the radius. A brush that moves samples has
// the weight (1 - x^2)^2 at the distance x * radius.
struct Ball {
  Vector centre{};
  double radius = 1;
};

// Mixes the colour into those of the samples, with the same weight for all. Samples without colours were white.
struct Paint {
  Ball ball;
  Colour colour{};
  double strength = 1;  // 0 to 1
};

// Moves samples along their normals.
struct Inflate {
  Ball ball;
  double amount = 0;  // at the centre; a negative amount moves inwards
};

// Moves samples along their normals towards the mean of their neighbours.
struct Smooth {
  Ball ball;
  double strength = 1;  // 0 to 1
};

struct Move {
  Ball ball;
  Vector by{};  // at the centre
};

// Bends the part between two planes into an arc. The planes are perpendicular to the line from `from` to `to`, and go
// through its ends. What lies before `from` stays; what lies beyond `to` turns as a whole.
// Source: A. Barr, Global and Local Deformations of Solid Primitives, 1984.
struct Bend {
  Vector from{}, to{1, 0, 0};
  Vector towards{0, 0, 1};  // the direction of the arc's centre; its part along the line is left out
  double angle = 0;         // of the whole arc
};

// Turns samples about the line from `from` to `to`, by a part of the angle that grows from 0 at `from` to 1 at `to`.
// Source: as Bend.
struct Twist {
  Vector from{}, to{1, 0, 0};
  double angle = 0;
};

// Moves the samples of the handle as a rigid body. Samples outside `free` are frozen. Between them, the parts of the
// motion are the smoothest ones (least squares of the Laplacian over the neighbours of each sample), so that the surface
// has no crease at the handle, nor at the frozen part. Samples that are not connected to the handle stay.
// Source: M. Botsch, L. Kobbelt, An Intuitive Framework for Real-Time Freeform Modeling, 2004.
struct Deform {
  Ball handle, free;
  Vector by{};
  Vector axis{0, 0, 1};  // through the centre of the handle
  double angle = 0;
};

// From now on, each operation is mirrored, too. Where both reach a sample, it moves by the weighted mean of both.
struct Symmetric {
  bool on = false;
  unsigned axis = 0;  // 0 to 2 for x, y, z: the mirror is perpendicular to it
  double at = 0;      // the mirror's coordinate
};

// Takes more samples of the scan inside the ball. Source: Boubekeur 2007, ch. 4.5.
struct Refine {
  Ball ball;
  std::size_t most = 0;  // the most new samples; 0: three for each sample in the ball
};

// Paints a picture as a projector would show it. Samples that are hidden or face away keep their colour.
struct Project {
  std::string picture;  // a file of PNG, JPEG, BMP or TGA; its name has no line breaks and no quotes
  Vector eye{}, target{0, 0, 1}, up{0, 1, 0};
  double angle = 45;    // between the upper and the lower edge of the picture, above 0 and below 180
  double strength = 1;  // 0 to 1
};

// Undoes the last operation, or does the last one again that was undone. Symmetric is a setting, which stays.
struct Undo {};
struct Redo {};

using Operation =
    std::variant<Paint, Inflate, Smooth, Move, Bend, Twist, Deform, Symmetric, Refine, Project, Undo, Redo>;

// How an operation is written as a line of text: words and numbers with blanks between.
struct Form {
  const char* name;  // "paint"
  const char* form;  // "paint X Y Z RADIUS RED GREEN BLUE [STRENGTH]"
  const char* help;  // one sentence
};
GLARK_EXPORT std::span<const Form> forms();

// Reads a line. Errors: Error for a line that is no operation. It names the word, and shows the right form.
GLARK_EXPORT Operation parse(std::string_view line);
// The line of an operation. parse() of it gives the same operation, to the last bit.
GLARK_EXPORT std::string text_of(const Operation& operation);

}  // namespace glark::edit

#endif  // GLARK_EDIT_OPERATIONS_H
