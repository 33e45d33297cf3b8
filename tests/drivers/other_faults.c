// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Faults of restart, queries, transform feedback, client state and fixed function.
#include "tests/drivers/faults.h"

#include <stdio.h>

static void draw_two_triangles(GLenum mode) { glDrawArrays(mode, 0, 6); }

// OpenGL 4.6, 10.3.6: only draws with indices restart.
static void show_restart_without_indices(void) {
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nout float number;\n"
             "void main() { number = float(gl_VertexID); gl_Position = vec4(1.0); }\n",
             "number");
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(4);
  print_fault("restart_arrays", capture(draw_two_triangles, GL_TRIANGLES).triangles, 2, "triangles of six vertices");
  glDisable(GL_PRIMITIVE_RESTART);
}

static void draw_quad(GLenum mode) { glDrawArrays(mode, 0, 4); }

// OpenGL 4.6 compatibility, 13.4: the last vertex of a quad provokes. Triangles that end with it can show its colour.
static void show_captured_provoking_vertex(void) {
  const Capture quad = capture(draw_quad, GL_QUADS);
  print_fault("captured_provoking", (quad.corners[2] == 3) + (quad.corners[5] == 3), 2,
              "triangles of a quad end with its last vertex");
}

// OpenGL 4.6, 4.2.3: the result of a query goes into a buffer. What is written beside it later must stay.
static void show_data_after_query(void) {
  const GLuint one = 1;
  GLuint words[5] = {0, 0, 0, 0, 0};
  GLuint buffer = 0;
  GLuint query = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  glBufferData(GL_COPY_WRITE_BUFFER, sizeof(words), words, GL_DYNAMIC_COPY);
  glGenQueries(1, &query);
  bind_result();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBuffer(GL_QUERY_BUFFER, buffer);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, (GLuint*)sizeof(GLuint));
  glBindBuffer(GL_QUERY_BUFFER, 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  glBufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, sizeof(one), &one);
  glDrawArraysIndirect(GL_TRIANGLES, NULL);
  glGetBufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, sizeof(words), words);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  print_fault("data_after_query", words[0], 1, "is the word that was written beside the result of a query");
}

// OpenGL 4.6, 13.3.2: a feedback may end while it is paused.
static void show_link_after_feedback(void) {
  GLint program = 0;
  GLuint other = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  other = program_of(GL_VERTEX_SHADER, "#version 330 compatibility\nvoid main() { gl_Position = vec4(1.0); }\n", NULL);
  glUseProgram((GLuint)program);
  bind_result();
  glBeginTransformFeedback(GL_TRIANGLES);
  glPauseTransformFeedback();
  glUseProgram(other);
  glEndTransformFeedback();
  while (glGetError() != GL_NO_ERROR) {
  }
  glLinkProgram(other);
  print_fault("link_after_feedback", glGetError(), 0,
              "is the error of glLinkProgram after a feedback that ended paused");
  // The driver believes in a feedback that goes on; the next one ends it.
  glUseProgram((GLuint)program);
  glBeginTransformFeedback(GL_TRIANGLES);
  glEndTransformFeedback();
}

// OpenGL 4.6 compatibility, chapter 22: arrays are client state, also those of a named vertex array.
static void show_client_arrays(void) {
  GLint enabled = 0;
  glEnableVertexAttribArray(7);
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glDisableVertexAttribArray(7);
  glPopClientAttrib();
  glGetVertexAttribiv(7, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
  glDisableVertexAttribArray(7);
  print_fault("client_arrays", (unsigned)enabled, 1, "says whether glPopClientAttrib restores an array");
}

static void draw_commands_of_client(GLenum mode) {
  static const GLuint commands[] = {3, 1, 0, 0, 0, 1, 0, 0, 3, 1, 3, 0};
  glMultiDrawArraysIndirect(mode, commands, 3, 0);
}

// OpenGL 4.6 compatibility, 10.4: commands in client memory, one of them without vertices.
static void show_client_commands(void) {
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nout float number;\n"
             "void main() { number = float(gl_VertexID); gl_Position = vec4(1.0); }\n",
             "number");
  print_fault("client_commands", capture(draw_commands_of_client, GL_TRIANGLES).triangles, 2,
              "triangles of three commands in client memory; the second has no vertices");
}

