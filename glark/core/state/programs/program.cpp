// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/program.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>

namespace glark::core {
namespace {

bool in_word(char letter) { return letter == '_' || std::isalnum(static_cast<unsigned char>(letter)) != 0; }

// The text from `at` on begins with a comment: where it ends; else `at`.
std::size_t after_comment(std::string_view glsl, std::size_t at) {
  const std::string_view rest = glsl.substr(at);
  if (rest.substr(0, 2) == "//") {
    return std::min(glsl.find_first_of("\r\n", at), glsl.size());
  }
  if (rest.substr(0, 2) == "/*") {
    const std::size_t end = glsl.find("*/", at + 2);
    return end == std::string_view::npos ? glsl.size() : end + 2;
  }
  return at;
}

// Every storing shader has such a word: a storage block, an atomic counter, a store into an image.
constexpr std::string_view storing_words[] = {"buffer", "atomic_uint"};
constexpr std::string_view storing_starts[] = {"imageStore", "imageAtomic", "GL_NV_shader_buffer_store"};

bool tells_of_stores(std::string_view word) {
  return std::find(std::begin(storing_words), std::end(storing_words), word) != std::end(storing_words) ||
         std::any_of(std::begin(storing_starts), std::end(storing_starts),
                     [&](std::string_view start) { return word.substr(0, start.size()) == start; });
}

// With a backslash at its end, a word or a comment may go on in the next line. So each word counts, wherever it is.
bool mentions_stores(std::string glsl) {
  for (const std::string_view end : {"\\\r\n", "\\\n"}) {
    for (std::size_t at = glsl.find(end); at != std::string::npos; at = glsl.find(end, at)) {
      glsl.erase(at, end.size());
    }
  }
  constexpr std::string_view parts[] = {"buffer", "image", "atomic"};
  return std::any_of(std::begin(parts), std::end(parts),
                     [&](std::string_view part) { return glsl.find(part) != std::string::npos; });
}

bool may_store(std::string_view glsl) {
  if (glsl.find("##") != std::string_view::npos) {
    return true;  // macros may make each word of parts
  }
  if (glsl.find('\\') != std::string_view::npos) {
    return mentions_stores(std::string(glsl));
  }
  for (std::size_t at = 0; at < glsl.size();) {
    if (const std::size_t after = after_comment(glsl, at); after != at) {
      at = after;
      continue;
    }
    std::size_t end = at;
    while (end < glsl.size() && in_word(glsl[end])) {
      ++end;
    }
    if (tells_of_stores(glsl.substr(at, end - at))) {
      return true;
    }
    at = std::max(end, at + 1);
  }
  return false;
}

}  // namespace

// Based on: Fowler, Noll, Vo, the FNV non-cryptographic hash algorithm (RFC 9923), FNV-1a of 64 bits. Users write these
// hashes into configuration files: the function must stay as it is.
std::uint64_t source_hash(const std::vector<StageSource>& stages) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto take = [&hash](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3U; };
  std::vector<const StageSource*> sorted;
  for (const StageSource& stage : stages) {
    sorted.push_back(&stage);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const StageSource* a, const StageSource* b) { return a->stage < b->stage; });
  for (const StageSource* stage : sorted) {
    take(static_cast<unsigned char>(stage->stage & 0xffU));
    take(static_cast<unsigned char>(stage->stage >> 8U));
    for (const char letter : *stage->source) {
      take(static_cast<unsigned char>(letter));
    }
  }
  return hash;
}

std::string hash_text(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; hash >>= 4U) {
    text[i] = "0123456789abcdef"[hash & 15U];
  }
  return text;
}

bool reads_conventional_projection(const std::vector<StageSource>& stages) {
  return std::any_of(stages.begin(), stages.end(), [](const StageSource& stage) {
    const auto has = [&](const char* name) { return stage.source->find(name) != std::string::npos; };
    return stage.stage == GL_VERTEX_SHADER &&
           (has("ftransform") || has("gl_ModelViewProjectionMatrix") || has("gl_ProjectionMatrix"));
  });
}

bool Program::has_old_geometry_shader() const {
  return std::any_of(stages.begin(), stages.end(), [](const StageSource& stage) {
    return stage.stage == GL_GEOMETRY_SHADER && stage.source->find("_geometry_shader4") != std::string::npos;
  });
}

bool may_store(const std::vector<StageSource>& stages) {
  return std::any_of(stages.begin(), stages.end(),
                     [](const StageSource& stage) { return may_store(std::string_view(*stage.source)); });
}

}  // namespace glark::core
