// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches GL by being linked to libOSMesa.
#include "tests/clients/osmesa/osmesa_scene.h"

int main(int argc, char** argv) { return draw_in_memory(frame_count(argc, argv), argv[2]); }
