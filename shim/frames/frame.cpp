// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/frame.h"

#include "glark/core/context.h"
#include "shim/contexts/contexts.h"
#include "shim/contexts/thread.h"
#include "shim/frames/frame_capture.h"
#include "shim/report/statistics.h"

namespace glark::shim {

void frame_ended() {
  core::Context* context = thread().context;
  if (context == nullptr) return;
  context->frame_finished();
  current_ends_frame();
  capture_frame(*context, current_frame());
  frame_counted();
}

}  // namespace glark::shim

// Without a window, a frame ends when the program waits for it.

GLARK_EXPORT void glFinish() {
  using namespace glark::shim;
  if (current_is_offscreen()) frame_ended();
  thread().gl->Finish();
}

GLARK_EXPORT void glFlush() {
  using namespace glark::shim;
  if (current_is_offscreen()) frame_ended();
  thread().gl->Flush();
}
