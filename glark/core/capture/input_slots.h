// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/state/arrays/attribute_slots.h"

namespace glark::core {

// The AttributeSlot of "gl_Vertex", "gl_Normal", ...; no_slot for any other name.
int slot_of_builtin(std::string_view name);

// The attributes that a capture of `layout` reads, by AttributeSlot. An attribute that glark does not follow is
// no_slot.
std::vector<int> input_slots(const capture::Layout& layout, GLuint tag_attribute);

}  // namespace glark::core
