// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/transfer_memory.h"

#include <fmt/format.h>

#include <algorithm>

namespace glark::stream {
namespace {

constexpr std::size_t least_memory = std::size_t{40} << 20;
constexpr std::size_t program_bytes = std::size_t{18} << 20, bytes_of_a_thread = std::size_t{2} << 20;
constexpr std::size_t most_batch = std::size_t{128} << 20;  // more records at a time take no less time

}  // namespace

// Records get a quarter. What a sampling in memory leaves is for them, too: shuffled records take less time if many are
// edited together.
TransferMemory::TransferMemory(std::size_t memory, const SamplingFiles& files, const common::Workers& workers) {
  const std::size_t program = program_bytes + workers.count() * bytes_of_a_thread;
  if (memory < std::max(least_memory, 2 * program))
    throw Error(Element::option, 0,
                fmt::format("glark-stream: memory is {} bytes; {} is the least with {} threads", memory,
                            std::max(least_memory, 2 * program), workers.count()));
  const std::size_t room = memory - program;
  batch = std::min(most_batch, room / 4);
  sampling = room - batch;
  const SamplingBytes bytes = bytes_in_memory(files);
  if (bytes.reading <= sampling) batch = std::min(most_batch, room - std::min(room - batch, bytes.kept));
}

}  // namespace glark::stream
