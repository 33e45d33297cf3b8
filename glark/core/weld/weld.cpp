// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/weld/weld.h"

#include <algorithm>
#include <string>

#include "glark/core/shader.h"

namespace glark::weld {
namespace {

constexpr char weld_source[] =
#include "glark/core/weld/weld.glsl.inc"
    ;

constexpr const char* uniform_names[] = {"record_offset",   "corner_words",   "triangle_bound",    "count_on_gpu",
                                         "position_offset", "position_words", "normal_offset",     "control_offset",
                                         "turn_offset",     "border_offset",  "coordinate_offset", "tag_offset",
                                         "slot_count",      "key_count"};
constexpr std::uint32_t group_size = 64;
constexpr std::uint32_t most_groups = 65535;      // the least GL_MAX_COMPUTE_WORK_GROUP_COUNT
constexpr std::uint32_t most_in_one_group = 128;  // triangles: one dispatch costs less than three
constexpr std::size_t all_in_one = 3;             // pass

bool takes_one_dispatch(std::uint32_t triangles) { return triangles <= most_in_one_group; }

// Of each table: more than the 3 entries that a triangle can make.
std::uint64_t slots_for(std::uint32_t triangles) { return 4 * std::max<std::uint64_t>(4, triangles); }

std::uint64_t bytes_for(const capture::Layout& layout, std::uint64_t triangles) {
  const std::uint64_t slots = slots_for(static_cast<std::uint32_t>(triangles));
  const std::uint64_t tables = (layout.joins_edges() ? 1 : 0) + (layout.tagged || layout.displaced() ? 1 : 0);
  const std::uint64_t more = (layout.turn_offset >= 0 ? 1 : 0) + (layout.displaced() ? 5 : 0);
  return 4 * (tables * (2 * slots + 3 * triangles) + more * slots);
}

}  // namespace

WeldStage::Pass WeldStage::compile(int pass) const {
  const std::string version = language_ == capture::Language::es
                                  ? "#version 320 es\nprecision highp float;\nprecision highp int;\n"
                                  : "#version 430\n";
  const std::string source = version + "#define GLARK_PASS " + std::to_string(pass) + "\n#define GLARK_GROUP " +
                             std::to_string(group_size) + "\n#define GLARK_KEY_WORDS " +
                             std::to_string(most_key_words) + "\n" + weld_source;
  const core::ShaderText text{GL_COMPUTE_SHADER, source};
  Pass result;
  result.program = core::build_program(gl_, "a welding pass", {&text, 1});
  if (result.program != 0) {
    for (std::size_t i = 0; i < result.uniform.size(); ++i) {
      result.uniform[i] = gl_.GetUniformLocation(result.program, uniform_names[i]);
    }
    result.key_words = gl_.GetUniformLocation(result.program, "key_words");
  }
  return result;
}

bool WeldStage::can_hold(const capture::Layout& layout, std::uint64_t triangles) {
  if (largest_block_ == 0) {
    gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest_block_);
  }
  return bytes_for(layout, triangles) <= static_cast<std::uint64_t>(largest_block_);
}

// What has room for many triangles has it for few.
bool WeldStage::has_room(const capture::Layout& layout, std::uint32_t triangles) const {
  return passes_[takes_one_dispatch(triangles) ? all_in_one : all_in_one - 1].program != 0 &&
         bytes_for(layout, triangles) <= static_cast<std::uint64_t>(tables_.size());
}

bool WeldStage::reserve(const capture::Layout& layout, std::uint32_t triangles) {
  const auto build = [&](std::size_t pass) {
    if (passes_[pass].program == 0) {
      passes_[pass] = compile(static_cast<int>(pass));
    }
    return passes_[pass].program != 0;
  };
  const bool built = build(all_in_one) && (takes_one_dispatch(triangles) || (build(0) && build(1) && build(2)));
  return built && can_hold(layout, triangles) &&
         tables_.reserve(gl_, static_cast<GLsizeiptr>(bytes_for(layout, triangles)), GL_DYNAMIC_COPY);
}

void WeldStage::dispatch(std::size_t pass, const WeldRequest& request, std::uint32_t invocations) const {
  const capture::Layout& layout = *request.layout;
  const capture::Field* position = capture::find_role(layout.fields, capture::Role::position);
  const std::span<const GLint> keys = request.key_words.first(std::min(request.key_words.size(), most_key_words));
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          layout.corner_words,
                          static_cast<GLint>(request.triangles.count),
                          request.triangles.count_on_gpu ? 1 : 0,
                          position->offset,
                          position->words,
                          capture::normal_offset(layout.fields),
                          request.edges ? layout.control_offset : -1,
                          request.edges ? layout.turn_offset : -1,
                          request.edges ? layout.border_offset : -1,
                          layout.coordinate_offset,
                          request.tags ? layout.tag_offset : -1,
                          static_cast<GLint>(slots_for(request.triangles.count)),
                          static_cast<GLint>(keys.size())};
  gl_.UseProgram(passes_[pass].program);
  for (std::size_t i = 0; i < passes_[pass].uniform.size(); ++i) {
    if (passes_[pass].uniform[i] >= 0) {
      gl_.Uniform1i(passes_[pass].uniform[i], values[i]);
    }
  }
  if (!keys.empty() && passes_[pass].key_words >= 0) {
    gl_.Uniform1iv(passes_[pass].key_words, static_cast<GLsizei>(keys.size()), keys.data());
  }
  const std::uint32_t groups = (invocations + group_size - 1) / group_size;
  gl_.DispatchCompute(std::min(groups, most_groups), (groups + most_groups - 1) / most_groups, 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void WeldStage::run(const WeldRequest& request, GLuint captured_count) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, tables_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, captured_count);
  const std::uint32_t triangles = request.triangles.count;
  if (takes_one_dispatch(triangles)) {
    dispatch(all_in_one, request, 1);
  } else {
    dispatch(0, request, static_cast<std::uint32_t>(slots_for(triangles)));
    dispatch(1, request, 3 * triangles);
    dispatch(2, request, 3 * triangles);
  }
  gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void WeldStage::release() {
  for (Pass& pass : passes_) {
    gl_.DeleteProgram(pass.program);
    pass = Pass{};
  }
  tables_.release(gl_);
}

}  // namespace glark::weld
