// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A window of GLFW. Without GLFW, there are only pictures.
#include <cctype>
#include <cstdio>
#include <stdexcept>

#include "examples/common/frame.h"

#if LESSON_HAS_WINDOWS
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#endif

namespace lesson {

#if LESSON_HAS_WINDOWS
namespace {

GLFWwindow* window = nullptr;
const char* title = "";

void set_hints(Api api) {
  glfwWindowHint(GLFW_SAMPLES, 4);
  if (api == Api::gles) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  }
  if (api == Api::core) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  }
}

void print_keys(const Lesson& lesson) {
  for (const Key& key : lesson.keys) std::printf("%c  %s\n", key.key, key.help);
  std::printf("h  these lines\nq  quit\ndrag the mouse: turn the view\n");
  std::fflush(stdout);
}

// Characters, not keys: what is printed on the keyboard counts.
void typed(GLFWwindow* of, unsigned character) {
  const Lesson& lesson = *static_cast<const Lesson*>(glfwGetWindowUserPointer(of));
  if (character > 127 || press(lesson, static_cast<char>(character))) return;
  if (character == 'h') print_keys(lesson);
  if (character == 'q') glfwSetWindowShouldClose(of, GLFW_TRUE);
}

void moved(GLFWwindow* of, double x, double y) {
  static double last_x = x, last_y = y;
  if (glfwGetMouseButton(of, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
    view().turn += 0.4F * static_cast<float>(x - last_x);
    view().tilt += 0.4F * static_cast<float>(y - last_y);
  }
  last_x = x;
  last_y = y;
}

void loop(const Lesson& lesson) {
  while (glfwWindowShouldClose(window) == 0) {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    if (width > 0 && height > 0) draw_frame(lesson, width, height, glfwGetTime());
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}

}  // namespace

int show_window(const Lesson& lesson, const Arguments& arguments) {
  if (glfwInit() == GLFW_FALSE) throw std::runtime_error("there is no display; write a picture with --png FILE");
  set_hints(lesson.api);
  title = lesson.title;
  window = glfwCreateWindow(arguments.width, arguments.height, title, nullptr, nullptr);
  if (window == nullptr) throw std::runtime_error("there is no window with OpenGL; write a picture with --png FILE");
  glfwSetWindowUserPointer(window, const_cast<Lesson*>(&lesson));
  glfwSetCharCallback(window, typed);
  glfwSetCursorPosCallback(window, moved);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  if (lesson.begin) lesson.begin();
  press_all(lesson, arguments.keys);
  print_keys(lesson);
  loop(lesson);
  glfwDestroyWindow(window);
  glfwTerminate();
  return 0;
}

void say(const std::string& line) {
  if (silent()) return;
  if (window == nullptr) {
    std::puts(line.c_str());
    return;
  }
  glfwSetWindowTitle(window, (std::string(title) + ": " + line).c_str());
}

#else

int show_window(const Lesson&, const Arguments&) {
  throw std::runtime_error("built without GLFW, so there is no window; write a picture with --png FILE");
}

void say(const std::string& line) {
  if (!silent()) std::puts(line.c_str());
}

#endif

}  // namespace lesson
