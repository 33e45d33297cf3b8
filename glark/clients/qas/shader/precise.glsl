// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark_qas_precise is the qualifier that forbids fused operations, in versions of the language that have it.
#extension GL_ARB_gpu_shader5 : enable
#ifdef GL_ES
#define glark_qas_precise_from 320
#else
#define glark_qas_precise_from 400
#endif
#if __VERSION__ >= glark_qas_precise_from || (!defined GL_ES && defined GL_ARB_gpu_shader5)
#define glark_qas_precise precise
#else
#define glark_qas_precise
#endif
