// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches GL through a library that is linked to libOSMesa, as VTK's programs do. A preloaded libGL would break such a
// program.
#include "tests/clients/osmesa/osmesa_library.h"
#include "tests/clients/scene/picture.h"

int main(int argc, char** argv) { return render_to_file(frame_count(argc, argv), argv[2]); }
