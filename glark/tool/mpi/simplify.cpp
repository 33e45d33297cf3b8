// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// mpirun -n N glark-mpi simplify FILE -o OUT: the same as glark simplify.
#include "glark/tool/scan/simplify/simplify_command.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "glark/clients/stream/ranks/agreement.h"
#include "glark/tool/mpi/commands.h"
#include "glark/tool/mpi/rank_mesh.h"
#include "glark/tool/scan/parts/large_mesh_steps.h"
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/stream/work_folder.h"

namespace glark::tool {
namespace {

struct Simplify : SimplifyCommand {
  std::string temporary;
};

// What rank 0 decides for all.
struct Reading {
  std::uint64_t memory = 0;
  std::uint64_t in_parts = 0;
};

Reading reading_of(MpiRanks& ranks, const Simplify& command) {
  std::vector<Reading> reading(1);
  stream::together(ranks, [&] {
    if (ranks.rank() != 0) return;
    check_output(command.files);
    const Memory memory = memory_for(command.memory);
    reading[0] = {memory.bytes, must_read_in_parts(command.files, memory) ? 1U : 0U};
    if (reading[0].in_parts != 0 && work_folder(command.files.output).empty())
      throw std::runtime_error(command.files.output + ": is a pipe or a device; write to a file");
  });
  broadcast_values(ranks, reading);
  return reading[0];
}

void run(MpiRanks& ranks, const Simplify& command) {
  const Progress progress("reading");
  const Reading reading = reading_of(ranks, command);
  const bool is_first = ranks.rank() == 0;
  SimplifyInput input;
  if (reading.in_parts != 0) {
    const RankFolders folders{work_folder(command.files.output), command.temporary.empty()
                                                                     ? folder_of(command.files)
                                                                     : std::filesystem::path(command.temporary)};
    const unsigned threads = command.options.threads == 0 ? ranks.threads() : command.options.threads;
    LargeMesh large = read_by_ranks(ranks, command.files, {reading.memory, command.options.target, threads}, folders);
    input = {std::move(large.geometry), std::move(large.contents), false};
  }
  Report report;
  stream::together(ranks, [&] {
    if (!is_first) return;
    if (reading.in_parts == 0)
      input = read_whole(command);
    else
      warn(command.files.input + ": read in parts, for it does not fit into the memory");
    report = simplify(command, input, progress);
  });
  print_of_all(ranks, std::move(report), command.files.json);
}

}  // namespace

void add_simplify(CLI::App& app, MpiRanks& ranks) {
  CLI::App* command = app.add_subcommand("simplify", "Reduce triangles, or points if there are no triangles");
  const auto simplification = std::make_shared<Simplify>();
  describe(*command, *simplification);
  command
      ->add_option("--temporary", simplification->temporary,
                   "A folder for the temporary files of each rank, best on a disk of its machine; default: that of OUT")
      ->type_name("FOLDER");
  command->callback([simplification, command, &ranks] {
    set_method(*command, *simplification);
    run(ranks, *simplification);
  });
}

}  // namespace glark::tool
