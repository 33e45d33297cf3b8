// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/names/keys.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace glark::settings {
namespace {

constexpr std::array named_keys{
    Key{"F1", 0xFFBE, 59},      Key{"F2", 0xFFBF, 60},        Key{"F3", 0xFFC0, 61},         Key{"F4", 0xFFC1, 62},
    Key{"F5", 0xFFC2, 63},      Key{"F6", 0xFFC3, 64},        Key{"F7", 0xFFC4, 65},         Key{"F8", 0xFFC5, 66},
    Key{"F9", 0xFFC6, 67},      Key{"F10", 0xFFC7, 68},       Key{"F11", 0xFFC8, 87},        Key{"F12", 0xFFC9, 88},
    Key{"Pause", 0xFF13, 119},  Key{"Insert", 0xFF63, 110},   Key{"ScrollLock", 0xFF14, 70}, Key{"Home", 0xFF50, 102},
    Key{"PageUp", 0xFF55, 104}, Key{"PageDown", 0xFF56, 109}, Key{"End", 0xFF57, 107},       Key{"Menu", 0xFF67, 127},
};

bool equal(std::string_view a, std::string_view b) {
  const auto lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::span<const Key> known_keys() { return named_keys; }

const Key* find_key(std::string_view name) {
  const auto* const found =
      std::find_if(named_keys.begin(), named_keys.end(), [&](const Key& key) { return equal(key.name, name); });
  return found != named_keys.end() ? found : nullptr;
}

}  // namespace glark::settings
