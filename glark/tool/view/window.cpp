// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/window.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "glark/tool/view/controls/gl_window.h"
#include "glark/tool/view/offscreen.h"
#include "glark/tool/view/view_panel.h"

namespace glark::tool {
namespace {

constexpr int edge_pixels_of_maps = 4;  // unless the options say otherwise

class Viewer {
 public:
  Viewer(GLFWwindow* window, std::string title, std::vector<Model> models, const ViewOptions& options)
      : window_(window), title_(std::move(title)), options_(options) {
    for (Model& model : models) add(model);
    state_.settings = settings_for(scenes_, options);
    state_.most_maps = most_maps(scenes_);
    state_.camera = camera_for(*scenes_.front(), options);
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) { self(of).moved(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* of, double, double y) { self(of).scrolled(y); });
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int) {
      if (action != GLFW_RELEASE) self(of).pressed(key);
    });
    panel_.emplace(window);
  }

  void run() {
    while (glfwWindowShouldClose(window_) == 0) {
      int width = 0;
      int height = 0;
      glfwGetFramebufferSize(window_, &width, &height);
      if (width > 0 && height > 0) frame(width, height);
      wait();
    }
  }

 private:
  static Viewer& self(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

  void add(Model& model) {
    scenes_.push_back(std::make_unique<Scene>(std::move(model.geometry), model.maps));
    if (model.distances.empty()) return;
    state_.greatest_distance = greatest_shown(model.distances);
    scenes_.back()->colour_by(model.distances, state_.greatest_distance);
  }

  // Controls need two more frames after an event: to see it, and to show what it changes.
  void wait() {
    if (state_.turntable || frames_after_event_ > 0) {
      --frames_after_event_;
      glfwPollEvents();
    } else {
      glfwWaitEvents();
      frames_after_event_ = 2;
    }
  }

  void frame(int width, int height) {
    if (state_.turntable) state_.camera.yaw = std::remainder(state_.camera.yaw + 1, 360.0F);
    if (std::exchange(state_.wants_first_view, false)) state_.camera = camera_for(*scenes_.front(), options_);
    clear_window();
    Statistics drawn;
    for (std::size_t i = 0; i < scenes_.size(); ++i)
      drawn = sum(drawn, scenes_[i]->draw(state_.camera, state_.settings, part_of(i, scenes_.size(), width, height)));
    if (std::exchange(state_.wants_screenshot, false)) take_screenshot(width, height);
    panel_->draw(state_, drawn);
    glfwSwapBuffers(window_);
    const std::string title = fmt::format("{} - {} indices, {} points", title_, drawn.indices, drawn.points);
    if (title != shown_title_) glfwSetWindowTitle(window_, title.c_str());
    shown_title_ = title;
  }

  void take_screenshot(int width, int height) {
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
    if (panel_ && panel_->takes_pointer()) return;
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) state_.camera.turn(right, down);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) state_.camera.shift(right, down, height);
  }

  void scrolled(double notches) {
    if (!panel_->takes_pointer()) state_.camera.zoom *= std::pow(1.1F, static_cast<float>(notches));
  }

  void pressed(int key) {
    if (panel_->takes_keys()) return;
    constexpr std::array modes{Mode::splat, Mode::strip, Mode::mesh, Mode::wireframe, Mode::refined, Mode::patterns};
    DrawSettings& settings = state_.settings;
    if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + static_cast<int>(modes.size())) {
      settings.mode = modes[static_cast<std::size_t>(key - GLFW_KEY_1)];
      settings.maps = MapsShown::plain;
    }
    switch (key) {
      case GLFW_KEY_EQUAL:
      case GLFW_KEY_KP_ADD: settings.level = std::min(settings.level + 1, deepest_level); break;
      case GLFW_KEY_MINUS:
      case GLFW_KEY_KP_SUBTRACT: settings.level = std::max(settings.level - 1, 0); break;
      case GLFW_KEY_M: settings.maps = after(settings.maps); break;
      case GLFW_KEY_W: settings.lines = !settings.lines; break;
      case GLFW_KEY_C: settings.cull = !settings.cull; break;
      case GLFW_KEY_F: freeze(); break;
      case GLFW_KEY_U: state_.camera.z_is_up = !state_.camera.z_is_up; break;
      case GLFW_KEY_T: state_.turntable = !state_.turntable; break;
      case GLFW_KEY_R: state_.wants_first_view = true; break;
      case GLFW_KEY_S: state_.wants_screenshot = true; break;
      case GLFW_KEY_P: state_.panel = !state_.panel; break;
      case GLFW_KEY_H: state_.help = !state_.help; break;
      case GLFW_KEY_Q:
      case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(window_, GLFW_TRUE); break;
      default: break;
    }
  }

  // Plain comes after the most maps that there are.
  MapsShown after(MapsShown shown) const {
    return shown >= state_.most_maps ? MapsShown::plain : static_cast<MapsShown>(static_cast<int>(shown) + 1);
  }

  void freeze() {
    std::optional<Camera>& frozen = state_.settings.culled_from;
    frozen = frozen ? std::nullopt : std::optional(state_.camera);
  }

  static Statistics sum(const Statistics& a, const Statistics& b) {
    return {a.draws + b.draws,
            a.indices + b.indices,
            a.points + b.points,
            a.strips + b.strips,
            a.nodes_visited + b.nodes_visited,
            a.nodes_out_of_frustum + b.nodes_out_of_frustum,
            a.nodes_back_facing + b.nodes_back_facing,
            sum(a.patterns, b.patterns),
            a.refined_triangles + b.refined_triangles};
  }

  static PatternCounts sum(PatternCounts a, const PatternCounts& b) {
    for (const auto& [pattern, count] : b) a[pattern] += count;
    return a;
  }

  GLFWwindow* window_;
  std::string title_, shown_title_;
  ViewOptions options_;
  Scenes scenes_;
  ViewState state_;
  std::optional<ViewPanel> panel_;
  double x_ = 0, y_ = 0;
  int frames_after_event_ = 2;
  int screenshots_ = 0;
};

}  // namespace

