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

bool is_finite(uint word) { return (word & 0x7fffffffu) < 0x7f800000u; }

// Whole numbers in the order of the numbers that the bits mean. No number has 0.
uint ordered(uint bits) { return bits >= 0x80000000u ? ~bits : bits | 0x80000000u; }
float unordered(uint word) { return uintBitsToFloat(word >= 0x80000000u ? word & 0x7fffffffu : ~word); }

void extend(int corner) {
  for (int axis = 0; axis < corners_of_triangle; ++axis) {
    uint position = word_of(corner, position_offset + axis);
    for (int end = 0; end < ends_of_edge && is_finite(position); ++end) {
      uint value = end == 0 ? ordered(position) : ~ordered(position);
      int word = extent_offset + 3 * end + axis;
      if (value > tables[word]) {
        atomicMax(tables[word], value);
      }
    }
  }
}

// The step is a power of two. It is at least some units in the last place of the greatest coordinate.
void find_cells() {
  const int exponent_of_steps = 20;  // in half of the extent, rounded up
  float size = 0.0;
  for (int axis = 0; axis < corners_of_triangle; ++axis) {
    uint most = tables[extent_offset + axis];
    if (most == 0u) {
      continue;  // no coordinate is finite
    }
    precise float greatest = 0.5 * unordered(most);
    precise float least = 0.5 * unordered(~tables[extent_offset + 3 + axis]);
    precise float middle = greatest + least;
    precise float half_of_extent = greatest - least;
    size = max(size, max(half_of_extent, 0.25 * abs(middle)));
    middle_of_cells[axis] = abs(middle) < 0.5 * half_of_extent ? 0.0 : middle;
  }
  int exponent = int(floatBitsToUint(size) >> 23) - 126;
  cells_per_unit = size > 0.0 ? uintBitsToFloat(uint(127 + min(exponent_of_steps - exponent, 126)) << 23) : 0.0;
}

// A word of the cell of a corner.
uint cell_word(int corner, int i) {
  uint word = word_of(corner, position_offset + i);
  if (i > 2 || cells_per_unit == 0.0 || !is_finite(word)) {
    return word;
  }
  precise float steps = (uintBitsToFloat(word) - middle_of_cells[i]) * cells_per_unit;
  return uint(int(roundEven(steps)));
}
#else
void find_cells() {}
uint cell_word(int corner, int i) { return word_of(corner, position_offset + i); }
#endif

int cell_words() { return position_words; }

uint hash_of_cell(int corner) {
  uint hash = 0u;
  for (int i = 0; i < cell_words(); ++i) {
    hash = hashed(hash, cell_word(corner, i));
  }
  return hash;
}

// 0: both corners have the same cell; -1: that of `a` comes first; 1: that of `b`.
int order_of_cells(int a, int b) {
  for (int i = 0; i < cell_words(); ++i) {
    uint word = cell_word(a, i);
    uint other = cell_word(b, i);
    if (word != other) {
      return word < other ? -1 : 1;
    }
  }
  return 0;
}
