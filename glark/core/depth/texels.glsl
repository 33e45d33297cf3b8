// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the passes read of earlier ones, as texels (objects/buffer_texels.h). The includer supplies the units
// GLARK_FIRST_TEXELS and, with GLARK_ENDS, GLARK_SECOND_TEXELS.

layout(binding = GLARK_FIRST_TEXELS) uniform highp usamplerBuffer record_texels;
uniform int record_offset;  // the texel of the first word of the first record

uint record_at(int word) { return texelFetch(record_texels, word).x; }
uvec3 records_at(int word) { return uvec3(record_at(word), record_at(word + 1), record_at(word + 2)); }

#if GLARK_ENDS
// Texel by texel: gl_Position of each corner, or of each point (measure/curve_points.glsl).
layout(binding = GLARK_SECOND_TEXELS) uniform highp usamplerBuffer end_texels;

vec4 end_at(int position) { return uintBitsToFloat(texelFetch(end_texels, position)); }
#endif
