// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/scene/mtl_pictures.h"

#include <fast_float/fast_float.h>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace glark::geometry {
namespace {

using Pictures = std::map<std::string, TextureUse, std::less<>>;  // by the name of the material

constexpr std::string_view blanks = " \t\r";

void trim(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
}

// Returns the first word and removes it, and the blanks after it.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  trim(text);
  return word;
}

template <class Receive>
void each_line(std::string_view text, const Receive& receive) {
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    trim(line);
    receive(line);
  }
}

// Removes a number. It must not be the last word, which is the name of the picture.
std::optional<double> take_number(std::string_view& text) {
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  double value = 0;
  const auto [after, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (rest.empty() || error != std::errc() || after != word.data() + word.size()) return {};
  text = rest;
  return value;
}

// Removes one to three numbers. Those that are missing are not changed.
void take_numbers(std::string_view& text, std::array<double, 3>& numbers) {
  for (double& number : numbers) {
    const std::optional<double> value = take_number(text);
    if (!value) return;
    number = *value;
  }
}

// The words that follow an option that only has words.
std::optional<std::size_t> words_of_option(std::string_view option) {
  constexpr std::pair<std::string_view, std::size_t> known[] = {{"-blendu", 1}, {"-blendv", 1}, {"-bm", 1},
                                                                {"-boost", 1},  {"-cc", 1},     {"-imfchan", 1},
                                                                {"-mm", 2},     {"-texres", 1}, {"-type", 1}};
  for (const auto& [name, words] : known)
    if (name == option) return words;
  return {};
}

TextureUse picture_of(std::string_view text) {
  TextureUse use{.has_colour = false};
  std::array<double, 3> offset{0, 0, 0}, scale{1, 1, 1}, turbulence{};
  while (text.starts_with('-')) {
    std::string_view rest = text;
    const std::string_view option = take_word(rest);
    if (option == "-o") {
      take_numbers(rest, offset);
    } else if (option == "-s") {
      take_numbers(rest, scale);
    } else if (option == "-t") {
      take_numbers(rest, turbulence);
    } else if (option == "-clamp") {
      if (take_word(rest) == "on") use.wrap_s = use.wrap_t = Wrap::clamp;
    } else if (const std::optional<std::size_t> words = words_of_option(option)) {
      for (std::size_t i = 0; i < *words; ++i) take_word(rest);
    } else {
      break;  // a name that begins with a minus
    }
    text = rest;
  }
  if (text.size() > 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  use.file = text;
  use.transform = {{{scale[0], 0, offset[0]}, {0, scale[1], offset[1]}}};
  return use;
}

// Programs for Windows write names with backslashes.
std::string with_slashes(std::string_view name) {
  std::string file(name);
  std::replace(file.begin(), file.end(), '\\', '/');
  return file;
}

void read_materials(const std::filesystem::path& file, Pictures& pictures) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return;
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::string material;
  std::set<std::string> with_colour;
  each_line(text, [&](std::string_view line) {
    const std::string_view word = take_word(line);
    if (word == "newmtl") material = line;
    if (word == "Kd") with_colour.insert(material);
    if (word == "map_Kd" && !line.empty()) pictures[material] = picture_of(line);
  });
  // Assimp gives a grey to a material without a colour.
  for (auto& [name, use] : pictures) use.has_colour |= with_colour.contains(name);
}

}  // namespace

TextureUses mtl_texture_uses(std::string_view obj, const std::filesystem::path& folder, const aiScene& scene) {
  Pictures pictures;
  each_line(obj, [&](std::string_view line) {
    if (line.starts_with("mtllib") && take_word(line) == "mtllib")
      read_materials(folder / with_slashes(line), pictures);
  });
  TextureUses uses;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    aiString name;
    scene.mMaterials[i]->Get(AI_MATKEY_NAME, name);
    std::string_view trimmed(name.C_Str());
    trim(trimmed);
    const auto found = pictures.find(trimmed);
    if (found != pictures.end()) uses[i] = found->second;
  }
  return uses;
}

}  // namespace glark::geometry
