// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Cuts captured quads again, in place. An invocation has a quad: it reads a word of all four vertices before it writes
// that word of both triangles. The includer supplies #version.
layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer Records { uint records[]; };
layout(std430, binding = 1) readonly buffer Count { uint count_command[]; };

uniform int record_offset;  // in words
uniform int corner_words;
uniform int quad_bound;
uniform int count_on_gpu;
uniform int about;       // the vertex of the boundary with which both triangles end
uniform int corners[4];  // polygons::Decomposition

void main() {
  int quad = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u);
  int quads = count_on_gpu != 0 ? min(quad_bound, int(count_command[1]) / 2) : quad_bound;
  if (quad >= quads) {
    return;
  }
  int first = record_offset + 6 * quad * corner_words;
  for (int word = 0; word < corner_words; ++word) {
    uint values[4];
    for (int i = 0; i < 4; ++i) {
      values[i] = records[first + corners[(about + i) & 3] * corner_words + word];
    }
    int to = first + word;
    records[to] = values[1];
    records[to + corner_words] = values[2];
    records[to + 2 * corner_words] = values[0];
    records[to + 3 * corner_words] = values[2];
    records[to + 4 * corner_words] = values[3];
    records[to + 5 * corner_words] = values[0];
  }
}
