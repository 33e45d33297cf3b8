// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "glark/core/report/log.h"
#include "glark/core/stages.h"
#include "glark/settings/edit/configuration_edit.h"
#include "shim/contexts/thread.h"
#include "shim/live/live_settings.h"
#include "shim/panel/view/assertions.h"
#include "shim/panel/view/draw_switch.h"
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

// During its lifetime, our context is current, if the window system allows it.
class InOurContext {
 public:
  InOurContext(PanelContext* context, const Surface& surface)
      : context_(context != nullptr && context->enter(surface) ? context : nullptr) {}
  ~InOurContext() {
    if (context_ != nullptr) context_->leave();
  }
  InOurContext(const InOurContext&) = delete;
  InOurContext& operator=(const InOurContext&) = delete;
  explicit operator bool() const { return context_ != nullptr; }

 private:
  PanelContext* context_;
};

void complain(std::string_view reason) {
  core::log(core::LogLevel::warning, fmt::format("the panel cannot be shown in this window: {}", reason));
}

}  // namespace

// Dear ImGui's texture, colours and keys, once.
void Panel::start_imgui() {
  imgui_ = ImGui::CreateContext();
  const ImGuiScope scope(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // no file in the program's folder
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  PanelInput::start();
  ImGui::StyleColorsDark();
  // Without corners, border and transparency, the panel needs no blending.
  ImGui::GetStyle().WindowRounding = 0;
  ImGui::GetStyle().WindowBorderSize = 0;
  for (const ImGuiCol opaque : {ImGuiCol_WindowBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed})
    ImGui::GetStyle().Colors[opaque].w = 1;
  model_.title = fmt::format("glark: {}", program_names().empty() ? "program" : program_names().back());
  model_.file = settings::writable_configuration(first_environment());
}

// What draws for the program's current context; null: nothing can.
Panel::Drawer* Panel::drawer_for(const Surface& surface) {
  const auto found = drawers_.find(current_number());
  if (found != drawers_.end()) return found->second.renderer != nullptr ? &found->second : nullptr;
  if (drawers_.size() >= most_drawers) return nullptr;
  Drawer& drawer = drawers_[current_number()];
  drawer.context = make_panel_context(current_provider(), current_native(), surface);
  const InOurContext current(drawer.context.get(), surface);
  if (!current) {
    complain("the window system gives no second context for it");
    return nullptr;
  }
  auto renderer = std::make_unique<PanelRenderer>(dispatch_of(current_provider()));
  if (!renderer->start()) {
    complain("OpenGL refuses its shaders");
    return nullptr;
  }
  drawer.renderer = std::move(renderer);
  return &drawer;
}

bool Panel::draw(core::Context& context, const Surface& surface) {
  PanelAnswer answer;
  bool drawn = false;
  size_ = current_size();
  if (size_.width <= 0 || size_.height <= 0) return true;
  if (!before_) before_ = live_options();
  const bool due = is_due();
  if (due) fill_model(context);
  if (due) take_pick();
  if (!survives_assertions([&] { drawn = draw_imgui(surface, due, answer); }))
    throw std::runtime_error("an assertion of Dear ImGui failed: " + failed_assertion());
  if (!drawn) return false;
  if (due) follow(answer);
  return !wants_close_;
}

// Input and changed settings show at once. Figures that change in each frame could not be read.
bool Panel::is_due() {
  const auto now = Pace::Clock::now();
  const bool changed = input_.waits() || pace_.held || frames_to_pick_ > 0 || pace_.generation != live_generation() ||
                       pace_.size != size_;
  if (changed) pace_.frames_left = settled_frames;
  if (pace_.frames_left <= 0 && now - pace_.last < figures_interval) return false;
  --pace_.frames_left;
  pace_.generation = live_generation();
  pace_.size = size_;
  return true;
}

void Panel::build(PanelAnswer& answer) {
  const auto now = Pace::Clock::now();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(size_.width), static_cast<float>(size_.height));
  io.DeltaTime = std::clamp(std::chrono::duration<float>(now - pace_.last).count(), 0.001F, 1.0F);
  pace_.last = now;
  input_.feed();
  ImGui::NewFrame();
  answer = show_panel(model_);
  ImGui::Render();
  pace_.held = ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive();
}

bool Panel::draw_imgui(const Surface& surface, bool due, PanelAnswer& answer) {
  if (imgui_ == nullptr) start_imgui();
  const ImGuiScope scope(imgui_);
  const Drawer* const drawer = drawer_for(surface);
  if (drawer == nullptr) return false;
  const InOurContext current(drawer->context.get(), surface);
  if (!current) return false;
  if (due) build(answer);
  drawer->renderer->draw(*ImGui::GetDrawData(), ImGui::GetFrameCount(), size_, due ? answer.area : area_);
  return true;
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

void Panel::follow(const PanelAnswer& answer) {
  area_ = answer.area;
  wants_close_ = answer.wants_close;
  core::LiveView& view = model_.options.live;
  const core::LiveView before = view;
  view.counts_classes = true;
  view.window = {static_cast<unsigned>(size_.width), static_cast<unsigned>(size_.height)};
  if (answer.picked) {
    view.pixel = answer.picked;
    frames_to_pick_ = 1;
  }
  model_.picking = (model_.picking && !answer.picked) != answer.wants_pick;
  if (answer.options_changed || view != before) change(model_.options);
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
  pace_ = {};
  change_live([](core::ContextOptions& options) {
    options.live.counts_classes = false;
    options.live.marked.reset();
    options.live.pixel.reset();
  });
}

}  // namespace glark::shim
