// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Operations as a mirror shows them.
#pragma once

#include <glark/edit.h>

namespace glark::edit {

inline Vector mirrored_direction(Vector v, const Symmetric& mirror) {
  v[mirror.axis] = -v[mirror.axis];
  return v;
}
inline Vector mirrored_place(Vector v, const Symmetric& mirror) {
  v[mirror.axis] = mirror.at + (mirror.at - v[mirror.axis]);
  return v;
}
inline Ball mirrored(const Ball& ball, const Symmetric& mirror) {
  return {mirrored_place(ball.centre, mirror), ball.radius};
}

inline Paint mirrored(Paint o, const Symmetric& mirror) {
  o.ball = mirrored(o.ball, mirror);
  return o;
}
inline Inflate mirrored(Inflate o, const Symmetric& mirror) {
  o.ball = mirrored(o.ball, mirror);
  return o;
}
inline Smooth mirrored(Smooth o, const Symmetric& mirror) {
  o.ball = mirrored(o.ball, mirror);
  return o;
}
inline Move mirrored(const Move& o, const Symmetric& mirror) {
  return {mirrored(o.ball, mirror), mirrored_direction(o.by, mirror)};
}
inline Bend mirrored(const Bend& o, const Symmetric& mirror) {
  return {mirrored_place(o.from, mirror), mirrored_place(o.to, mirror), mirrored_direction(o.towards, mirror), o.angle};
}
// A mirror reverses the sense of a rotation.
inline Twist mirrored(const Twist& o, const Symmetric& mirror) {
  return {mirrored_place(o.from, mirror), mirrored_place(o.to, mirror), -o.angle};
}
inline Deform mirrored(const Deform& o, const Symmetric& mirror) {
  return {mirrored(o.handle, mirror), mirrored(o.free, mirror), mirrored_direction(o.by, mirror),
          mirrored_direction(o.axis, mirror), -o.angle};
}
inline Refine mirrored(Refine o, const Symmetric& mirror) {
  o.ball = mirrored(o.ball, mirror);
  return o;
}

// The operation, and the mirrored one if the mirror is on.
template <class Kind>
std::vector<Kind> with_mirror(const Kind& operation, const Symmetric& mirror) {
  std::vector<Kind> both{operation};
  if (mirror.on) both.push_back(mirrored(operation, mirror));
  return both;
}

}  // namespace glark::edit
