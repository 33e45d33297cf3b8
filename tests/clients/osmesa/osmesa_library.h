// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The interface of osmesa_library.
#pragma once

// Draws the scene `frames` times and writes the last frame to `path`. Returns 0 on success.
int render_to_file(int frames, const char* path);
