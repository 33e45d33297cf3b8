// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/centroid_split.h"

#include <algorithm>
#include <vector>

namespace glark::polygons {
namespace {

constexpr char split_source[] =
#include "glark/core/polygons/centroid_split.glsl.inc"
    ;

constexpr const char* uniform_names[] = {"record_offset", "corner_words", "tag_offset",    "first_integer",
                                         "pool_level",    "equal_sides",  "polygon_bound", "count_on_gpu",
                                         "centroids",     "is_fan",       "depth_steps",   "corners"};
constexpr std::size_t corners = 11;
constexpr std::uint32_t group_size = 64;
constexpr std::uint32_t most_groups = 65535;  // the least GL_MAX_COMPUTE_WORK_GROUP_COUNT

GLuint groups_for(std::uint32_t count) { return std::min((count + group_size - 1) / group_size, most_groups); }

std::int64_t record_words(const SplitRequest& request) {
  return std::int64_t{request.records()} * request.layout->triangle_words();
}

std::int64_t bytes_of(const SplitRequest& request) {
  return 4 * (record_words(request) + std::int64_t{request.polygons()} * request.layout->corner_words) +
         capture::chunk_overrun;
}

std::int64_t table_bytes(const SplitRequest& request) {
  return static_cast<std::int64_t>(request.sides.size() + 1) * 8;
}

int first_integer(const capture::Layout& layout) {
  int first = layout.corner_words;
  for (const capture::Field& field : layout.fields) {
    first = capture::is_integer(field.type) ? std::min(first, field.offset) : first;
  }
  return first;
}

}  // namespace

bool CentroidSplit::compile() {
  for (std::size_t pass = 0; pass < passes_.size(); ++pass) {
    const core::ComputeText text{.what = "a centroid pass", .source = split_source, .defines = {{"GLARK_PASS", pass}}};
    if (!passes_[pass].build(gl_, text, uniform_names)) {
      return false;
    }
  }
  return true;
}

bool CentroidSplit::prepare() {
  if (count_command_.name() != 0) {
    return passes_[0].built() && passes_[1].built();
  }
  const bool compiled = compile();
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest_block_);
  const capture::CountCommand command;
  return count_command_.allocate(gl_, sizeof(command), &command, GL_DYNAMIC_COPY) && compiled;
}

bool CentroidSplit::has_room(const SplitRequest& request) const {
  return passes_[1].built() && bytes_of(request) <= records_.size() && table_bytes(request) <= table_.size();
}

bool CentroidSplit::reserve(const SplitRequest& request) {
  return prepare() && bytes_of(request) <= largest_block_ &&
         records_.reserve(gl_, bytes_of(request), GL_DYNAMIC_COPY) &&
         table_.reserve(gl_, table_bytes(request), GL_DYNAMIC_DRAW);
}

void CentroidSplit::set_uniforms(const core::ComputePass& pass, const SplitRequest& request) const {
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout->corner_words,
                          request.layout->tag_offset,
                          first_integer(*request.layout),
                          static_cast<GLint>(request.pool_level),
                          static_cast<GLint>(request.equal_sides()),
                          static_cast<GLint>(request.polygons()),
                          request.triangles.count_on_gpu ? 1 : 0,
                          static_cast<GLint>(record_words(request)),
                          request.decomposition.fan ? 1 : 0,
                          request.depth_steps};
  pass.set_integers(gl_, values);
  gl_.Uniform1iv(pass.location(corners), static_cast<GLsizei>(request.decomposition.corners.size()),
                 request.decomposition.corners.data());
}

void CentroidSplit::write_table(const SplitRequest& request) {
  if (request.sides.empty()) {
    return;
  }
  std::vector<std::uint32_t> words{0, 0};
  for (const std::uint32_t sides : request.sides) {
    const std::uint32_t next[] = {words[words.size() - 2] + sides - 2, words.back() + sides};
    words.insert(words.end(), std::begin(next), std::end(next));
  }
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(table_bytes(request)),
                    words.data());  // bound just now
}

capture::CoarseTriangles CentroidSplit::split(const SplitRequest& request, GLuint captured_count) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, records_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, captured_count);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, count_command_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, table_.name());
  write_table(request);
  passes_[0].use(gl_);
  set_uniforms(passes_[0], request);
  gl_.DispatchCompute(groups_for(request.polygons()), static_cast<GLuint>(request.layout->corner_words), 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  passes_[1].use(gl_);
  set_uniforms(passes_[1], request);
  gl_.DispatchCompute(groups_for(request.records()), 1, 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
  return {records_.name(), 0, request.records(), request.triangles.count_on_gpu};
}

void CentroidSplit::release() {
  for (core::ComputePass& pass : passes_) {
    pass.release(gl_);
  }
  records_.release(gl_);
  count_command_.release(gl_);
  table_.release(gl_);
}

}  // namespace glark::polygons
