// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// State of the objects that several contexts share: shaders, programs, display lists, and when buffers were written.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "glark/core/state/arrays/buffer_stamps.h"
#include "glark/core/state/lists/display_list.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

class Programs;

struct ShareGroup {
  std::mutex
      mutex;  // guards the tables; taken where objects are made, linked or deleted, and at lookups outside the fast path
  std::unordered_map<GLuint, std::shared_ptr<const std::string>> compiled_sources;  // "": SPIR-V
  std::unordered_map<GLuint, std::shared_ptr<Program>> programs;
  std::unordered_map<GLuint, std::shared_ptr<DisplayList>> lists;
  std::vector<Programs*> contexts;     // one of each context that lives
  GLuint next_list_name = 0x60000000;  // names of our list segments: out of the way of the application's
  BufferStamps buffers;
  std::atomic<std::uint64_t> contexts_made{0};  // so far: each stamps with numbers of its own
  std::vector<GLuint> orphaned_buffers;  // of contexts that went without a chance to delete them; guarded by `mutex`
  std::atomic<bool> any_derived{false};
  std::atomic<bool> lists_push{false};  // or pop: a display list has glPushAttrib or glPopAttrib
  // Linked, deleted or derived programs: what refers to programs by their names is valid only while this stands still.
  std::atomic<std::uint64_t> program_epoch{1};
};

std::shared_ptr<ShareGroup> make_share_group();

}  // namespace glark::core