MapsShown most_maps(const Scenes& scenes) {
  MapsShown most = MapsShown::plain;
  for (const std::unique_ptr<Scene>& scene : scenes) most = std::max(most, scene->most_maps());
  return most;
}

DrawSettings settings_for(const Scenes& scenes, const ViewOptions& options) {
  DrawSettings settings = options.settings;
  const MapsShown most = most_maps(scenes);
  settings.mode = options.mode.value_or(scenes.front()->default_mode());
  settings.maps = options.maps.value_or(options.mode ? MapsShown::plain : most);
  if (most == MapsShown::displaced && !options.has_depth) settings.edge_pixels = edge_pixels_of_maps;
  return settings;
}

Camera camera_for(const Scene& scene, const ViewOptions& options) {
  Camera camera = scene.default_camera();
  camera.z_is_up = options.z_is_up.value_or(camera.z_is_up);
  camera.yaw = options.yaw.value_or(camera.yaw);
  camera.pitch = options.pitch.value_or(camera.pitch);
  camera.zoom = options.zoom.value_or(camera.zoom);
  return camera;
}

Part part_of(std::size_t index, std::size_t count, int width, int height) {
  const int part = std::max(width / static_cast<int>(count), 1);
  return {part * static_cast<int>(index), part, height};
}

float greatest_shown(std::vector<float> distances) {
  if (distances.empty()) return 0;
  const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 98 / 100);
  std::nth_element(distances.begin(), at, distances.end());
  return *at;
}

void show_window(const std::string& title, std::vector<Model> models, const ViewOptions& options) {
  const GlWindow window(title, options.width, options.height, 4, "write a picture with --offscreen OUT.png");
  std::printf("%s", help_of_keys());
  Viewer(window.handle(), title, std::move(models), options).run();
}

}  // namespace glark::tool