static unsigned red_of_square(float depth_left, float depth_right) {
  GLubyte pixel[4];
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glVertex3f(-1, -1, depth_left);
  glVertex3f(1, -1, depth_right);
  glVertex3f(1, 1, depth_right);
  glVertex3f(-1, 1, depth_left);
  glEnd();
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return pixel[0];
}

// OpenGL 4.6 compatibility, 12.1.3: a scale of 2 divides normals by 2, and gl_NormalScale is 2.
static void show_normal_scale(void) {
  program_of(GL_VERTEX_SHADER,
             "#version 120\nvoid main() { gl_Position = gl_Vertex; gl_FrontColor = vec4(0.25 * gl_NormalScale); }\n",
             NULL);
  glEnable(GL_RESCALE_NORMAL);
  glScalef(2, 2, 2);
  print_fault("normal_scale", (red_of_square(0, 0) + 16) / 32, 4, "is twice the gl_NormalScale of a scale of 2");
  glLoadIdentity();
  glDisable(GL_RESCALE_NORMAL);
}

// OpenGL 4.6 compatibility, 12.2.1.1: the vector from a vertex to a light divides both by their w. All four corners have the
// same colour, 0.8 / sqrt(3) and some ambient light.
static void show_light_of_w(void) {
  static const float position[] = {0, 0, 1, 1};
  GLubyte pixel[4];
  glUseProgram(0);
  glClear(GL_COLOR_BUFFER_BIT);
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHTING);
  glBegin(GL_QUADS);
  glNormal3f(0, 0, 1);
  glVertex4f(-2, -2, 0, 2);
  glVertex4f(2, -2, 0, 2);
  glVertex4f(2, 2, 0, 2);
  glVertex4f(-2, 2, 0, 2);
  glEnd();
  glDisable(GL_LIGHTING);
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  print_fault("light_of_w", pixel[0] > 100, 1, "says whether a light takes the place of a vertex with a w of 2");
}

// OpenGL 4.6 compatibility, 12.2.3: the current colour is the ambient material of back faces alone. The triangle shows
// its back. The light is black, so a fifth of the green is seen, the light of the scene.
static void show_color_of_back(void) {
  GLubyte pixel[4];
  glUseProgram(0);
  glClear(GL_COLOR_BUFFER_BIT);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  glColorMaterial(GL_BACK, GL_AMBIENT);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT2);
  glBegin(GL_TRIANGLES);
  glColor3f(-1, 1, 1);
  glVertex2f(-1, -1);
  glVertex2f(-1, 3);
  glVertex2f(3, -1);
  glEnd();
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  print_fault("color_of_back", pixel[1] > 40 && pixel[1] < 62, 1,
              "says whether back faces have the green of their material");
  glDisable(GL_COLOR_MATERIAL);
  glDisable(GL_LIGHTING);
  glDisable(GL_LIGHT2);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
}

// OpenGL 4.6 compatibility, 21.4: a list sets a current value, also between glBegin and glEnd without a vertex.
static void show_value_without_vertex(void) {
  float value[4] = {0, 0, 0, 0};
  const GLuint list = glGenLists(1);
  glVertexAttrib1f(5, 3);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  glVertexAttrib1f(5, 1);
  glEnd();
  glEndList();
  glCallList(list);
  glGetVertexAttribfv(5, GL_CURRENT_VERTEX_ATTRIB, value);
  print_fault("value_without_vertex", value[0] == 1, 1, "says whether a list without vertices sets a current value");
  glDeleteLists(list, 1);
}

