// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A core profile context by GLFW. Every function comes from glfwGetProcAddress.
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
#include <GLFW/glfw3.h>

#include "tests/clients/scene/functions.h"

static struct {
  SCENE_SHADER_FUNCTIONS(DECLARE_GL)
  DECLARE_GL(GenVertexArrays)
  DECLARE_GL(BindVertexArray)
} found;
#define GL(name) found.gl##name
#define FIND_GL(name) found.gl##name = (__typeof__(&gl##name))glfwGetProcAddress("gl" #name);
#define SCENE_GLSL_VERTEX SCENE_GLSL_450_VERTEX
#define SCENE_GLSL_FRAGMENT SCENE_GLSL_450_FRAGMENT
#define SCENE_HAS_VAO 1

#include "tests/clients/scene/scene_shader.h"

int main(int argc, char** argv) {
  static unsigned char pixels[4 * picture_size * picture_size];
  const int frames = frame_count(argc, argv);
  require(glfwInit(), "glfwInit failed");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(picture_size, picture_size, "glfw", NULL, NULL);
  require(window != NULL, "no window of OpenGL 4.5 core");
  glfwMakeContextCurrent(window);
  SCENE_SHADER_FUNCTIONS(FIND_GL)
  FIND_GL(GenVertexArrays)
  FIND_GL(BindVertexArray)
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) {
    scene_draw();
    if (frame == frames - 1) scene_read(pixels);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
  glfwTerminate();
  return write_picture(argv[2], pixels);
}
