// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/mpi/mpi_ranks.h"

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace glark::tool {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;  // of a message: MPI counts in int

// The messages that carry some bytes.
std::size_t messages_of(std::size_t bytes) { return (bytes + most_bytes - 1) / most_bytes; }

}  // namespace

// MPI's functions end all ranks if they fail, and say why: this is their default.
MpiRanks::MpiRanks(int& argc, char**& argv) {
  int provided = 0, rank = 0, size = 1, neighbours = 1;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &neighbours);
  MPI_Comm_free(&machine);
  rank_ = static_cast<std::size_t>(rank);
  size_ = static_cast<std::size_t>(size);
  threads_ = static_cast<unsigned>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN) / neighbours));
}

MpiRanks::~MpiRanks() { MPI_Finalize(); }

void MpiRanks::abort(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);
}

std::vector<std::uint64_t> MpiRanks::do_exchange(std::span<const std::uint64_t> numbers) {
  std::vector<std::uint64_t> received(size_);
  MPI_Alltoall(numbers.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  return received;
}

void MpiRanks::do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from,
                               std::span<char> received) {
  if (to == rank_ && from == rank_) {
    std::copy(bytes.begin(), bytes.end(), received.begin());
    return;
  }
  std::vector<MPI_Request> requests(messages_of(received.size()) + messages_of(bytes.size()));
  std::size_t next = 0;
  const auto part_of = [](std::size_t all, std::size_t begin) {
    return static_cast<int>(std::min(most_bytes, all - begin));
  };
  for (std::size_t at = 0; from != nobody && at < received.size(); at += most_bytes)
    MPI_Irecv(&received[at], part_of(received.size(), at), MPI_BYTE, static_cast<int>(from), 0, MPI_COMM_WORLD,
              &requests[next++]);
  for (std::size_t at = 0; to != nobody && at < bytes.size(); at += most_bytes)
    MPI_Isend(&bytes[at], part_of(bytes.size(), at), MPI_BYTE, static_cast<int>(to), 0, MPI_COMM_WORLD,
              &requests[next++]);
  MPI_Waitall(static_cast<int>(next), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace glark::tool
