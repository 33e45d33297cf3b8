// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// mpirun -n N glark-mpi sample LARGE -o SMALL: the same as glark sample.
#include "glark/clients/stream/ranks/sample/sample.h"

#include <memory>

#include "glark/tool/mpi/commands.h"
#include "glark/tool/scan/stream/sample_command.h"

namespace glark::tool {
namespace {

struct Sample : SampleCommand {
  std::string temporary;
};

void sample(MpiRanks& ranks, const Sample& command) {
  stream::SampleOptions options = command.options;
  const bool is_first = ranks.rank() == 0;
  Progress progress("sampling " + command.input);
  if (is_first) options.progress = [&](double fraction) { progress.show(fraction); };
  if (options.threads == 0) options.threads = ranks.threads();
  const stream::SampleReport report = stream::sample_file(
      ranks, {command.input, command.output, {.large = command.format, .text = command.text}, command.temporary},
      options);
  const double seconds = progress.seconds();
  print_of_all(ranks, is_first ? report_of(command, report, seconds) : Report(), command.json);
}

}  // namespace

void add_sample(CLI::App& app, MpiRanks& ranks) {
  CLI::App* command = app.add_subcommand("sample", "Sample a scan of any size");
  const auto sampling = std::make_shared<Sample>();
  describe(*command, *sampling);
  command
      ->add_option("--temporary", sampling->temporary,
                   "A folder for the temporary files of each rank, best on a disk of its machine; default: that of "
                   "SMALL")
      ->type_name("FOLDER");
  command->callback([sampling, &ranks] { sample(ranks, *sampling); });
}

}  // namespace glark::tool
