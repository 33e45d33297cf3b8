// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glark/edit.h>

namespace glark::edit {
namespace {

// A number is written with the fewest digits that give the same bits.
std::string text_of(const Vector& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }
std::string text_of(const Ball& ball) { return fmt::format("{} {}", text_of(ball.centre), ball.radius); }

std::string line_of(const Paint& o) {
  return fmt::format("paint {} {} {} {} {}", text_of(o.ball), o.colour[0], o.colour[1], o.colour[2], o.strength);
}
std::string line_of(const Inflate& o) { return fmt::format("inflate {} {}", text_of(o.ball), o.amount); }
std::string line_of(const Smooth& o) { return fmt::format("smooth {} {}", text_of(o.ball), o.strength); }
std::string line_of(const Move& o) { return fmt::format("move {} {}", text_of(o.ball), text_of(o.by)); }
std::string line_of(const Bend& o) {
  return fmt::format("bend {} {} {} {}", text_of(o.from), text_of(o.to), text_of(o.towards), o.angle);
}
std::string line_of(const Twist& o) { return fmt::format("twist {} {} {}", text_of(o.from), text_of(o.to), o.angle); }
std::string line_of(const Deform& o) {
  return fmt::format("deform {} {} {} {} {}", text_of(o.handle), text_of(o.free), text_of(o.by), text_of(o.axis),
                     o.angle);
}
std::string line_of(const Symmetric& o) {
  return o.on ? fmt::format("symmetric on {} {}", "xyz"[o.axis], o.at) : "symmetric off";
}
std::string line_of(const Refine& o) { return fmt::format("refine {} {}", text_of(o.ball), o.most); }
std::string line_of(const Project& o) {
  return fmt::format("project \"{}\" {} {} {} {} {}", o.picture, text_of(o.eye), text_of(o.target), text_of(o.up),
                     o.angle, o.strength);
}
std::string line_of(const Undo& /*o*/) { return "undo"; }
std::string line_of(const Redo& /*o*/) { return "redo"; }

}  // namespace

std::string text_of(const Operation& operation) {
  return std::visit([](const auto& each) { return line_of(each); }, operation);
}

}  // namespace glark::edit
