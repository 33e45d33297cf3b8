// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function scene, drawn to memory by OSMesa, for the clients that reach libOSMesa in different ways.
#pragma once

#include <GL/osmesa.h>

#define GL(name) gl##name

#include "tests/clients/scene/scene_fixed.h"

static int draw_in_memory(int frames, const char* path) {
  static unsigned char buffer[4 * picture_size * picture_size];
  static unsigned char pixels[4 * picture_size * picture_size];
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  require(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, picture_size, picture_size), "no OSMesa context");
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) scene_draw();
  scene_read(pixels);
  OSMesaDestroyContext(context);
  return write_picture(path, pixels);
}
