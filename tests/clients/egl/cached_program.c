// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The core profile client with its program in a cache.
static void link_from_cache(unsigned program);
#define SCENE_LINK link_from_cache
#include "egl_surfaceless.c"  // NOLINT(bugprone-suspicious-include): the same client with another way to link

#define LOAD_BINARY glProgramBinary
#define SAVE_BINARY glGetProgramBinary
#include "program_cache.h"
