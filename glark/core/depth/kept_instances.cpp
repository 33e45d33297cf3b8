// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/kept_instances.h"

#include <algorithm>

#include "glark/core/capture/record.h"

namespace glark::depth {
namespace {

// Places of words in a DrawElementsIndirectCommand.
constexpr std::size_t instance_count = 1;
constexpr std::size_t base_instance = 4;

constexpr std::int64_t patch_bytes = 16;

// Returns whether `next` continues `last` with the same piece.
bool continues(std::span<const std::uint32_t> last, std::span<const std::uint32_t> next) {
  return last[0] == next[0] && last[2] == next[2] && last[3] == next[3] &&
         last[base_instance] + last[instance_count] == next[base_instance];
}

}  // namespace

InstanceExtent extent_of(std::span<const std::uint32_t> commands, GLsizei record_stride) {
  InstanceExtent extent;
  for (std::size_t at = 0; at + command_words <= commands.size(); at += command_words) {
    const std::span<const std::uint32_t> command = commands.subspan(at, command_words);
    if (command[instance_count] == 0) {
      continue;
    }
    extent.instances += command[instance_count];
    extent.refined_triangles += std::uint64_t{command[instance_count]} * (command[0] / 3);
    if (!extent.commands.empty()) {
      const std::span<std::uint32_t> last = std::span(extent.commands).last(command_words);
      if (continues(last, command)) {
        last[instance_count] += command[instance_count];
        continue;
      }
    }
    extent.commands.insert(extent.commands.end(), command.begin(), command.end());
  }
  extent.bytes = extent.instances * (std::int64_t{record_stride} + patch_bytes) + capture::chunk_overrun +
                 static_cast<std::int64_t>(extent.commands.size() * sizeof(extent.commands[0]));
  return extent;
}

BinnedInstances copy_instances(const gl::Dispatch& gl, const BinnedInstances& sorted, const InstanceExtent& extent,
                               const core::GpuBuffer& to) {
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  BinnedInstances result = sorted;
  const std::int64_t records = std::int64_t{extent.instances} * sorted.record_stride;
  const std::int64_t patches = patch_bytes * extent.instances;
  result.records = result.patches = result.commands = to.name();
  result.records_offset = 0;
  result.patches_offset = static_cast<GLintptr>(records + capture::chunk_overrun);
  result.commands_offset = result.patches_offset + static_cast<GLintptr>(patches);
  result.command_count = static_cast<GLsizei>(extent.commands.size() / command_words);
  to.copy_from(gl, sorted.records, sorted.records_offset, 0, records);
  to.copy_from(gl, sorted.patches, sorted.patches_offset, result.patches_offset, patches);
  to.write(gl, result.commands_offset, static_cast<std::int64_t>(extent.commands.size() * sizeof(extent.commands[0])),
           extent.commands.data());
  return result;
}

}  // namespace glark::depth
