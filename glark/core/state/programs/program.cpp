// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/program.h"

#include <algorithm>

namespace glark::core {

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

}  // namespace glark::core
