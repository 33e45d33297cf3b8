// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/panel_input.h"

#include <imgui.h>

#include <array>
#include <cfloat>

namespace glark::shim {
namespace {

// In the order of PanelKey.
constexpr std::array keys{ImGuiKey_Tab,       ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow,
                          ImGuiKey_DownArrow, ImGuiKey_PageUp,    ImGuiKey_PageDown,   ImGuiKey_Home,
                          ImGuiKey_End,       ImGuiKey_Delete,    ImGuiKey_Backspace,  ImGuiKey_Space,
                          ImGuiKey_Enter,     ImGuiKey_Escape};
static_assert(keys.size() == static_cast<std::size_t>(PanelKey::escape) + 1);

#if IMGUI_VERSION_NUM >= 18700

void map_keys() {}
void move_pointer(float x, float y) { ImGui::GetIO().AddMousePosEvent(x, y); }
void move_button(unsigned button, bool down) { ImGui::GetIO().AddMouseButtonEvent(static_cast<int>(button), down); }
void move_wheel(float notches) { ImGui::GetIO().AddMouseWheelEvent(0, notches); }
void move_key(unsigned key, bool down) { ImGui::GetIO().AddKeyEvent(keys[key], down); }

#else

// The position in KeysDown is chosen by us. Without the Space key, navigation by keys is an assertion.
void map_keys() {
  for (std::size_t key = 0; key < keys.size(); ++key) ImGui::GetIO().KeyMap[keys[key]] = static_cast<int>(key);
}
void move_pointer(float x, float y) { ImGui::GetIO().MousePos = ImVec2(x, y); }
void move_button(unsigned button, bool down) { ImGui::GetIO().MouseDown[button] = down; }
void move_wheel(float notches) { ImGui::GetIO().MouseWheel += notches; }
void move_key(unsigned key, bool down) { ImGui::GetIO().KeysDown[key] = down; }

#endif

void give(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::move: move_pointer(event.x, event.y); break;
    case InputEvent::Kind::leave: move_pointer(-FLT_MAX, -FLT_MAX); break;
    case InputEvent::Kind::button:
      move_pointer(event.x, event.y);
      move_button(event.number, event.down);
      break;
    case InputEvent::Kind::wheel: move_wheel(event.y); break;
    case InputEvent::Kind::key: move_key(event.number, event.down); break;
    case InputEvent::Kind::character: ImGui::GetIO().AddInputCharacter(event.number); break;
    case InputEvent::Kind::panel:
    case InputEvent::Kind::toggle: break;
  }
}

bool is_press(const InputEvent& event) {
  return event.kind == InputEvent::Kind::button || event.kind == InputEvent::Kind::key;
}

}  // namespace

void PanelInput::start() {
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  map_keys();
}

void PanelInput::feed() {
  bool pressed = false;
  while (!waiting_.empty()) {
    const InputEvent event = waiting_.front();
    // Moves after a press wait, too, so that the press happens where it was.
    if (pressed && (is_press(event) || event.kind == InputEvent::Kind::move)) return;
    waiting_.pop_front();
    pressed = pressed || is_press(event);
    give(event);
  }
}

}  // namespace glark::shim