// OpenGL 4.6 compatibility, 22.1: glPopAttrib restores current values, also one that was set last of all.
static void show_popped_value(void) {
  GLubyte pixel[4];
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\n"
             "void main() { gl_FrontColor = vec4(gl_MultiTexCoord1.y);\n"
             "  gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 4 * (gl_VertexID >> 1) - 1, 0, 1); }\n",
             NULL);
  glMultiTexCoord2f(GL_TEXTURE1, 1, 1);
  glPushAttrib(GL_CURRENT_BIT);
  glLightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 2);  // any other state
  glMultiTexCoord2f(GL_TEXTURE1, 0, 0);
  glPopAttrib();
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  print_fault("popped_value", pixel[1] > 200, 1,
              "says whether a shader sees the texture coordinate that glPopAttrib restores");
}

static void call_list_1(GLenum mode) {
  (void)mode;
  glCallList(1);
}

// OpenGL 4.6 compatibility, 21.4: vertices of a list have the current values that they find, and each belongs to the strip.
static void show_late_color(void) {
  glNewList(1, GL_COMPILE);
  glBegin(GL_TRIANGLE_STRIP);
  glVertex3f(0, 0, 0);
  glColor3f(1, 0, 0);
  glVertex3f(1, 0, 0);
  glVertex3f(0, 1, 0);
  glVertex3f(1, 1, 0);
  glEnd();
  glEndList();
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nout float corner;\n"
             "void main() { corner = gl_Vertex.x; gl_FrontColor = gl_Color; gl_Position = gl_Vertex; }\n",
             "corner");
  print_fault("late_color", capture(call_list_1, GL_TRIANGLES).triangles, 2,
              "triangles of a strip in a list that sets a colour after the first vertex");
  glDeleteLists(1, 1);
}

// OpenGL 4.6 compatibility, 17.4: both are allowed. Where depths change their sign, refinement shows it.
static void show_fog_of_fragments(void) {
  const float black[] = {0, 0, 0, 1};
  glUseProgram(0);
  glColor4f(1, 1, 1, 1);
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogfv(GL_FOG_COLOR, black);
  print_fault("fog_of_fragments", red_of_square(-0.5F, 0.5F) > 160, 0,
              "says whether each fragment takes the absolute depth");
  glDisable(GL_FOG);
}

// OpenGL 4.6, 7.6: a uniform keeps its value until it is set again, whichever programs run in between.
static void show_uniform_of_condition(void) {
  static const GLint conditions[] = {1, 1, 0, 0};
  GLint found[4] = {0, 0, 0, 0};
  GLuint buffer = 0;
  const GLuint other = program_of(GL_COMPUTE_SHADER,
                                  "#version 430\nlayout(local_size_x = 1) in;\n"
                                  "layout(std430, binding = 0) buffer Result { int results[]; };\n"
                                  "layout(location = 0) uniform int condition;\n"
                                  "void main() { if (condition == 1) results[0] = 1; }\n",
                                  NULL);
  const GLuint program =
      program_of(GL_COMPUTE_SHADER,
                 "#version 430\nlayout(local_size_x = 1) in;\n"
                 "layout(std430, binding = 0) buffer Result { int results[]; };\n"
                 "layout(location = 0) uniform int place;\n"
                 "layout(location = 1) uniform int condition;\n"
                 "void main() { if (condition == 1) results[place] = 1; else results[place] = 2; }\n",
                 NULL);
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof(found), found, GL_DYNAMIC_COPY);
  for (GLint i = 0; i < 4; ++i) {
    glUseProgram(program);
    glUniform1i(0, i);
    glUniform1i(1, conditions[i]);
    glDispatchCompute(1, 1, 1);
    glUseProgram(other);
    glDispatchCompute(1, 1, 1);
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(found), found);
  print_fault("uniform_of_condition", (unsigned)found[3], 2,
              "is the branch that a compute shader takes for a uniform that was 1 earlier, and is 0");
}

void show_other_faults(int version) {
  show_restart_without_indices();
  show_captured_provoking_vertex();
  show_client_arrays();
  if (version >= 43) {
    show_client_commands();
    show_link_after_feedback();
    show_uniform_of_condition();
  }
  if (version >= 44) {
    show_data_after_query();
  }
  show_normal_scale();
  show_light_of_w();
  show_color_of_back();
  show_value_without_vertex();
  show_popped_value();
  show_late_color();
  show_fog_of_fragments();
}
