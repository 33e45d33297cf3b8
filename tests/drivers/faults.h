// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the files of the faults share.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#define MOST_CORNERS 64

typedef struct {
  unsigned triangles;
  float corners[MOST_CORNERS];  // the number of each vertex
} Capture;

// A program of one shader, in use. `captured`: an output that transform feedback captures, or NULL.
GLuint program_of(GLenum stage, const char* source, const char* captured);
// Adds a fragment shader, and links again.
void add_fragment_shader(GLuint program, const char* source);
// Binds a new buffer for MOST_CORNERS captured numbers.
void bind_result(void);
// Returns the triangles of a draw, as transform feedback captures them.
Capture capture(void (*draw)(GLenum), GLenum mode);
void print_fault(const char* name, unsigned found, unsigned expected, const char* what);

// OpenGL, drawing to a small framebuffer, with a vertex array. 0: there is no context.
int make_context(void);

// Crashes, each in a process of its own. Call before there is a context.
void find_crashes(void);
void print_crashes(void);

// Prints the faults of restart, queries, transform feedback, client state and fixed function. `version`: that of OpenGL,
// 43 for 4.3.
void show_other_faults(int version);
