// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/weld/draw_weld.h"

#include <vector>

namespace glark::weld {
namespace {

// Words of a corner that differ between instances. Vertices of two instances are never welded.
std::vector<GLint> instance_words(const core::Environment& environment, const capture::Layout& layout) {
  std::vector<GLint> words;
  const auto add = [&](int offset, int count) {
    for (int word = 0; word < count; ++word) {
      words.push_back(offset + word);
    }
  };
  const auto advances = [&](int location) {
    return environment.state.arrays().attribute_source(location).divisor != 0;
  };
  for (const capture::Field& field : layout.fields) {
    if (field.name == "gl_InstanceID" || field.name == "gl_DrawID" ||
        (field.location >= 0 && advances(field.location))) {
      add(field.offset, field.words);
    }
  }
  if (layout.tagged && advances(static_cast<int>(environment.ark.tag_attribute))) {
    add(layout.tag_offset, 1);
  }
  return words;
}

}  // namespace

bool DrawWeld::run(WeldRequest request, const core::GpuBuffer& captured_count) {
  if (!request.plan->on || !(request.edges || request.tags || request.normals)) {
    return false;
  }
  const std::vector<GLint> keys = instance_words(env_, *request.layout);
  request.key_words = keys;
  stage_.run(request, captured_count.name());
  return true;
}

}  // namespace glark::weld
