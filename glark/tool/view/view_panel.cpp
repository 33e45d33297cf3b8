// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/view_panel.h"

#if GLARK_VIEW_PANEL

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

namespace glark::tool {
namespace {

constexpr std::array mode_names{"splats",    "strips",  "mesh",
                                "wireframe", "refined", "patterns"};  // in the order of Mode
constexpr std::array maps_names{"plain", "normal map", "displaced"};  // in the order of MapsShown
constexpr std::array refinement_names{"pn", "phong", "linear"};       // in the order of Refinement

// Returns whether maps are drawn, and not a mode.
bool show_maps(ViewState& state) {
  if (state.most_maps == MapsShown::plain) return false;
  int maps = static_cast<int>(state.settings.maps);
  if (ImGui::Combo("maps", &maps, maps_names.data(), static_cast<int>(state.most_maps) + 1))
    state.settings.maps = static_cast<MapsShown>(maps);
  return state.settings.maps != MapsShown::plain;
}

void show_depth(DrawSettings& settings) {
  ImGui::SliderInt("level", &settings.level, 0, deepest_level);
  ImGui::SliderInt("edge pixels", &settings.edge_pixels, 0, 64, settings.edge_pixels > 0 ? "%d" : "off");
  if (settings.edge_pixels > 0 && ImGui::InputInt("budget", &settings.budget, 10000))
    settings.budget = std::max(settings.budget, 0);
}

void show_refinement(DrawSettings& settings) {
  int refinement = static_cast<int>(settings.refinement);
  if (ImGui::Combo("refine", &refinement, refinement_names.data(), static_cast<int>(refinement_names.size())))
    settings.refinement = static_cast<Refinement>(refinement);
  show_depth(settings);
  ImGui::Checkbox("triangles as lines", &settings.lines);
}

void show_culling(ViewState& state) {
  ImGui::Checkbox("cull strips", &state.settings.cull);
  bool frozen = state.settings.culled_from.has_value();
  if (ImGui::Checkbox("freeze culling here", &frozen)) {
    state.settings.culled_from.reset();
    if (frozen) state.settings.culled_from = state.camera;
  }
}

void show_look(Look& look) {
  ImGui::SliderFloat("light right", &look.light_right, -180, 180, "%.0f degrees");
  ImGui::SliderFloat("light above", &look.light_above, -90, 90, "%.0f degrees");
  ImGui::SliderFloat("ambient", &look.ambient, 0, 1);
  ImGui::SliderFloat("specular", &look.specular, 0, 1);
  ImGui::SliderFloat("shininess", &look.shininess, 1, 128, "%.0f");
  if (ImGui::Button("first look")) look = {};
}

// A line for each pattern: its colour, the depths of its edges, how many coarse triangles have it.
void show_patterns(const Statistics& drawn) {
  for (const auto& [pattern, count] : drawn.patterns) {
    const auto [red, green, blue] = colour_of(pattern);
    const std::string name = name_of(pattern);
    ImGui::ColorButton(name.c_str(), ImVec4(red / 255.0F, green / 255.0F, blue / 255.0F, 1),
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, ImVec2(14, 14));
    ImGui::SameLine();
    ImGui::Text("depths %s: %zu", name.c_str(), count);
  }
}

void show_figures(const ViewState& state, const Statistics& drawn) {
  ImGui::Text("%zu indices, %zu points", drawn.indices, drawn.points);
  if (drawn.strips > 0) {
    ImGui::Text("%zu strips", drawn.strips);
    ImGui::Text("of %zu nodes %zu out of view, %zu turned away", drawn.nodes_visited, drawn.nodes_out_of_frustum,
                drawn.nodes_back_facing);
  }
  if (drawn.refined_triangles > 0)
    ImGui::Text("%zu coarse, %zu refined triangles", drawn.indices / 3, drawn.refined_triangles);
  show_patterns(drawn);
  if (state.greatest_distance > 0)
    ImGui::TextWrapped("Colours: blue at the reference, red %g or more away from it", state.greatest_distance);
}

void show_mode(ViewState& state) {
  int mode = static_cast<int>(state.settings.mode);
  if (ImGui::Combo("mode", &mode, mode_names.data(), static_cast<int>(mode_names.size())))
    state.settings.mode = static_cast<Mode>(mode);
  if (state.settings.mode == Mode::refined || state.settings.mode == Mode::patterns) show_refinement(state.settings);
  show_culling(state);
}

void show_controls(ViewState& state, const Statistics& drawn) {
  if (show_maps(state)) {
    if (state.settings.maps == MapsShown::displaced) show_depth(state.settings);
    ImGui::Checkbox("triangles as lines", &state.settings.lines);
  } else {
    show_mode(state);
  }
  if (ImGui::CollapsingHeader("Material and light")) show_look(state.settings.look);
  ImGui::Checkbox("turntable", &state.turntable);
  ImGui::SameLine();
  ImGui::Checkbox("z is up", &state.camera.z_is_up);
  state.wants_first_view = ImGui::Button("first view") || state.wants_first_view;
  ImGui::SameLine();
  state.wants_screenshot = ImGui::Button("screenshot") || state.wants_screenshot;
  ImGui::SameLine();
  if (ImGui::Button("keys")) state.help = !state.help;
  show_figures(state, drawn);
}

}  // namespace

void ViewPanel::draw(ViewState& state, const Statistics& drawn) {
  controls_.begin();
  if (state.panel) {
    ImGui::SetNextWindowPos(ImVec2(10, 10), ImGuiCond_FirstUseEver);
    // The panel is as high as its contents, but no higher than the window; then it has a scroll bar.
    ImGui::SetNextWindowSizeConstraints(ImVec2(310, 0), ImVec2(310, ImGui::GetIO().DisplaySize.y - 20));
    ImGui::SetNextWindowSize(ImVec2(310, 0));
    if (ImGui::Begin("glark view", &state.panel)) {
      ImGui::PushItemWidth(170);
      show_controls(state, drawn);
      ImGui::PopItemWidth();
    }
    ImGui::End();
  }
  show_text("Keys", help_of_keys(), state.help);
  controls_.end();
}

}  // namespace glark::tool

#else

namespace glark::tool {

void ViewPanel::draw(ViewState&, const Statistics&) {}

}  // namespace glark::tool

#endif

namespace glark::tool {

const char* help_of_keys() {
  return "left button turns, right button shifts, wheel zooms\n"
         "1 splats, 2 strips, 3 mesh, 4 wireframe, 5 refined, 6 patterns\n"
         "M plain, normal map, displaced (models with maps)\n"
         "+ and - the level of refinement, W its triangles as lines\n"
         "C culling, F freezes it, U turns the model upright\n"
         "T turntable, R first view, S screenshot\n"
         "P panel, H these keys, Q quits\n";
}

}  // namespace glark::tool
