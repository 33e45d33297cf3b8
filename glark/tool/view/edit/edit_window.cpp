// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 4.5, the editor SIMOD.
#include "glark/tool/view/edit/edit_window.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "glark/tool/view/controls/gl_window.h"
#include "glark/tool/view/draw/gl.h"
#include "glark/tool/view/draw/scene.h"
#include "glark/tool/view/edit/edit_panel.h"

namespace glark::tool {
namespace {

// A place on the surface.
struct Hit {
  glm::vec3 place{};  // relative to the origin
  float depth = 0;    // in the window
};

class EditWindow {
 public:
  EditWindow(GLFWwindow* window, edit::Session& session, const EditOptions& options)
      : window_(window), session_(session), options_(options), scene_(geometry_of(session.editor())) {
    state_.symmetric = session.editor().symmetric();
    settings_.mode = scene_.default_mode();
    settings_.cull = false;  // the cones of the strips are those before the edit
    camera_ = scene_.default_camera();
    state_.greatest_radius = camera_.radius / 2;
    state_.brush.radius = camera_.radius / 15;
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) { self(of).moved(x, y); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int) {
      EditWindow& editor = self(of);
      if (button == GLFW_MOUSE_BUTTON_LEFT) editor.clicked(action == GLFW_PRESS);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* of, double, double y) { self(of).scrolled(y); });
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int modifiers) {
      if (action != GLFW_RELEASE) self(of).pressed(key, (modifiers & GLFW_MOD_CONTROL) != 0);
    });
    panel_.emplace(window);
  }

  void run() {
    while (glfwWindowShouldClose(window_) == 0) {
      glfwGetFramebufferSize(window_, &width_, &height_);
      if (width_ > 0 && height_ > 0) frame();
      wait();
    }
  }

 private:
  // Every callback begins here. Controls need two frames after an event: to notice it, and to show what it changed.
  static EditWindow& self(GLFWwindow* window) {
    auto& editor = *static_cast<EditWindow*>(glfwGetWindowUserPointer(window));
    editor.frames_to_draw_ = 3;
    return editor;
  }

  geometry::Geometry geometry_of(const edit::Editor& editor) {
    geometry::Geometry geometry;
    for (std::size_t axis = 0; axis < 3; ++axis) origin_[axis] = editor.positions()[axis];
    geometry.positions = positions_of(editor);
    geometry.normals.assign(editor.normals().begin(), editor.normals().end());
    geometry.colours = colours_of(editor);
    return geometry;
  }
  std::vector<float> positions_of(const edit::Editor& editor) const {
    std::vector<float> positions;
    positions.reserve(editor.positions().size());
    for (const double value : editor.positions())
      positions.push_back(static_cast<float>(value - origin_[positions.size() % 3]));
    return positions;
  }
  static std::vector<std::uint8_t> colours_of(const edit::Editor& editor) {
    std::vector<std::uint8_t> colours;
    colours.reserve(editor.colours().size() / 3 * 4);
    for (const std::uint8_t value : editor.colours()) {
      colours.push_back(static_cast<std::uint8_t>(value * 4 / 5));  // so that lit white has shades
      if (colours.size() % 4 == 3) colours.push_back(255);
    }
    return colours;
  }
  edit::Vector whole(const glm::vec3& place) const {
    return {origin_[0] + static_cast<double>(place.x), origin_[1] + static_cast<double>(place.y),
            origin_[2] + static_cast<double>(place.z)};
  }

  void wait() {
    if (frames_to_draw_ > 0) {
      --frames_to_draw_;
      glfwPollEvents();
    } else {
      glfwWaitEvents();
      frames_to_draw_ = 3;
    }
  }

  void frame() {
    do_what_is_wanted();
    bool is_new = draw_scene();
    if (std::exchange(wants_grab_, false)) grabbed_ = under_pointer_;
    if (std::exchange(wants_stroke_, false)) stroke();
    if (is_changed_) is_new = draw_scene();  // at once, so that the stroke is seen without another frame
    draw_ring();
    const edit::Editor& editor = session_.editor();
    panel_->draw(state_, {editor.size(), editor.undo_count(), editor.redo_count(), milliseconds_});
    glfwSwapBuffers(window_);
    if (is_new)
      milliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - applied_).count();
  }

  // Returns whether an operation is seen for the first time.
  bool draw_scene() {
    const bool is_new = std::exchange(is_changed_, false);
    if (is_new) {
      const edit::Editor& editor = session_.editor();
      scene_.replace_points(positions_of(editor), {editor.normals().begin(), editor.normals().end()},
                            colours_of(editor));
    }
    clear_window();
    scene_.draw(camera_, settings_, {0, width_, height_});
    under_pointer_ = hit_at(x_, y_);
    return is_new;
  }

  // The surface at a place of the window, by the depth that was drawn there.
  std::optional<Hit> hit_at(double x, double y) const {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const auto pixel_x = static_cast<int>(x * width_ / std::max(width, 1));
    const auto pixel_y = height_ - 1 - static_cast<int>(y * height_ / std::max(height, 1));
    if (pixel_x < 0 || pixel_y < 0 || pixel_x >= width_ || pixel_y >= height_) return std::nullopt;
    float depth = 1;
    gl.ReadPixels(pixel_x, pixel_y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    if (depth >= 1) return std::nullopt;
    return Hit{place_at(pixel_x, pixel_y, depth), depth};
  }
  glm::vec3 place_at(int pixel_x, int pixel_y, float depth) const {
    const glm::vec3 window(static_cast<float>(pixel_x) + 0.5F, static_cast<float>(pixel_y) + 0.5F, depth);
    return glm::unProject(window, camera_.view(), camera_.projection(width_, height_),
                          glm::vec4(0, 0, width_, height_));
  }

  void apply(const edit::Operation& operation) {
    frames_to_draw_ = 3;
    try {
      applied_ = std::chrono::steady_clock::now();
      session_.apply(operation);
      is_changed_ = true;
      state_.symmetric = session_.editor().symmetric();
      state_.said.clear();
    } catch (const std::exception& error) {
      say(error.what());
    }
  }
  void say(const std::string& text) {
    state_.said = text;
    std::fprintf(stderr, "glark: %s\n", text.c_str());
  }

  // Brushes that are not dragged act again when the pointer has moved by a third of their radius.
  void stroke() {
    if (!under_pointer_ || grabbing_.is_dragged()) return;
    if (last_stroke_ && glm::distance(*last_stroke_, under_pointer_->place) < state_.brush.radius / 3) return;
    last_stroke_ = under_pointer_->place;
    apply(operation_of(state_.brush, whole(under_pointer_->place), {}));
  }

  void clicked(bool is_pressed) {
    if (is_pressed && panel_->takes_pointer()) return;
    if (is_pressed) {
      is_stroking_ = wants_stroke_ = true;
      grabbing_ = state_.brush;
      last_stroke_.reset();
      wants_grab_ = true;
      return;
    }
    if (is_stroking_ && grabbed_ && grabbing_.is_dragged()) drop();
    is_stroking_ = wants_grab_ = false;
    grabbed_.reset();
  }

  // The grabbed part moves in the plane of the picture.
  void drop() {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const glm::vec3 to = place_at(static_cast<int>(x_ * width_ / std::max(width, 1)),
                                  height_ - 1 - static_cast<int>(y_ * height_ / std::max(height, 1)), grabbed_->depth);
    const glm::vec3 by = to - grabbed_->place;
    if (glm::length(by) > 0)
      apply(operation_of(grabbing_, whole(grabbed_->place),
                         {static_cast<double>(by.x), static_cast<double>(by.y), static_cast<double>(by.z)}));
  }

  void moved(double x, double y) {
    const auto right = static_cast<float>(x - x_);
    const auto down = static_cast<float>(y - y_);
    x_ = x;
    y_ = y;
    if (panel_ && panel_->takes_pointer() && !is_stroking_) return;
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) camera_.turn(right, down);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS) camera_.shift(right, down, height);
    wants_stroke_ = is_stroking_;
  }

  void scrolled(double notches) {
    if (panel_->takes_pointer()) return;
    camera_.zoom = std::clamp(camera_.zoom * std::pow(1.1F, static_cast<float>(notches)), 0.01F, 1000.0F);
  }

  void pressed(int key, bool with_control) {
    if (panel_->takes_keys()) return;
    Brush& brush = state_.brush;
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_6) brush.tool = static_cast<Tool>(key - GLFW_KEY_1);
    constexpr float step = 1.2F;
    switch (key) {
      case GLFW_KEY_LEFT_BRACKET: brush.radius = std::max(brush.radius / step, state_.greatest_radius / 500); break;
      case GLFW_KEY_RIGHT_BRACKET: brush.radius = std::min(brush.radius * step, state_.greatest_radius); break;
      case GLFW_KEY_MINUS: brush.strength = std::max(brush.strength / step, 0.01F); break;
      case GLFW_KEY_EQUAL: brush.strength = std::min(brush.strength * step, 1.0F); break;
      case GLFW_KEY_I: brush.inwards = !brush.inwards; break;
      case GLFW_KEY_X:
        state_.symmetric.on = !state_.symmetric.on;
        state_.symmetry_changed = true;
        break;
      case GLFW_KEY_Z: state_.wants_undo = true; break;
      case GLFW_KEY_Y: state_.wants_redo = true; break;
      case GLFW_KEY_S: state_.wants_save = with_control; break;
      case GLFW_KEY_R: state_.wants_first_view = true; break;
      case GLFW_KEY_P: state_.panel = !state_.panel; break;
      case GLFW_KEY_H: state_.help = !state_.help; break;
      case GLFW_KEY_Q: glfwSetWindowShouldClose(window_, GLFW_TRUE); break;
      default: break;
    }
  }

  void do_what_is_wanted() {
    if (std::exchange(state_.wants_undo, false)) apply(edit::Undo{});
    if (std::exchange(state_.wants_redo, false)) apply(edit::Redo{});
    if (std::exchange(state_.symmetry_changed, false)) apply(state_.symmetric);
    if (std::exchange(state_.wants_first_view, false)) camera_ = scene_.default_camera();
    if (std::exchange(state_.wants_line, false)) {
      try {
        apply(edit::parse(state_.line.data()));
      } catch (const std::exception& error) {
        say(error.what());
      }
    }
    if (std::exchange(state_.wants_save, false)) save();
  }

  void save() {
    std::error_code ignored;
    if (!options_.may_replace && !is_saved_ && std::filesystem::exists(options_.output, ignored))
      return say(options_.output.string() + " is there already; name the file to replace by -o");
    try {
      const edit::SaveReport report = session_.save(options_.output);
      is_saved_ = true;
      say(fmt::format("{} has the edit, {} points", options_.output.string(), report.points));
    } catch (const std::exception& error) {
      say(error.what());
    }
  }

  // The brush, as a ring that faces the viewer.
  void draw_ring() const {
    if (!under_pointer_ || panel_->takes_pointer()) return;
    const glm::mat4 view = camera_.view();
    const glm::vec3 right(glm::row(view, 0)), up(glm::row(view, 1));
    gl.Disable(GL_LIGHTING);
    gl.Disable(GL_DEPTH_TEST);
    gl.Color3f(1, 0.8F, 0.2F);
    gl.Begin(GL_LINE_LOOP);
    constexpr int corners = 64;
    for (int i = 0; i < corners; ++i) {
      const float angle = 2 * glm::pi<float>() * static_cast<float>(i) / corners;
      const glm::vec3 p =
          under_pointer_->place + state_.brush.radius * (std::cos(angle) * right + std::sin(angle) * up);
      gl.Vertex3f(p.x, p.y, p.z);
    }
    gl.End();
  }

  GLFWwindow* window_;
  edit::Session& session_;
  const EditOptions& options_;
  edit::Vector origin_{};  // the scene's positions are relative to it
  Scene scene_;
  Camera camera_;
  DrawSettings settings_;
  EditState state_;
  std::optional<EditPanel> panel_;
  std::optional<Hit> under_pointer_, grabbed_;
  std::optional<glm::vec3> last_stroke_;
  Brush grabbing_;         // the brush when the button was pressed
  bool is_saved_ = false;  // the output is ours
  bool is_stroking_ = false, wants_grab_ = false, wants_stroke_ = false, is_changed_ = false;
  double x_ = 0, y_ = 0;
  int width_ = 0, height_ = 0;
  int frames_to_draw_ = 3;
  std::chrono::steady_clock::time_point applied_;
  double milliseconds_ = 0;
};

}  // namespace

void show_edit_window(const EditOptions& options) {
  const GlWindow window("glark edit " + options.scan.string(), options.width, options.height, 1,
                        "edit by --script FILE, or by lines of standard input");
  edit::Session session(options.scan, options.session, options.sampling);
  std::printf("%s", help_of_edit_keys());
  EditWindow(window.handle(), session, options).run();
}

}  // namespace glark::tool
