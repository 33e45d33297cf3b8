// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A GL context of our own that draws to the program's window. It shares nothing with the program's contexts, so the
// panel changes none of their state and takes none of their names.
#pragma once

#include <memory>

#include "shim/contexts/provider.h"
#include "shim/contexts/surface.h"

namespace glark::shim {

class PanelContext {
 public:
  PanelContext() = default;
  virtual ~PanelContext() = default;
  PanelContext(const PanelContext&) = delete;
  PanelContext& operator=(const PanelContext&) = delete;

  // Makes our context current for the surface of the program's current context; false: the window system refuses.
  virtual bool enter(const Surface& surface) = 0;
  // Makes the program's context current again, as enter() found it.
  virtual void leave() = 0;
};

// For the calling thread's current context, which has a surface. Null if the window system gives no such context.
std::unique_ptr<PanelContext> make_panel_context(Provider provider, void* native, const Surface& surface);

// The implementations for the two window systems.
std::unique_ptr<PanelContext> make_glx_panel_context(void* native, const Surface& surface);
std::unique_ptr<PanelContext> make_egl_panel_context(void* native, const Surface& surface);

}  // namespace glark::shim
