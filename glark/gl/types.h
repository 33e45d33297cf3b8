// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// OpenGL's scalar types and enumerants, without prototypes of extension functions.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
