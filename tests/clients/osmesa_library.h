// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The function of osmesa_library.
#pragma once

// Draws the scene `frames` times and writes the last one to `path`; 0 when that worked.
int render_to_file(int frames, const char* path);
