/* SPDX-FileCopyrightText: 2026 The glark authors */
/* SPDX-License-Identifier: MIT */
/*
 * GL_ARK_adaptive_refinement: adaptive refinement patterns replace coarse triangles when they are drawn.
 * The extension's text is docs/spec/GL_ARK_adaptive_refinement.txt; the registry fragment is glark/gl/glark.xml.
 *
 * Include it alone, or after the GL header or loader of your choice (GL/gl.h, GLES3/gl32.h, epoxy, GLEW, glad, ...).
 * A loader generated with glark.xml already declares all of this; the header is then empty.
 *
 * Link with -lGLARK, or fetch the functions by name and define GLARK_NO_PROTOTYPES before the include.
 *
 * Depths are exponents: an edge of depth d becomes 2^d segments.
 * A command without an error list gives no error of its own.
 * Every command except glDepthTag1i gives GL_INVALID_OPERATION between glBegin and glEnd.
 */
#ifndef GLARK_GL_GLARK_H
#define GLARK_GL_GLARK_H

/* Every GL header defines GL_TRIANGLES as a macro, but the include guards differ. */
#ifndef GL_TRIANGLES
#include <GL/gl.h>
#endif
/* GLchar came with OpenGL 2.0. A GL/gl.h under GL_GLEXT_LEGACY lacks it. */
#if !defined(GL_VERSION_2_0) && !defined(GL_ES_VERSION_2_0)
#include <GL/glext.h>
#endif

#ifndef GL_ARK_adaptive_refinement
#define GL_ARK_adaptive_refinement 1

/* GLEW undefines APIENTRY, and the OpenGL ES headers have another name for it. So this header has its own macro. */
#ifndef GLARK_APIENTRY
#if defined(_WIN32) && !defined(__CYGWIN__)
#define GLARK_APIENTRY __stdcall
#else
#define GLARK_APIENTRY
#endif
#endif
#ifndef GLARK_API
#if defined(__GNUC__) && !defined(_WIN32)
#define GLARK_API extern __attribute__((visibility("default")))
#else
#define GLARK_API extern
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Capability: glEnable, glDisable, glIsEnabled. */
#define GL_ARK                                   0x6F00
/* Read-only state: glGetIntegerv and the similar queries. */
#define GL_MAX_DEPTH_ARK                         0x6F01 /* greatest maxLevel of glARKinit */
#define GL_POOL_LEVEL_ARK                        0x6F02 /* maxLevel of the last successful glARKinit; -1 before */
#define GL_CURRENT_DEPTH_TAG_ARK                 0x6F03

/* The depth tag array. GL_DEPTH_TAG_ARRAY_ARK is a capability and a client state. */
#define GL_DEPTH_TAG_ARRAY_ARK                   0x6F04
#define GL_DEPTH_TAG_ARRAY_TYPE_ARK              0x6F05
#define GL_DEPTH_TAG_ARRAY_STRIDE_ARK            0x6F06
#define GL_DEPTH_TAG_ARRAY_POINTER_ARK           0x6F07 /* glGetPointerv */
#define GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK    0x6F08

