// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/frame.h"

#include <array>

#include "glark/core/context.h"
#include "shim/contexts/contexts.h"
#include "shim/contexts/thread.h"
#include "shim/frames/frame_capture.h"
#include "shim/frames/recorder.h"
#include "shim/live/live_settings.h"
#include "shim/live/settings_watch.h"
#include "shim/report/statistics.h"

#if GLARK_PANEL
#include "shim/panel/overlay.h"
#endif

namespace glark::shim {
namespace {

// A window that is split must know its middle.
void note_window_size(const core::Context& context) {
  if (!context.options().live.split) return;
  const Size size = current_size();
  const std::array window{static_cast<unsigned>(size.width), static_cast<unsigned>(size.height)};
  if (window != context.options().live.window)
    change_live([&](core::ContextOptions& options) { options.live.window = window; });
}

}  // namespace

void frame_ended() {
  core::Context* context = thread().context;
  if (context == nullptr) return;
  context->frame_finished();
  watch_settings();
  note_window_size(*context);
#if GLARK_PANEL
  overlay_frame(*context);
#endif
  current_ends_frame();
  capture_frame(*context, current_frame());
  record_frame(*context);
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
