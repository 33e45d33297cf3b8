// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark transfer LARGE --from SMALL --to EDITED -o OUT: the edit of a sampling, on the scan that it was taken from.
#include <memory>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/stream/transfer_command.h"
#include "glark/tool/scan/stream/work_folder.h"

namespace glark::tool {
namespace {

void transfer(const TransferCommand& command) {
  stream::TransferOptions options = command.options;
  Progress progress("transferring to " + command.output);
  options.progress = [&](double fraction) { progress.show(fraction); };
  options.work = work_folder(command.output);
  const stream::TransferReport report =
      stream::transfer(command.input, command.from, command.to, command.output, options);
  print(report_of(command, report, progress.seconds()), command.json);
}

}  // namespace

void add_transfer(CLI::App& app) {
  CLI::App* command = app.add_subcommand("transfer", "Transfer the edit of a sampling to the scan");
  const auto edit = std::make_shared<TransferCommand>();
  describe(*command, *edit);
  command->add_flag("--resume", edit->options.resume, resume_help);
  command->callback([edit] { transfer(*edit); });
}

}  // namespace glark::tool