/* glARKParameteriARK: names, each followed by its values, the initial one first. */
#define GL_DEPTH_TAG_ATTRIBUTE_ARK               0x6F09 /* a generic attribute index; GL_MAX_VERTEX_ATTRIBS - 1 */
#define GL_REFINEMENT_ARK                        0x6F10
#define GL_LINEAR_INPUTS_ARK                     0x6F11
#define GL_LINEAR_OUTPUTS_ARK                    0x6F12
#define GL_CURVED_PN_ARK                         0x6F13
#define GL_SCALAR_TAGGED_PN_ARK                  0x6F30
#define GL_PHONG_ARK                             0x6F38
#define GL_DEPTH_SOURCE_ARK                      0x6F14
#define GL_DEPTH_TAG_ARK                         0x6F15
#define GL_UNIFORM_DEPTH_ARK                     0x6F16
#define GL_UNIFORM_DEPTH_LEVEL_ARK               0x6F17 /* 0 to the pool level; 0 */
#define GL_MEASURED_DEPTH_ARK                    0x6F23
#define GL_EDGE_PIXELS_ARK                       0x6F24 /* 0: no measure; 8 */
#define GL_EDGE_DEGREES_ARK                      0x6F25 /* 0 to 180, 0: no measure; 0 */
#define GL_SCREEN_ERROR_ARK                      0x6F3D /* a number, 0: no measure; glARKParameterfARK; 0 */
#define GL_TRIANGLE_BUDGET_ARK                   0x6F26 /* 0: none; 0 */
#define GL_GEOMORPH_ARK                          0x6F2F /* GL_FALSE, GL_TRUE */
#define GL_WELD_ARK                              0x6F3C /* GL_TRUE: vertices in the same place refine alike; GL_FALSE */
#define GL_POLYGON_SPLIT_ARK                     0x6F18
#define GL_POLYGON_TRIANGLES_ARK                 0x6F19
#define GL_POLYGON_CENTROID_ARK                  0x6F1A
#define GL_PATTERN_INTERIOR_ARK                  0x6F1B
#define GL_MINIMUM_INTERIOR_ARK                  0x6F1C
#define GL_SMOOTH_INTERIOR_ARK                   0x6F1D
#define GL_PHONG_SHAPE_ARK                       0x6F39 /* 0 to 1, for GL_PHONG_ARK; glARKParameterfARK; 0.75 */
#define GL_DISCONTINUITY_ATTRIBUTE_ARK           0x6F31 /* Delta and crease of each vertex; GL_MAX_VERTEX_ATTRIBS - 2 */
#define GL_SCALAR_TAG_ATTRIBUTE_ARK              0x6F32 /* sharpness, tension, bias; GL_MAX_VERTEX_ATTRIBS - 3 */
#define GL_DISPLACEMENT_UNIT_ARK                 0x6F33 /* a texture image unit, -1: no displacement; -1 */
#define GL_DISPLACEMENT_CHANNEL_ARK              0x6F34 /* GL_RED, GL_GREEN, GL_BLUE or GL_ALPHA; GL_RED */
#define GL_DISPLACEMENT_COORDINATE_ARK           0x6F35 /* a generic attribute index, -1: found by its name; -1 */
#define GL_DISPLACEMENT_SCALE_ARK                0x6F36 /* a number, glARKParameterfARK; 1 */
#define GL_DISPLACEMENT_BIAS_ARK                 0x6F37 /* a number, glARKParameterfARK; 0 */

/* glGetRefinementivARK. */
#define GL_REFINEMENT_STATUS_ARK                 0x6F20
#define GL_REFINEMENT_LOG_LENGTH_ARK             0x6F21
#define GL_REFINEMENT_SOURCE_LENGTH_ARK          0x6F22

typedef void (GLARK_APIENTRY *PFNGLARKINITPROC)(GLuint maxLevel);
typedef void (GLARK_APIENTRY *PFNGLARKPARAMETERIARKPROC)(GLenum pname, GLint param);
typedef void (GLARK_APIENTRY *PFNGLARKPARAMETERFARKPROC)(GLenum pname, GLfloat param);
typedef void (GLARK_APIENTRY *PFNGLDEPTHTAG1IPROC)(GLuint d);
typedef void (GLARK_APIENTRY *PFNGLDEPTHTAGPOINTERARKPROC)(GLenum type, GLsizei stride, const void *pointer);
typedef void (GLARK_APIENTRY *PFNGLDRAWARPPROC)(GLenum mode, GLint first, GLsizei count);
typedef void (GLARK_APIENTRY *PFNGLDRAWARPELEMENTSARKPROC)(GLenum mode, GLsizei count, GLenum type, const void *indices);
typedef void (GLARK_APIENTRY *PFNGLREFINEMENTSHADERSOURCEARKPROC)(GLuint program, GLsizei count, const GLchar *const*string, const GLint *length);
typedef void (GLARK_APIENTRY *PFNGLGETREFINEMENTIVARKPROC)(GLuint program, GLenum pname, GLint *params);
typedef void (GLARK_APIENTRY *PFNGLGETREFINEMENTINFOLOGARKPROC)(GLuint program, GLsizei bufSize, GLsizei *length, GLchar *infoLog);
#ifndef GLARK_NO_PROTOTYPES

