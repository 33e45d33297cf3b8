// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A display list that is cut into segments: runs of state changes, and draws. Each segment is a GL list of ours. The
// application's list is compiled as calls of these lists, so that it works as before while GL_ARK is disabled. While
// GL_ARK is enabled, each draw segment is captured and refined when the list is called.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "glark/core/state/arrays/current_values.h"
#include "glark/core/state/fixed_function/material_parameters.h"
#include "glark/core/state/fixed_function/vertex_materials.h"
#include "glark/core/state/lists/polygon_sides.h"
#include "glark/gl/types.h"

namespace glark::core {

// A list that is called between glBegin and glEnd, and gives vertices.
struct VertexList {
  GLuint list = 0;
  bool offset = false;  // `list` is added to glListBase
};

// The parameters of the material that a segment sets between glBegin and glEnd.
struct SegmentMaterials {
  bool set = false;
  MaterialSet varying = 0;  // set after the first vertex
  MaterialSet carried = 0;  // the segment sets their attributes, too, from the first vertex on
  MaterialAttributes attributes = no_material_attributes();  // of `carried`

  // Some vertices inherit a material that the segment does not set.
  bool inherited() const { return (varying & ~carried) != 0; }
};

// The effects of a segment's calls besides drawing.
struct SegmentEffects {
  struct Value {
    int slot;
    CurrentValue value;
  };

  std::vector<Value> values;   // the last value of each attribute that the segment sets
  std::uint64_t set = 0;       // the slots of `values`
  std::uint64_t own = 0;       // slots set before the first vertex: no vertex inherits them
  bool opaque = false;         // it sets values that we do not follow: it must be executed each time
  bool late = false;           // a vertex after the first sets more attributes or components than those before
  bool touches_state = false;  // it sets state that refined draws depend on
  bool draws_shapes = false;   // it draws rectangles or evaluator meshes that are not refined
  bool draws_others = false;   // it draws points or lines
  bool changes_uniforms = false;
  SegmentMaterials materials;

  // None of these effects. GL may have compiled calls that are not followed.
  bool none() const {
    return values.empty() && !opaque && !touches_state && !draws_shapes && !draws_others && !changes_uniforms &&
           !materials.set;
  }
  // A current value changes in a way that is not followed. Values that were set before may be gone, and a vertex may get
  // what the list finds.
  void record_unknown(bool before_vertices) {
    opaque = true;
    late |= !before_vertices;
    values.clear();
    set = 0;
    own = 0;
  }
  // Null: it does not set the attribute.
  const CurrentValue* find(int slot) const {
    const auto found =
        std::find_if(values.begin(), values.end(), [slot](const Value& each) { return each.slot == slot; });
    return found != values.end() ? &found->value : nullptr;
  }
  void record(int slot, const CurrentValue& value, bool before_vertices) {
    if (slot < 0) {
      record_unknown(before_vertices);
      return;
    }
    if ((set & slot_bit(slot)) == 0) {
      late |= !before_vertices;
      own |= before_vertices ? slot_bit(slot) : 0;
      set |= slot_bit(slot);
      values.push_back({slot, value});
      return;
    }
    for (Value& known : values) {
      if (known.slot == slot) {
        late |= !before_vertices && known.value.again != value.again;  // perhaps of more components
        known.value = value;
      }
    }
  }
};

struct ListSegment {
  enum class Kind { state, draw, call, call_offset };
  Kind kind = Kind::state;
  GLuint list = 0;             // our list; call: the application's; call_offset: added to glListBase
  bool joins = false;          // call_offset: the same glCallLists calls the segment before it, and its base holds
  GLenum mode = GL_TRIANGLES;  // of a draw segment
  std::uint64_t vertices = 0;  // of a draw segment
  std::uint64_t triangles = 0;
  bool exact = true;                          // `triangles` is the count, not a bound
  bool sets_tags = false;                     // glDepthTag1i was called between its vertices
  bool whole_polygons = false;                // as in DrawCall
  PolygonSides polygon_sides = {};            // if not empty, as in DrawCall
  std::vector<VertexList> vertex_lists = {};  // their vertices are not in `vertices`
  std::uint64_t identity = 0;                 // never another segment's
  SegmentEffects effects = {};
};

// One change that a list makes to the attribute stack.
struct StackStep {
  enum class Kind { push, pop, call, call_offset };
  Kind kind = Kind::pop;
  GLuint value = 0;  // push: the mask; call: as ListSegment::list
};

struct DisplayList {
  std::vector<ListSegment> segments;
  std::vector<StackStep> stack_steps = {};
  bool refinable = false;  // false: call the application's list as it is
  bool changes_uniforms = false;
  bool calls_lists = false;
  bool ends_primitive = false;                       // it has a glEnd whose glBegin lies outside
  bool leaves_open = false;                          // it has a glBegin whose glEnd lies outside
  std::uint64_t loose_vertices = 0;                  // outside glBegin and glEnd, without those of lists that it calls
  std::vector<MaterialChange> loose_materials = {};  // the same
};

}  // namespace glark::core
