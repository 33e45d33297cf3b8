// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches GL through a plug-in opened with RTLD_LOCAL and RTLD_DEEPBIND. libOSMesa is in no global scope, and the
// plug-in prefers its own symbols to preloaded ones.
#include <dlfcn.h>

#include "tests/clients/scene/picture.h"

int main(int argc, char** argv) {
  const int frames = frame_count(argc, argv);
  void* plugin = dlopen(PLUGIN_PATH, RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  require(plugin != NULL, "the plug-in does not open");
  int (*render)(int, const char*);
  *(void**)&render = dlsym(plugin, "render_to_file");
  require(render != NULL, "the plug-in has no render_to_file");
  return render(frames, argv[2]);
}
