// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Decides which positions are in one place. A cell is the name of a place. weld.glsl includes this file.
// - Where triangles follow their normals without limits (API programs), positions are the same if their bits are.
// - Where they stay near their coarse ones (transparent manner), positions are the same if they differ by rounding.
//   sin(2 pi) is not sin(0), so the seam of a ball would be open otherwise. Positions are rounded to a grid whose step
//   is a millionth of the extent of the draw.
//
// Rounding can separate two near positions that lie on both sides of a border between cells. Where they are expected,
// there is a middle of a cell: seams and poles lie on the axes of a mesh, through the origin or through the middle of
// its extent.

#if GLARK_CREASED
uniform int extent_offset;  // in the tables: the extent
const int extent_words = 6;  // the greatest coordinates, then the least ones, as ordered bits

vec3 middle_of_cells;
float cells_per_unit = 0.0;  // a power of two; 0: the bits decide

bool is_finite(uvec3 words) { return all(lessThan(words & 0x7fffffffu, uvec3(0x7f800000u))); }

// Whole numbers in the order of the numbers that the bits mean. No number has 0.
uint ordered(uint bits) { return bits >= 0x80000000u ? ~bits : bits | 0x80000000u; }
float unordered(uint word) { return uintBitsToFloat(word >= 0x80000000u ? word & 0x7fffffffu : ~word); }

void extend_to(int word, uint value) {
  if (value > tables[word]) {
    atomicMax(tables[word], value);
  }
}

void extend(int corner) {
  uvec3 position = position_of(corner).xyz;
  if (!is_finite(position)) {
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    uint word = ordered(position[axis]);
    extend_to(extent_offset + axis, word);
    extend_to(extent_offset + 3 + axis, ~word);
  }
}

// The step is a power of two. It is at least some units in the last place of the greatest coordinate.
void find_cells() {
  const int exponent_of_steps = 20;  // in half of the extent, rounded up
  if (tables[extent_offset] == 0u) {
    return;
  }
  float size = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    precise float greatest = 0.5 * unordered(tables[extent_offset + axis]);
    precise float least = 0.5 * unordered(~tables[extent_offset + 3 + axis]);
    precise float middle = greatest + least;
    precise float half_of_extent = greatest - least;
    size = max(size, max(half_of_extent, 0.25 * abs(middle)));
    middle_of_cells[axis] = abs(middle) < 0.5 * half_of_extent ? 0.0 : middle;
  }
  int exponent = int(floatBitsToUint(size) >> 23) - 126;
  cells_per_unit = size > 0.0 ? uintBitsToFloat(uint(127 + min(exponent_of_steps - exponent, 126)) << 23) : 0.0;
}

uvec4 cell_of(int corner) {
  uvec4 position = position_of(corner);
  if (cells_per_unit == 0.0 || !is_finite(position.xyz)) {
    return position;
  }
  precise vec3 steps = (uintBitsToFloat(position.xyz) - middle_of_cells) * cells_per_unit;
  return uvec4(uvec3(ivec3(roundEven(steps))), position.w);
}

// The order of two sides by their positions, which differ within their cells.
int order_in_cells(uint side, uint other) {
  for (int end = 0; end < 2; ++end) {
    uvec4 a = position_of(end_of_side(side, end == 1));
    uvec4 b = position_of(end_of_side(other, end == 1));
    if (a != b) {
      return before(a, b) ? -1 : 1;
    }
  }
  return 0;
}
#else
void find_cells() {}
uvec4 cell_of(int corner) { return position_of(corner); }
int order_in_cells(uint side, uint other) { return 0; }
#endif
