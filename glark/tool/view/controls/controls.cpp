// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/controls/controls.h"

#if GLARK_VIEW_PANEL

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

namespace glark::tool {

Controls::Controls(GLFWwindow* window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // no file in the user's folder
  ImGui::StyleColorsDark();
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 130");
}

Controls::~Controls() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

bool Controls::takes_pointer() const { return ImGui::GetIO().WantCaptureMouse; }
bool Controls::takes_keys() const { return ImGui::GetIO().WantCaptureKeyboard; }

void Controls::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Controls::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void show_text(const char* title, const char* text, bool& is_open) {
  if (!is_open) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_FirstUseEver, ImVec2(0.5F, 0.5F));
  if (ImGui::Begin(title, &is_open, ImGuiWindowFlags_AlwaysAutoResize)) ImGui::TextUnformatted(text);
  ImGui::End();
}

}  // namespace glark::tool

#else

namespace glark::tool {

Controls::Controls(GLFWwindow*) {}
Controls::~Controls() = default;
bool Controls::takes_pointer() const { return false; }
bool Controls::takes_keys() const { return false; }
void Controls::begin() {}
void Controls::end() {}
void show_text(const char*, const char*, bool&) {}

}  // namespace glark::tool

#endif
