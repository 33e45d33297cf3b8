// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads the limits that measure.glsl makes. The includer declares `limits`.

float pixel_limit(int depth) { return limits[1 + depth]; }
float cosine_limit(int depth) { return limits[1 + GLARK_DEPTHS + depth]; }
float error_limit() { return limits[1 + 2 * GLARK_DEPTHS]; }
