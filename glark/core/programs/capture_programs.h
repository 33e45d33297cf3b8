// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The programs that capture the draws of derived programs. Each context has its own: Mesa 22 cannot draw with one
// program from two threads, and the application may share its programs between two contexts.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "glark/core/capture/capture.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class CapturePrograms {
 public:
  struct Entry {
    GLuint name = 0;          // 0: it could not be built
    std::vector<int> inputs;  // the attributes that it reads, by AttributeSlot
  };

  CapturePrograms(const Environment& environment, capture::CaptureStage& stage) : env_(environment), stage_(stage) {}

  // Builds the program when it is first asked for. The name is 0, too, if the program must wait for the next frame. The entry lives as long as the derived program.
  const Entry& find(const std::shared_ptr<DerivedProgram>& derived);
  void clear() { entries_.clear(); }

 private:
  const Environment& env_;
  capture::CaptureStage& stage_;
  std::map<std::weak_ptr<const DerivedProgram>, Entry, std::owner_less<>> entries_;
};

}  // namespace glark::core
