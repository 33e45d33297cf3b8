// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/edit/edit_panel.h"

#if GLARK_VIEW_PANEL

#include <imgui.h>

#include <glm/gtc/type_ptr.hpp>

namespace glark::tool {
namespace {

constexpr std::array tool_names{"paint", "inflate", "smooth", "move", "deform", "refine"};  // in the order of Tool
constexpr std::array axis_names{"off", "x", "y", "z"};

void show_brush(EditState& state) {
  Brush& brush = state.brush;
  int tool = static_cast<int>(brush.tool);
  if (ImGui::Combo("brush", &tool, tool_names.data(), static_cast<int>(tool_names.size())))
    brush.tool = static_cast<Tool>(tool);
  ImGui::SliderFloat("radius", &brush.radius, state.greatest_radius / 500, state.greatest_radius, "%.4g",
                     ImGuiSliderFlags_Logarithmic);
  if (brush.tool == Tool::paint || brush.tool == Tool::inflate || brush.tool == Tool::smooth)
    ImGui::SliderFloat("strength", &brush.strength, 0.01F, 1);
  if (brush.tool == Tool::paint) ImGui::ColorEdit3("colour", glm::value_ptr(brush.colour));
  if (brush.tool == Tool::inflate) ImGui::Checkbox("inwards", &brush.inwards);
  int mirror = state.symmetric.on ? static_cast<int>(state.symmetric.axis) + 1 : 0;
  if (ImGui::Combo("mirror", &mirror, axis_names.data(), static_cast<int>(axis_names.size()))) {
    state.symmetric.on = mirror > 0;
    if (mirror > 0) state.symmetric.axis = static_cast<unsigned>(mirror - 1);
    state.symmetry_changed = true;
  }
}

void show_steps(EditState& state, const EditFigures& figures) {
  state.wants_undo = ImGui::Button("undo") || state.wants_undo;
  ImGui::SameLine();
  state.wants_redo = ImGui::Button("redo") || state.wants_redo;
  ImGui::SameLine();
  state.wants_save = ImGui::Button("save") || state.wants_save;
  ImGui::SameLine();
  state.wants_first_view = ImGui::Button("first view") || state.wants_first_view;
  ImGui::SameLine();
  if (ImGui::Button("keys")) state.help = !state.help;
  state.wants_line =
      ImGui::InputText("operation", state.line.data(), state.line.size(), ImGuiInputTextFlags_EnterReturnsTrue) ||
      state.wants_line;
  ImGui::Text("%zu samples, %zu steps to undo, %zu to redo", figures.samples, figures.undo, figures.redo);
  if (figures.milliseconds > 0) ImGui::Text("last operation: %.0f ms until it was drawn", figures.milliseconds);
  if (!state.said.empty()) ImGui::TextWrapped("%s", state.said.c_str());
}

}  // namespace

void EditPanel::draw(EditState& state, const EditFigures& figures) {
  controls_.begin();
  if (state.panel) {
    ImGui::SetNextWindowPos(ImVec2(10, 10), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(330, 0), ImVec2(330, 10000));
    if (ImGui::Begin("glark edit", &state.panel, ImGuiWindowFlags_AlwaysAutoResize)) {
      ImGui::PushItemWidth(200);
      show_brush(state);
      show_steps(state, figures);
      ImGui::PopItemWidth();
    }
    ImGui::End();
  }
  show_text("Keys", help_of_edit_keys(), state.help);
  controls_.end();
}

}  // namespace glark::tool

#else

namespace glark::tool {

void EditPanel::draw(EditState&, const EditFigures&) {}

}  // namespace glark::tool

#endif

namespace glark::tool {

const char* help_of_edit_keys() {
  return "left button: the brush; right button turns, middle button shifts, wheel zooms\n"
         "1 paint, 2 inflate, 3 smooth, 4 move, 5 deform, 6 refine\n"
         "[ and ] radius, - and + strength, I inwards or outwards, X mirror\n"
         "Z or Ctrl+Z undo, Y or Ctrl+Y redo, Ctrl+S save\n"
         "R first view, P panel, H these keys, Q quits; the session stays\n";
}

}  // namespace glark::tool
