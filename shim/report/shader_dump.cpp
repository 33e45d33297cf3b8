// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/report/shader_dump.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>

#include "glark/core/report/log.h"
#include "glark/core/report/shown_shader.h"
#include "glark/core/state/programs/program.h"

namespace glark::shim {
namespace {

// Never destroyed, because drivers may draw from their exit handlers.
const std::string* dump_folder = nullptr;
std::atomic<bool> complained{false};

void complain(const std::string& file, const char* reason) {
  if (complained.exchange(true)) return;  // one line in all, not one for each shader
  core::log(
      core::LogLevel::error,
      fmt::format("shaders cannot be written to {}: {}; name a folder that can be written with GLARK_DUMP_SHADERS",
                  file, reason));
}

// For example program12-0123456789abcdef.original.vert or fixed-0123456789abcdef.pn.vert. Further shader objects of a
// stage end with .1.vert and so on.
std::string file_name(const core::ShownShader& shader) {
  const std::string program = shader.program == 0 ? "fixed" : fmt::format("program{}", shader.program);
  const std::string object = shader.object > 0 ? fmt::format(".{}", shader.object) : "";
  return fmt::format("{}-{}.{}{}.{}", program, core::hash_text(shader.hash), shader.kind, object, shader.stage);
}

void write_shader(const core::ShownShader& shader) {
  try {
    const std::string file = *dump_folder + "/" + file_name(shader);
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(shader.source.data(), static_cast<std::streamsize>(shader.source.size()));
    if (!out.flush()) complain(file, std::strerror(errno));
  } catch (const std::exception& error) {
    complain(*dump_folder, error.what());
  }
}

}  // namespace

void install_shader_dump(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) complain(folder, error.message().c_str());
  dump_folder = new std::string(folder);
  core::set_shader_sink(write_shader);
}

}  // namespace glark::shim
