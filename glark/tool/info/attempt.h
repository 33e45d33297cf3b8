// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One way to an OpenGL context, and what glark finds there.
#pragma once

namespace glark::tool {

using GetProc = void* (*)(const char* name);

enum class Api { desktop, es };

// Exit statuses of a child that tries one way; any other status is a crash.
inline constexpr int can_refine = 0;
inline constexpr int cannot_refine = 1;
inline constexpr int no_context = 2;

// Prints the current context. Returns one of the statuses.
int print_context(const char* way, Api api, GetProc get_proc);

// Makes a context of GLX on the display of the user, and prints it. Needs no window manager.
int try_glx(const char* way);

}  // namespace glark::tool
