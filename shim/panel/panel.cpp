// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/panel.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <span>
#include <utility>

#include "glark/core/report/log.h"
#include "glark/core/stages.h"
#include "glark/settings/configuration_edit.h"
#include "shim/contexts/thread.h"
#include "shim/live/live_settings.h"
#include "shim/panel/draw_switch.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

// Our ImGui has a context of its own, so it is switched on only while it is used.
class ImGuiScope {
 public:
  explicit ImGuiScope(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
    ImGui::SetCurrentContext(context);
  }
  ~ImGuiScope() { ImGui::SetCurrentContext(before_); }
  ImGuiScope(const ImGuiScope&) = delete;
  ImGuiScope& operator=(const ImGuiScope&) = delete;

 private:
  ImGuiContext* before_;
};

void complain(std::string_view reason) {
  core::log(core::LogLevel::warning, fmt::format("the panel cannot be shown in this window: {}", reason));
}

}  // namespace

Panel::~Panel() {
  if (imgui_ != nullptr) ImGui::DestroyContext(imgui_);
}

void Panel::start_imgui() {
  ImGuiContext* const before = ImGui::GetCurrentContext();
  imgui_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // no file in the program's folder
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGui::StyleColorsDark();
  ImGui::GetStyle().WindowRounding = 4;
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.92F;
  ImGui::SetCurrentContext(before);
  model_.title = fmt::format("glark: {}", program_names().empty() ? "program" : program_names().back());
  model_.file = settings::writable_configuration(environ);
}

// Makes our context current, anew if the program has another context in this window.
bool Panel::prepare(const Surface& surface) {
  if (imgui_ == nullptr) start_imgui();
  const bool fresh = program_context_ != current_number();
  if (fresh) {
    renderer_ = nullptr;
    context_ = make_panel_context(current_provider(), current_native(), surface);
    program_context_ = current_number();
  }
  if (context_ == nullptr || !context_->enter(surface)) {
    if (fresh) complain("the window system gives no second context for it");
    return false;
  }
  if (!fresh) return true;
  const ImGuiScope scope(imgui_);
  auto renderer = std::make_unique<PanelRenderer>(dispatch_of(current_provider()));
  if (renderer->start()) {
    renderer_ = std::move(renderer);
    return true;
  }
  complain("OpenGL refuses its shaders");
  context_->leave();
  context_ = nullptr;
  return false;
}

bool Panel::draw(core::Context& context, const Surface& surface) {
  size_ = current_size();
  if (size_.width <= 0 || size_.height <= 0) return true;
  if (!before_) before_ = live_options();
  fill_model(context);
  take_pick();
  if (!prepare(surface)) return false;
  const ImGuiScope scope(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(size_.width), static_cast<float>(size_.height));
  io.DeltaTime = std::clamp(static_cast<float>(model_.figures.ms) / 1000, 0.001F, 1.0F);
  input_.feed();
  ImGui::NewFrame();
  const PanelAnswer answer = show_panel(model_);
  ImGui::Render();
  renderer_->draw(*ImGui::GetDrawData(), size_);
  context_->leave();
  follow(answer, size_);
  return !wants_close_;
}

void Panel::fill_model(const core::Context& context) {
  model_.options = live_options();
  model_.figures = last_frame();
  model_.classes.clear();
  model_.kept_bytes = 0;
  if (context.stages() == nullptr) return;
  model_.classes = context.stages()->draw().watch().last_frame();
  model_.kept_bytes = context.stages()->kept_bytes();
}

// After another frame, the draws know whether they changed the pixel.
void Panel::take_pick() {
  if (frames_to_pick_ == 0 || --frames_to_pick_ > 0) return;
  const std::optional<core::DrawState> seen = seen_at_pixel(model_.classes);
  model_.options.live.pixel.reset();
  model_.options.live.marked = seen;
  model_.message = seen ? "" : "No draw of glark's changed this pixel.";
  change(model_.options);
}

void Panel::change(const core::ContextOptions& wanted) {
  change_live([&](core::ContextOptions& options) { options = wanted; });
}

void Panel::follow(const PanelAnswer& answer, Size size) {
  area_ = answer.area;
  wants_close_ = answer.wants_close;
  core::LiveView& view = model_.options.live;
  bool changed = answer.options_changed || !view.counts_classes;
  view.counts_classes = true;
  const std::array window{static_cast<unsigned>(size.width), static_cast<unsigned>(size.height)};
  changed = changed || view.window != window;
  view.window = window;
  const bool clicked = model_.picking && ImGui::IsMouseClicked(0) && !ImGui::GetIO().WantCaptureMouse;
  if (clicked) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    view.pixel = {static_cast<int>(at.x), size.height - 1 - static_cast<int>(at.y)};
    frames_to_pick_ = 1;
    changed = true;
  }
  model_.picking = (model_.picking && !clicked) != answer.wants_pick;
  if (changed) change(model_.options);
  if (answer.wants_write) write();
}

void Panel::write() {
  const std::vector<settings::ChangedSetting> changed = settings::changed_settings(*before_, model_.options);
  const std::vector<core::DrawRule> rules = settings::added_rules(*before_, model_.options);
  if (changed.empty() && rules.empty()) {
    model_.message = "Nothing has changed.";
    return;
  }
  const std::string program = program_names().empty() ? "" : program_names().back();
  const std::string problem = settings::write_configuration(model_.file, program, changed, rules);
  model_.message = problem.empty() ? fmt::format("Written to {}.", model_.file) : problem;
  if (problem.empty()) before_ = model_.options;
}

InputShare Panel::share(bool keyboard) const {
  if (model_.picking) return {Area{0, 0, size_.width, size_.height}, keyboard};
  return {area_, keyboard};
}

void Panel::closed() {
  wants_close_ = false;
  model_.picking = false;
  frames_to_pick_ = 0;
  input_.clear();
  change_live([](core::ContextOptions& options) {
    options.live.counts_classes = false;
    options.live.marked.reset();
    options.live.pixel.reset();
  });
}

}  // namespace glark::shim