/* Builds the pool of patterns for edge depths 0 to maxLevel, for the current context. A later call replaces the pool.
 * It lowers the current depth tag and the uniform depth level to maxLevel if they exceed it. A failed call changes
 * nothing.
 * Errors: GL_INVALID_VALUE if maxLevel > GL_MAX_DEPTH_ARK; GL_OUT_OF_MEMORY if the pool cannot be stored.
 * Source: Boubekeur 2007, ch. 7.2.3 and 7.5. */
GLARK_API void GLARK_APIENTRY glARKinit(GLuint maxLevel);

/* Sets a parameter of refinement. Names and values are listed above.
 *   GL_REFINEMENT_ARK: interpolate the vertex stage's inputs, or its outputs, or curve its inputs (PN, scalar-tagged
 *     PN, Phong).
 *   GL_DEPTH_SOURCE_ARK: depths from the tags of the vertices, or GL_UNIFORM_DEPTH_LEVEL_ARK for every edge, or
 *     measured.
 *   GL_EDGE_PIXELS_ARK: an edge gets the least depth at which its segments are at most this long on the screen.
 *   GL_EDGE_DEGREES_ARK: an edge gets the least depth at which a segment turns the normal by at most this angle.
 *   GL_SCREEN_ERROR_ARK: an edge gets the least depth at which its curve leaves its segments by at most so many pixels
 *     on the screen. If several measures are set, the least depth applies.
 *   GL_TRIANGLE_BUDGET_ARK: the number of refined triangles per frame; measured depths are lowered to keep it.
 *   GL_GEOMORPH_ARK: fractional depths move refined vertices from the coarser to the finer surface, so that no vertex
 *     pops.
 *   GL_POLYGON_SPLIT_ARK: divide quads and polygons as GL does, or as a fan about their centroid.
 *   GL_PATTERN_INTERIOR_ARK: fewest triangles, or a softer transition between edges of different depths.
 *   GL_DEPTH_TAG_ATTRIBUTE_ARK: index of the generic attribute that carries the tag; not 0 in the compatibility
 *     profile.
 *   GL_DISCONTINUITY_ATTRIBUTE_ARK, GL_SCALAR_TAG_ATTRIBUTE_ARK: indices of the generic attributes that carry the
 *     tags of chapter 8.
 *   GL_DISPLACEMENT_*_ARK: positions move along their normals by scale * texel + bias, with the GL_TEXTURE_2D of the
 *     unit.
 * Errors: GL_INVALID_ENUM for an unknown name, or a value that the name does not have. GL_INVALID_VALUE for a level
 * outside 0 to the pool level (0 before glARKinit), or for an attribute index, a measure or a budget out of range.
 * After an error, the state is unchanged. */
GLARK_API void GLARK_APIENTRY glARKParameteriARK(GLenum pname, GLint param);

/* As glARKParameteriARK, for GL_SCREEN_ERROR_ARK, GL_DISPLACEMENT_SCALE_ARK and _BIAS_ARK, and GL_PHONG_SHAPE_ARK.
 * Errors: GL_INVALID_ENUM for another name; GL_INVALID_VALUE if the number is not finite, or out of range. */
GLARK_API void GLARK_APIENTRY glARKParameterfARK(GLenum pname, GLfloat param);

/* Sets the current depth tag: the current value of generic attribute GL_DEPTH_TAG_ATTRIBUTE_ARK becomes (d, 0, 0, 1).
 * The following vertices get this tag, unless GL_DEPTH_TAG_ARRAY_ARK is enabled. Allowed between glBegin and glEnd;
 * compiled into display lists. Initially 0.
 * Errors: GL_INVALID_VALUE if d exceeds the pool level (0 before glARKinit).
 * Source: Boubekeur 2007, ch. 7.2.2 and 7.5. */
GLARK_API void GLARK_APIENTRY glDepthTag1i(GLuint d);

