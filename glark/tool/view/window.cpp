// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/window.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "glark/tool/view/gl.h"
#include "glark/tool/view/offscreen.h"

namespace glark::tool {
namespace {

constexpr char help[] =
    "left button turns, right button shifts, wheel zooms\n"
    "1 splats, 2 strips, 3 mesh, 4 wireframe, 5 refined, + and - its level\n"
    "C culling, U turns the model upright, R first view, S screenshot, Q quits\n";

class Viewer {
 public:
  Viewer(GLFWwindow* window, std::string title, geometry::Geometry geometry, const ViewOptions& options)
      : window_(window),
        title_(std::move(title)),
        options_(options),
        scene_(std::move(geometry)),
        camera_(camera_for(scene_, options)),
        mode_(options.mode.value_or(scene_.default_mode())) {
    scene_.cull = options.cull;
    scene_.refinement_level = options.level;
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) { self(of).moved(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* of, double, double y) {
      self(of).camera_.zoom *= std::pow(1.1F, static_cast<float>(y));
    });
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int) {
      if (action != GLFW_RELEASE) self(of).pressed(key);
    });
  }

  void run() {
    while (glfwWindowShouldClose(window_) == 0) {
      int width = 0;
      int height = 0;
      glfwGetFramebufferSize(window_, &width, &height);
      if (width > 0 && height > 0) frame(width, height);
      glfwWaitEvents();
    }
  }

 private:
  static Viewer& self(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

  void frame(int width, int height) {
    const Statistics drawn = scene_.draw(camera_, mode_, width, height);
    if (wants_screenshot_) take_screenshot(width, height);
    glfwSwapBuffers(window_);
    std::string title = fmt::format("{} - {} indices, {} points", title_, drawn.indices, drawn.points);
    if (drawn.strips > 0)
      title += fmt::format(", {} strips; of {} nodes {} out of view, {} turned away", drawn.strips, drawn.nodes_visited,
                           drawn.nodes_out_of_frustum, drawn.nodes_back_facing);
    glfwSetWindowTitle(window_, title.c_str());
  }

  void take_screenshot(int width, int height) {
    wants_screenshot_ = false;
    std::string file;
    do {
      file = fmt::format("glark-{}.png", ++screenshots_);
    } while (std::filesystem::exists(file));
    try {
      write_screenshot(file, width, height);
      std::printf("%s\n", file.c_str());
    } catch (const std::exception& error) {
      std::fprintf(stderr, "glark: %s\n", error.what());
    }
  }

  void moved(double x, double y) {
    const auto right = static_cast<float>(x - x_);
    const auto down = static_cast<float>(y - y_);
    x_ = x;
    y_ = y;
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) camera_.turn(right, down);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) camera_.shift(right, down, height);
  }

  void pressed(int key) {
    constexpr std::array modes{Mode::splat, Mode::strip, Mode::mesh, Mode::wireframe, Mode::refined};
    if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + static_cast<int>(modes.size()))
      mode_ = modes[static_cast<std::size_t>(key - GLFW_KEY_1)];
    if (key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD)
      scene_.refinement_level = std::min(scene_.refinement_level + 1, 4);
    if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT)
      scene_.refinement_level = std::max(scene_.refinement_level - 1, 0);
    if (key == GLFW_KEY_C) scene_.cull = !scene_.cull;
    if (key == GLFW_KEY_U) camera_.z_is_up = !camera_.z_is_up;
    if (key == GLFW_KEY_R) camera_ = camera_for(scene_, options_);
    if (key == GLFW_KEY_S) wants_screenshot_ = true;
    if (key == GLFW_KEY_Q || key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window_, GLFW_TRUE);
  }

  GLFWwindow* window_;
  std::string title_;
  ViewOptions options_;
  Scene scene_;
  Camera camera_;
  Mode mode_;
  double x_ = 0, y_ = 0;
  bool wants_screenshot_ = false;
  int screenshots_ = 0;
};

struct Library {
  Library() {
    if (glfwInit() == GLFW_FALSE)
      throw std::runtime_error("view: there is no display; write a picture with --offscreen OUT.png");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

}  // namespace

Camera camera_for(const Scene& scene, const ViewOptions& options) {
  Camera camera = scene.default_camera();
  camera.z_is_up = options.z_is_up.value_or(camera.z_is_up);
  camera.yaw = options.yaw.value_or(camera.yaw);
  camera.pitch = options.pitch.value_or(camera.pitch);
  camera.zoom = options.zoom.value_or(camera.zoom);
  return camera;
}

void show_window(const std::string& title, geometry::Geometry geometry, const ViewOptions& options) {
  const Library library;
  glfwWindowHint(GLFW_SAMPLES, 4);
  GLFWwindow* window = glfwCreateWindow(options.width, options.height, title.c_str(), nullptr, nullptr);
  if (window == nullptr)
    throw std::runtime_error("view: there is no window with OpenGL; write a picture with --offscreen OUT.png");
  glfwMakeContextCurrent(window);
  load_gl(glfwGetProcAddress);
  glfwSwapInterval(1);
  std::printf("%s", help);
  Viewer(window, title, std::move(geometry), options).run();
}

}  // namespace glark::tool
