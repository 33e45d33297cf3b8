// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state that several contexts share: shaders, programs, display lists, and the times of buffer writes.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "glark/core/state/arrays/buffer_stamps.h"
#include "glark/core/state/assembly/assembly_program.h"
#include "glark/core/state/lists/display_list.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_binaries.h"
#include "glark/core/state/textures/texture_stamps.h"

namespace glark::core {

class Programs;

struct ShareGroup {
  // Guards the tables. It is taken when objects are made, linked or deleted, and at lookups outside the fast path.
  std::mutex mutex;
  std::unordered_map<GLuint, std::shared_ptr<const std::string>> compiled_sources;  // "": SPIR-V
  std::unordered_map<GLuint, std::shared_ptr<Program>> programs;
  std::unordered_map<GLuint, std::shared_ptr<DisplayList>> lists;
  ProgramBinaries binaries;
  AssemblyPrograms assembly;
  std::vector<Programs*> contexts;  // one for each context that lives
  // The name that our next list segment gets. Our names go down from the largest one, so that glGenLists gives the
  // application the same names as without glark: see buffer_names.cpp.
  GLuint next_list_name = 0xFFFFFFFE;
  BufferStamps buffers;
  TextureStamps textures;
  std::atomic<std::uint64_t> contexts_made{0};  // so far; gives each context its range of stamps
  std::vector<GLuint> orphaned_buffers;         // left by contexts that could not delete them; guarded by `mutex`
  std::atomic<bool> any_derived{false};
  std::atomic<bool> lists_push{false};     // a display list has glPushAttrib or glPopAttrib
  std::atomic<bool> maps_vertices{false};  // an evaluator's map of positions was enabled, perhaps in a list
  // Changes whenever a program is linked, deleted or derived. Data that refers to programs by name is valid only until
  // then.
  std::atomic<std::uint64_t> program_epoch{1};
};

std::shared_ptr<ShareGroup> make_share_group();

}  // namespace glark::core
