// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The library between osmesa_indirect or osmesa_plugin and libOSMesa. Only this library is linked to libOSMesa.
#include "tests/clients/osmesa/osmesa_library.h"

#include "tests/clients/osmesa/osmesa_scene.h"

int render_to_file(int frames, const char* path) { return draw_in_memory(frames, path); }
