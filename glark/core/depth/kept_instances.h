// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The size and a copy of sorted instances that are kept for later draws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/core/depth/binned_instances.h"
#include "glark/core/objects/gpu_buffer.h"

namespace glark::depth {

inline constexpr std::size_t command_words = 5;  // of a DrawElementsIndirectCommand

struct InstanceExtent {
  std::uint32_t instances = 0;
  std::uint64_t refined_triangles = 0;
  std::int64_t bytes = 0;               // of a copy
  std::vector<std::uint32_t> commands;  // without empty ones; neighbours that draw the same piece are one
};

// `commands`: as in BinnedInstances, 5 words each. `record_stride`: bytes.
InstanceExtent extent_of(std::span<const std::uint32_t> commands, GLsizei record_stride);

// Copies to a buffer of at least extent.bytes.
BinnedInstances copy_instances(const gl::Dispatch& gl, const BinnedInstances& sorted, const InstanceExtent& extent,
                               const core::GpuBuffer& to);

}  // namespace glark::depth
