// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/bins.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace glark::depth {
namespace {

constexpr char bins_source[] =
#include "glark/core/depth/bins.glsl.inc"
#include "glark/core/depth/kept_instances.h"
    ;

// Words of the work buffer, as bins.glsl declares it.
constexpr std::size_t work_all_instances = 4;
constexpr std::size_t work_header = 12;
constexpr std::size_t work_pieces = work_header + 2 * pattern::piece_count;
constexpr std::size_t work_commands = work_pieces + 4 * pattern::piece_count;
constexpr std::size_t work_words = work_commands + 5 * pattern::piece_count;
constexpr std::int64_t deep_reserve_bytes = std::int64_t{32} << 20;

constexpr const char* bin_uniforms[] = {"record_offset",        "corner_words", "tag_offset", "uniform_tag",
                                        "triangle_bound",       "count_on_gpu", "pool_level", "instance_capacity",
                                        "tags_are_edge_depths", "counted"};

}  // namespace

bool BinStage::build(core::ComputePass& pass, std::uint64_t number, const BinKind& kind) {
  const bool morphing = kind.interior == pattern::Interior::morphing;
  const core::ComputeText text{
      .what = "a binning pass",
      .source = bins_source,
      .es = language_ == capture::Language::es,
      .defines = {{"GLARK_PASS", number},
                  {"GLARK_INTERIOR", static_cast<std::uint64_t>(kind.interior)},
                  {"GLARK_STEPS", morphing ? std::uint64_t{pattern::morph_steps} : 1U},
                  {"GLARK_PACKED_BITS", kind.measured ? static_cast<std::uint64_t>(measured_bits(morphing)) : 0U}}};
  return compilation_.build(pass, text, bin_uniforms);
}

bool BinStage::compile(const BinKind& kind) {
  Passes& passes = passes_[kind];
  const bool scan = build(scan_, 1, kind);
  const bool count = build(passes.count, 0, kind);
  const bool scatter = build(passes.scatter, 2, kind);
  return scan && count && scatter;
}

bool BinStage::prepare(const pattern::GpuPool& pool) {
  std::vector<std::uint32_t> words(work_words, 0);
  for (std::size_t piece = 0; piece < pattern::piece_count; ++piece) {
    const pattern::Piece& from = pool.piece(static_cast<int>(piece));
    std::uint32_t* to = &words[work_pieces + 4 * piece];
    to[0] = from.index_count;
    to[1] = from.first_index;
    to[2] = static_cast<std::uint32_t>(from.base_vertex);
    std::uint32_t* command = &words[work_commands + 5 * piece];
    command[0] = to[0];
    command[2] = to[1];
    command[3] = to[2];
  }
  return work_.allocate(gl_, static_cast<std::int64_t>(work_words * sizeof(words[0])), words.data(), GL_DYNAMIC_COPY);
}

namespace {

constexpr std::int64_t bytes_an_instance = 12 + 16;  // the numbers of its corners, and its patch

std::uint32_t most_instances(const capture::Layout& layout, std::uint32_t triangles, unsigned deepest_tag) {
  // A triangle has at most four instances, unless it is cut into tiles (more than tile_level levels on every edge).
  std::uint64_t instances = std::uint64_t{4} * triangles;
  if (deepest_tag > static_cast<unsigned>(pattern::tile_level)) {
    const std::uint64_t tiles = std::uint64_t{1} << (2 * (deepest_tag - pattern::tile_level));
    const auto reserve = static_cast<std::uint64_t>(deep_reserve_bytes / Reorder::stride(layout));
    instances = std::max(instances, std::min(instances * tiles, reserve));
  }
  return static_cast<std::uint32_t>(instances);
}

}  // namespace

bool BinStage::has_room(const capture::Layout& layout, std::uint32_t triangles, const DepthPlan& plan) const {
  const std::uint32_t instances = most_instances(layout, triangles, plan.deepest);
  const auto found = passes_.find({plan.interior, plan.measured});
  return found != passes_.end() && found->second.built() && instances <= capacity_ &&
         reorder_.has_room(layout, instances);
}

