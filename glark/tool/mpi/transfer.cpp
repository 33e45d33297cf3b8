// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// mpirun -n N glark-mpi transfer LARGE --from SMALL --to EDITED -o OUT: the same as glark transfer.
#include "glark/clients/stream/ranks/transfer.h"

#include <memory>

#include "glark/tool/mpi/commands.h"
#include "glark/tool/scan/stream/transfer_command.h"
#include "glark/tool/scan/stream/work_folder.h"

namespace glark::tool {
namespace {

struct Transfer : TransferCommand {
  std::string temporary;
};

void transfer(MpiRanks& ranks, const Transfer& command) {
  stream::TransferOptions options = command.options;
  const bool is_first = ranks.rank() == 0;
  Progress progress("transferring to " + command.output);
  if (is_first) options.progress = [&](double fraction) { progress.show(fraction); };
  options.work = work_folder(command.output);
  if (options.threads == 0) options.threads = ranks.threads();
  stream::TransferFiles files{command.input, command.from, command.to, command.output};
  if (!command.temporary.empty()) files.temporary = command.temporary;
  const stream::TransferReport report = stream::transfer(ranks, files, options);
  const double seconds = progress.seconds();
  print_of_all(ranks, is_first ? report_of(command, report, seconds) : Report(), command.json);
}

}  // namespace

void add_transfer(CLI::App& app, MpiRanks& ranks) {
  CLI::App* command = app.add_subcommand("transfer", "Transfer the edit of a sampling to the scan");
  const auto edit = std::make_shared<Transfer>();
  describe(*command, *edit);
  command
      ->add_option("--temporary", edit->temporary,
                   "A folder for the temporary files of each rank, best on a disk of its machine; default: that of OUT")
      ->type_name("FOLDER");
  command->add_flag("--resume", edit->options.resume, resume_help);
  command->callback([edit, &ranks] { transfer(ranks, *edit); });
}

}  // namespace glark::tool