/* Sets the array of depth tags, one scalar per vertex: the array of generic attribute GL_DEPTH_TAG_ATTRIBUTE_ARK.
 *   type: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT or GL_FLOAT. Values are depths, not normalised. A
 *     float is rounded to the nearest integer, or with GL_GEOMORPH_ARK to the nearest 1/64. Every tag is clamped
 *     to 0 .. pool level.
 *   stride: bytes from one tag to the next; 0 if tightly packed.
 *   pointer: byte offset into the buffer bound to GL_ARRAY_BUFFER, or client memory. The caller owns the client
 *     memory and keeps it until the draws that read it return.
 * Errors: GL_INVALID_ENUM for another type; GL_INVALID_VALUE if stride is negative, or where glVertexAttribPointer
 * limits it; GL_INVALID_OPERATION for client memory where glVertexAttribPointer refuses it. */
GLARK_API void GLARK_APIENTRY glDepthTagPointerARK(GLenum type, GLsizei stride, const void *pointer);

/* Draws as glDrawArrays(mode, first, count), and refines even if GL_ARK is disabled.
 * Errors: those of glDrawArrays; GL_INVALID_ENUM unless mode is GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN or, in
 * the compatibility profile, GL_QUADS, GL_QUAD_STRIP or GL_POLYGON; GL_INVALID_OPERATION before glARKinit, or while a
 * display list is compiled.
 * Source: Boubekeur 2007, ch. 7.5. */
GLARK_API void GLARK_APIENTRY glDrawARP(GLenum mode, GLint first, GLsizei count);

/* Draws as glDrawElements(mode, count, type, indices), and refines even if GL_ARK is disabled.
 * Errors: those of glDrawElements, and those of glDrawARP. */
GLARK_API void GLARK_APIENTRY glDrawARPElementsARK(GLenum mode, GLsizei count, GLenum type, const void *indices);

/* Sets the application's refinement shader for `program`; 0 is the fixed function. The shader takes effect at the next
 * draw. It stays when the program is linked again.
 *   string: `count` strings, copied before the call returns, concatenated. Together they define `void refine()` in
 *     GLSL of the program's version, without #version. refine() may read ark_barycentric. For each active vertex input
 *     A, it may read ark_corner_A[3], and read and write A. For a built-in input, these are ark_corner_gl_Vertex and
 *     gl_Vertex.
 *   length: `count` lengths in bytes, a negative one for a null-terminated string; NULL if all are null-terminated.
 *   count: 0 removes the refinement shader.
 * Errors: GL_INVALID_VALUE if count is negative, or program is not a name that GL generated, or is 0 where there is no
 * fixed function; GL_INVALID_OPERATION if program is a shader object. Errors in the source are not GL errors: see
 * glGetRefinementivARK.
 * Source: Boubekeur 2007, ch. 7.2.4. */
GLARK_API void GLARK_APIENTRY glRefinementShaderSourceARK(GLuint program, GLsizei count, const GLchar *const*string, const GLint *length);

/* Writes one integer to *params:
 *   GL_REFINEMENT_STATUS_ARK: GL_TRUE if the refinement program of `program` builds. The query builds it if this was
 *     not tried yet.
 *   GL_REFINEMENT_LOG_LENGTH_ARK: bytes of the log of the last attempt to build, with its terminating null; 0 if it
 *     is empty.
 *   GL_REFINEMENT_SOURCE_LENGTH_ARK: bytes of the refinement shader's source with its terminating null; 0 if there is
 *     none.
 * Errors: as glRefinementShaderSourceARK for `program`; GL_INVALID_ENUM for another pname. After an error, *params is
 * unchanged. */
GLARK_API void GLARK_APIENTRY glGetRefinementivARK(GLuint program, GLenum pname, GLint *params);

/* Writes the log of the last attempt to build the refinement program of `program`.
 *   bufSize: bytes that infoLog can hold, the terminating null included.
 *   length: receives the bytes written without the terminating null; may be NULL.
 *   infoLog: owned by the caller; null-terminated unless bufSize is 0.
 * Errors: as glRefinementShaderSourceARK for `program`; GL_INVALID_VALUE if bufSize is negative. */
GLARK_API void GLARK_APIENTRY glGetRefinementInfoLogARK(GLuint program, GLsizei bufSize, GLsizei *length, GLchar *infoLog);

#endif /* GLARK_NO_PROTOTYPES */

#ifdef __cplusplus
}
#endif

#endif /* GL_ARK_adaptive_refinement */
#endif /* GLARK_GL_GLARK_H */