bool BinStage::reserve(const capture::Layout& layout, std::uint32_t triangles, const DepthPlan& plan) {
  const std::uint32_t instances = most_instances(layout, triangles, plan.deepest);
  if (!compile({plan.interior, plan.measured})) {
    return false;
  }
  if (instances > capacity_ &&
      !instances_.reserve(gl_, static_cast<std::int64_t>(instances) * bytes_an_instance, GL_DYNAMIC_COPY)) {
    return false;
  }
  capacity_ = static_cast<std::uint32_t>(instances_.size() / bytes_an_instance);
  return reorder_.reserve(layout, instances);
}

void BinStage::set_uniforms(const core::ComputePass& pass, const BinRequest& request) const {
  const bool measured = request.measured.buffer != 0;
  const GLintptr offset = measured ? request.measured.offset : request.triangles.offset;
  const GLint values[] = {static_cast<GLint>(offset / 4),
                          request.layout->corner_words,
                          request.layout->tag_offset,
                          static_cast<GLint>(request.uniform_tag),
                          static_cast<GLint>(request.triangles.count),
                          request.triangles.count_on_gpu ? 1 : 0,
                          static_cast<GLint>(request.pool_level),
                          static_cast<GLint>(capacity_),
                          request.tags_are_edge_depths ? 1 : 0,
                          request.counted ? 1 : 0};
  pass.set_integers(gl_, values);
}

BinnedInstances BinStage::sort(const BinRequest& request, GLuint count_buffer, const core::Bindings& bindings) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0,
                     request.measured.buffer != 0 ? request.measured.buffer : request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, instances_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, work_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, count_buffer);
  const Passes& own = passes_.at({request.interior, request.measured.buffer != 0});
  const core::ComputePass* const passes[] = {&own.count, &scan_, &own.scatter};
  for (std::size_t i = 0; i < std::size(passes); ++i) {
    passes[i]->use(gl_);
    set_uniforms(*passes[i], request);
    core::ComputePass::dispatch(gl_, i == 1 ? 1 : request.triangles.count);
    gl_.MemoryBarrier(i == 2 ? GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
                                   GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT
                             : GL_SHADER_STORAGE_BARRIER_BIT);
  }
  const Order order{instances_.name(), work_.name(), static_cast<GLintptr>(work_all_instances * 4)};
  reorder_.run(*request.layout, request.triangles, order, bindings);
  return {.records = reorder_.records(),
          .record_stride = Reorder::stride(*request.layout),
          .patches = instances_.name(),
          .patches_offset = static_cast<GLintptr>(capacity_) * 12,
          .commands = work_.name(),
          .commands_offset = static_cast<GLintptr>(work_commands * 4),
          .command_count = pattern::piece_count};
}

namespace {}  // namespace

InstanceExtent BinStage::extent(const BinnedInstances& sorted) const {
  std::vector<std::uint32_t> all(command_words * pattern::piece_count);
  work_.read(gl_, static_cast<GLintptr>(work_commands * sizeof(all[0])),
             static_cast<std::int64_t>(all.size() * sizeof(all[0])), all.data());
  return extent_of(all, sorted.record_stride);
}

std::uint32_t BinStage::instances_of_last() const {
  std::uint32_t instances = 0;
  work_.read(gl_, work_all_instances * 4, sizeof(instances), &instances);
  return instances / 3;
}

std::uint64_t BinStage::take_refined_triangles() {
  if (work_.name() == 0) {
    return 0;
  }
  std::uint32_t words[2] = {0, 0};
  work_.read(gl_, 0, sizeof(words), words);
  const std::uint32_t zero[2] = {0, 0};
  work_.write(gl_, 0, sizeof(zero), zero);
  return words[0] + (static_cast<std::uint64_t>(words[1]) << 32);
}

void BinStage::release() {
  scan_.release(gl_);
  for (auto& [kind, passes] : passes_) {
    passes.count.release(gl_);
    passes.scatter.release(gl_);
  }
  passes_.clear();
  work_.release(gl_);
  instances_.release(gl_);
  reorder_.release();
  capacity_ = 0;
}

}  // namespace glark::depth
