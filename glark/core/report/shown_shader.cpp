// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/shown_shader.h"

#include <atomic>

namespace glark::core {
namespace {

std::atomic<ShaderSink> shader_sink{nullptr};

}  // namespace

void set_shader_sink(ShaderSink wanted) { shader_sink.store(wanted, std::memory_order_relaxed); }
bool wants_shaders() { return shader_sink.load(std::memory_order_relaxed) != nullptr; }

void show_shader(const ShownShader& shader) {
  if (const ShaderSink current = shader_sink.load(std::memory_order_relaxed); current != nullptr) {
    current(shader);
  }
}

}  // namespace glark::core
