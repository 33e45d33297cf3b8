// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/panel_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "shim/panel/view/draw_list_view.h"

namespace glark::shim {
namespace {

using Options = core::ContextOptions;

// The word of --refine. `smooth` is pn, mesh by mesh.
std::string_view word_of(const Options& options) {
  return options.smooth ? "smooth" : core::traits_of(options.refinement).word;
}

bool choose_refinement(Options& options) {
  bool changed = false;
  if (!ImGui::BeginCombo("refine", std::string(word_of(options)).c_str())) return false;
  if (ImGui::Selectable("smooth", options.smooth)) {
    options.smooth = changed = true;
    options.refinement = core::Refinement::pn;
  }
  for (const core::RefinementTraits& row : core::refinements)
    if (ImGui::Selectable(std::string(row.word).c_str(), !options.smooth && row.refinement == options.refinement)) {
      options.smooth = false;
      options.refinement = row.refinement;
      changed = true;
    }
  ImGui::EndCombo();
  return changed;
}

bool choose_level(const char* label, unsigned& level) {
  int value = static_cast<int>(level);
  if (!ImGui::SliderInt(label, &value, 0, core::max_supported_level)) return false;
  level = static_cast<unsigned>(std::clamp(value, 0, static_cast<int>(core::max_supported_level)));
  return true;
}

// A measure is off at 0; below `least`, it is off, too.
bool choose_measure(const char* label, float& value, float least, float most) {
  if (!ImGui::SliderFloat(label, &value, 0, most, value > 0 ? "%.2f" : "off", ImGuiSliderFlags_Logarithmic))
    return false;
  value = value < least ? 0 : std::min(value, most);
  return true;
}

// Says what else the budget needs, where --budget would say it.
bool choose_budget(core::EdgeMeasure& measure) {
  int thousands = static_cast<int>(measure.budget / 1000);
  const bool changed = ImGui::InputInt("budget (1000 triangles)", &thousands, 50, 500);
  if (changed) measure.budget = static_cast<unsigned>(std::clamp(thousands, 0, 1000000)) * 1000;
  if (measure.budget > 0 && !measure.on())
    ImGui::TextWrapped("The budget has no effect without edge pixels, screen error or curvature.");
  return changed;
}

bool choose_shape(Options& options) {
  bool changed = choose_refinement(options);
  if (ImGui::SliderFloat("crease", &options.crease, 0, 180, "%.0f degrees")) {
    options.crease = std::clamp(options.crease, 0.0F, 180.0F);
    changed = true;
  }
  return changed;
}

bool choose_depths(Options& options) {
  bool changed = false;
  if (choose_level("level", options.level)) {
    options.max_level = std::max(options.max_level, options.level);
    changed = true;
  }
  core::EdgeMeasure& measure = options.measure;
  changed = choose_measure("edge pixels", measure.pixels, 0.5F, 100) || changed;
  changed = choose_measure("screen error", measure.error, 0.01F, 10) || changed;
  changed = choose_measure("curvature", measure.degrees, 0.5F, 180) || changed;
  if (measure.on()) {
    changed = choose_level("max level", options.max_level) || changed;
    changed = ImGui::Checkbox("geomorph", &options.geomorph) || changed;
  }
  changed = choose_budget(measure) || changed;
  options.level = std::min(options.level, options.max_level);
  return changed;
}

bool choose_look(Options& options) {
  bool changed = ImGui::Checkbox("wireframe", &options.wireframe);
  ImGui::SameLine();
  changed = ImGui::Checkbox("split", &options.live.split) || changed;
  ImGui::SameLine();
  return ImGui::Checkbox("false colours", &options.live.false_colors) || changed;
}

bool show_settings(Options& options) {
  bool refines = !options.live.paused;
  bool changed = ImGui::Checkbox("refine the program's draws", &refines);
  options.live.paused = !refines;
  changed = choose_shape(options) || changed;
  changed = choose_depths(options) || changed;
  return choose_look(options) || changed;
}

void show_figures(const PanelModel& model) {
  const FrameFigures& frame = model.figures;
  ImGui::Text("%.1f ms, %.0f frames a second", frame.ms, frame.ms > 0 ? 1000 / frame.ms : 0);
  ImGui::Text("%llu of %llu draws refined", static_cast<unsigned long long>(frame.refined),
              static_cast<unsigned long long>(frame.seen));
  ImGui::Text("%llu triangles became %llu", static_cast<unsigned long long>(frame.coarse_triangles),
              static_cast<unsigned long long>(frame.refined_triangles));
  ImGui::Text("%.1f MB kept on the GPU", static_cast<double>(model.kept_bytes) / (1 << 20));
  for (unsigned i = 0; i < core::cause_count; ++i)
    if (frame.left[i] > 0)
      ImGui::BulletText("%llu %s", static_cast<unsigned long long>(frame.left[i]),
                        std::string(core::text_of(static_cast<core::Cause>(i)).key).c_str());
}

void show_writing(const PanelModel& model, PanelAnswer& answer) {
  answer.wants_write = ImGui::Button("Write to the configuration");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", model.file.c_str());
  if (!model.message.empty()) ImGui::TextWrapped("%s", model.message.c_str());
}

}  // namespace

PanelAnswer show_panel(PanelModel& model) {
  PanelAnswer answer;
  bool open = true;
  ImGui::SetNextWindowPos(ImVec2(10, 10), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(390, 0), ImGuiCond_FirstUseEver);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImVec2 least(std::min(200.0F, window.x), 40);
  ImGui::SetNextWindowSizeConstraints(least, ImVec2(window.x, std::max(window.y - 10, least.y)));
  if (ImGui::Begin((model.title + "###glark").c_str(), &open)) {
    ImGui::PushItemWidth(190);
    answer.options_changed = show_settings(model.options);
    if (ImGui::CollapsingHeader("This frame", ImGuiTreeNodeFlags_DefaultOpen)) show_figures(model);
    if (ImGui::CollapsingHeader("Draws", ImGuiTreeNodeFlags_DefaultOpen)) {
      const DrawListAnswer list = show_draws(model);
      answer.options_changed = list.options_changed || answer.options_changed;
      answer.wants_pick = list.wants_pick;
    }
    show_writing(model, answer);
    ImGui::PopItemWidth();
  }
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  answer.area = {static_cast<int>(at.x), static_cast<int>(at.y), std::max(static_cast<int>(size.x), 1),
                 std::max(static_cast<int>(size.y), 1)};
  answer.wants_close = !open;
  ImGui::End();
  const ImGuiIO& io = ImGui::GetIO();
  if (model.picking && ImGui::IsMouseClicked(0) && !io.WantCaptureMouse)
    answer.picked = {static_cast<int>(io.MousePos.x), static_cast<int>(window.y - 1 - io.MousePos.y)};
  return answer;
}

}  // namespace glark::shim
