// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Turns the captured triangles of polygons into coarse records of triangles about the centroids. GLARK_PASS: 0
// centroids and face depths, 1 records. The includer supplies #version and GLARK_PASS.
// Based on: Boubekeur 2007, ch. 7.2.3, "ARP for General Polygonal Meshes" (edge depths, their mean as the face depth,
// the split at the centroid). Means are rounded down here; the thesis does not say how.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Captured { uint captured[]; };
layout(std430, binding = 1) buffer Split { uint split[]; };  // records, then one corner for each centroid
layout(std430, binding = 2) readonly buffer CapturedCount { uint captured_count[]; };
layout(std430, binding = 3) writeonly buffer SplitCount { uint split_count[]; };
// Two words per polygon and two more at the end: the first captured triangle, and the first record.
layout(std430, binding = 4) readonly buffer Table { uint table[]; };

uniform int record_offset;  // first captured triangle, in words
uniform int corner_words;
uniform int tag_offset;     // in a corner; < 0: there are no tags
uniform int first_integer;  // words from here to the tag are integers, the same at all vertices of a polygon
uniform int pool_level;
uniform int depth_steps;    // per level (edge_steps.glsl); depths of edges and faces are in steps
uniform int equal_sides;    // sides of every polygon; 0: the table has their numbers
uniform int polygon_bound;
uniform int count_on_gpu;
uniform int centroids;      // first word of the centroids
uniform int is_fan;
uniform int corners[4];     // polygons::Decomposition

// Returns the number of polygons that end by the entry `limit` in one of the table's columns.
int polygons_until(int column, int limit) {
  int from = 0;
  int to = polygon_bound;
  while (from < to) {
    int middle = (from + to + 1) / 2;
    if (int(table[2 * middle + column]) <= limit) {
      from = middle;
    } else {
      to = middle - 1;
    }
  }
  return from;
}

int sides_of(int polygon) {
  return equal_sides > 0 ? equal_sides : int(table[2 * polygon + 2] - table[2 * polygon]) + 2;
}

int polygon_count() {
  if (count_on_gpu == 0) {
    return polygon_bound;
  }
  int triangles = int(captured_count[1]);
  return equal_sides > 0 ? min(polygon_bound, triangles / (equal_sides - 2)) : polygons_until(0, triangles);
}

int first_record(int polygon) { return equal_sides > 0 ? polygon * equal_sides : int(table[2 * polygon + 1]); }

// First word of a vertex, in the order of the boundary.
int vertex_at(int polygon, int vertex) {
  int corner = 6 * polygon + corners[vertex & 3];
  if (is_fan != 0) {
    int triangle = clamp(vertex - 1, 0, sides_of(polygon) - 3);
    int first = equal_sides > 0 ? polygon * (equal_sides - 2) : int(table[2 * polygon]);
    corner = 3 * (first + triangle) + corners[vertex == 0 ? 0 : vertex - triangle];
  }
  return record_offset + corner * corner_words;
}

int tag_at(int vertex_word) {
  uint word = captured[vertex_word + tag_offset];
  if (int(word) <= 0 || word > 0x7f800000u) return 0;  // as in edge_steps.glsl
  float tag = uintBitsToFloat(word);
  float steps = min(tag * float(depth_steps), float(pool_level * depth_steps));
  float whole = floor(steps);  // steps + 0.5 would round values just below a half up to 1
  return int(whole) + (steps - whole >= 0.5 ? 1 : 0);
}

int next(int polygon, int vertex) { return vertex + 1 < sides_of(polygon) ? vertex + 1 : 0; }

int edge_depth(int polygon, int edge) {
  return (tag_at(vertex_at(polygon, edge)) + tag_at(vertex_at(polygon, next(polygon, edge)))) >> 1;
}

#if GLARK_PASS == 0

int face_depth(int polygon) {
  int sum = 0;
  int sides = sides_of(polygon);
  for (int edge = 0; edge < sides; ++edge) {
    sum += edge_depth(polygon, edge);
  }
  return sum / sides;
}

float mean(int polygon, int word) {
  precise float sum = uintBitsToFloat(captured[vertex_at(polygon, 0) + word]);
  int sides = sides_of(polygon);
  for (int vertex = 1; vertex < sides; ++vertex) {
    sum += uintBitsToFloat(captured[vertex_at(polygon, vertex) + word]);
  }
  return sum / float(sides);
}

void main() {
  int word = int(gl_WorkGroupID.y);
  int stride = int(gl_NumWorkGroups.x) * 64;
  for (int polygon = int(gl_GlobalInvocationID.x); polygon < polygon_count(); polygon += stride) {
    uint value;
    if (word == tag_offset) {
      value = floatBitsToUint(float(face_depth(polygon)) / float(depth_steps));
    } else if (word >= first_integer) {
      value = captured[vertex_at(polygon, 0) + word];
    } else {
      value = floatBitsToUint(mean(polygon, word));
    }
    split[centroids + polygon * corner_words + word] = value;
  }
}

#else

void main() {
  int records = first_record(polygon_count());
  if (gl_GlobalInvocationID.x == 0u && count_on_gpu != 0) {
    split_count[1] = uint(records);
  }
  int stride = int(gl_NumWorkGroups.x) * 64;
  for (int record = int(gl_GlobalInvocationID.x); record < records; record += stride) {
    int polygon = equal_sides > 0 ? record / equal_sides : polygons_until(1, record);
    int edge = record - first_record(polygon);
    int first = vertex_at(polygon, edge);
    int second = vertex_at(polygon, next(polygon, edge));
    int middle = centroids + polygon * corner_words;
    int to = 3 * record * corner_words;
    for (int word = 0; word < corner_words; ++word) {
      split[to + word] = captured[first + word];
      split[to + corner_words + word] = captured[second + word];
      split[to + 2 * corner_words + word] = split[middle + word];
    }
    // The depths of edges 0, 1 and 2 replace the tags. The centroid holds the depth of both inner edges.
    if (tag_offset >= 0) {
      split[to + tag_offset] = floatBitsToUint(float(edge_depth(polygon, edge)) / float(depth_steps));
      split[to + corner_words + tag_offset] = split[middle + tag_offset];
    }
  }
}

#endif
