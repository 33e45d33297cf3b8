// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/edit.h>

#include "sphere_points.h"

int main() {
  namespace edit = glark::edit;
  const std::vector<float> points = sphere_points(1000);
  edit::Sampling sampling;
  sampling.positions.assign(points.begin(), points.end());
  edit::Editor editor(sampling);
  editor.apply(edit::parse("move 0 0 0 9 0 0 1"));
  const double moved = editor.positions()[2] - editor.positions_before()[2];
  editor.apply(edit::Undo{});
  return moved > 0.9 && editor.positions()[2] == editor.positions_before()[2] ? 0 : 1;
}
