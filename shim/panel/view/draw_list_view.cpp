// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/draw_list_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "glark/core/state/programs/program.h"
#include "shim/panel/view/draw_switch.h"

namespace glark::shim {
namespace {

std::string decision_of(const core::WatchedClass& draws) {
  const core::DrawVerdict& verdict = draws.key.verdict;
  if (verdict.cause) return std::string(core::text_of(*verdict.cause).key);
  const std::string_view word = core::traits_of(verdict.refinement).word;
  return verdict.measured ? std::string(word) : fmt::format("{} {}", word, verdict.level);
}

std::string state_of(const core::DrawState& state) {
  std::string text = state.fixed_function ? "fixed function" : "program";
  text += fmt::format(" {}", state.program == 0 ? std::string("unknown") : core::hash_text(state.program));
  if (state.blend) text += ", blended";
  if (!state.depth_test) text += ", no depth test";
  if (state.depth_test && !state.depth_writes) text += ", no depth writes";
  if (state.depth_only) text += ", depth only";
  return text + fmt::format(", {} x {} pixels", state.viewport[0], state.viewport[1]);
}

void show_color(core::DrawGroup group) {
  const core::DrawGroupText& text = core::text_of(group);
  ImGui::ColorButton("##colour", ImVec4(text.color[0], text.color[1], text.color[2], 1), ImGuiColorEditFlags_NoTooltip,
                     ImVec2(12, 12));
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(text.name).c_str());
}

// The switch of a class, and its row. Chooses the class whose row is clicked.
bool show_class(const core::WatchedClass& draws, core::ContextOptions& options) {
  bool changed = false;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  bool refines = !is_switched_off(options, draws.key.state);
  if (ImGui::Checkbox("##on", &refines)) {
    switch_draws(options, draws.key.state, refines);
    changed = true;
  }
  ImGui::SameLine();
  show_color(draws.group());
  ImGui::TableNextColumn();
  const bool marked = options.live.marked == draws.key.state;
  if (ImGui::Selectable(decision_of(draws).c_str(), marked)) {
    options.live.marked.reset();
    if (!marked) options.live.marked = draws.key.state;
    changed = true;
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", state_of(draws.key.state).c_str());
  ImGui::TableNextColumn();
  ImGui::Text("%llu", static_cast<unsigned long long>(draws.draws));
  ImGui::TableNextColumn();
  ImGui::Text("%llu", static_cast<unsigned long long>(draws.triangles));
  return changed;
}

}  // namespace

DrawListAnswer show_draws(PanelModel& model) {
  DrawListAnswer answer;
  answer.wants_pick = ImGui::Button(model.picking ? "Click on the window" : "Pick on the screen");
  ImGui::SameLine();
  if (ImGui::Button("Unmark") && model.options.live.marked) {
    model.options.live.marked.reset();
    answer.options_changed = true;
  }
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  const float height = ImGui::GetTextLineHeightWithSpacing() * 9;
  if (!ImGui::BeginTable("draws", 4, flags, ImVec2(0, height))) return answer;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("refine");
  ImGui::TableSetupColumn("decision", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("draws");
  ImGui::TableSetupColumn("triangles");
  ImGui::TableHeadersRow();
  int row = 0;
  for (const core::WatchedClass& draws : model.classes) {
    ImGui::PushID(row++);
    answer.options_changed = show_class(draws, model.options) || answer.options_changed;
    ImGui::PopID();
  }
  ImGui::EndTable();
  return answer;
}

}  // namespace glark::shim
