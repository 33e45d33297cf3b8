#version 310 es
// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Is the shared rule valid GLSL? Compiled by glslangValidator, never run.
#extension GL_GOOGLE_include_directive : require
precision highp float;
precision highp int;
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Instances { vec4 patches[]; };
int emitted = 0;
#define GLARK_EMIT(piece, ou, ov, s, r) patches[emitted++ + (piece)] = vec4(ou, ov, s, r)
#include "glark/core/pattern/expand.glsl.h"
void main() { expand_pattern(1, 2, 3, 1); }
