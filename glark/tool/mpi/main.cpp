// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-mpi: commands that the processes of an MPI run work on together: mpirun -n N glark-mpi COMMAND ...
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "glark/clients/stream/ranks/agreement.h"
#include "glark/tool/mpi/commands.h"
#include "glark/tool/scan/complaint.h"

namespace {

using namespace glark;

int run(tool::MpiRanks& ranks, int argc, char** argv) {
  const bool is_first = ranks.rank() == 0;
  CLI::App app("glark-mpi: points in files, by several processes", "glark-mpi");
  app.require_subcommand(1);
  tool::add_sample(app, ranks);
  tool::add_simplify(app, ranks);
  tool::add_transfer(app, ranks);
  try {
    app.parse(argc, argv);
    if (is_first && std::fflush(stdout) != 0)
      return tool::complain("the report cannot be written to standard output", tool::exit_failure);
  } catch (const CLI::Success& wanted) {  // --help
    return is_first ? app.exit(wanted) : 0;
  } catch (const CLI::ParseError& error) {  // the same on all ranks
    const std::string problem = std::string(error.what()) + "; glark-mpi COMMAND --help lists the options";
    return is_first ? tool::complain(problem, tool::exit_usage) : tool::exit_usage;
  } catch (const stream::RanksError& error) {  // on all ranks
    return is_first ? tool::complain(error.what(), tool::exit_failure) : tool::exit_failure;
  } catch (const std::exception& error) {
    tool::complain(error.what(), tool::exit_failure);
    ranks.abort(tool::exit_failure);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  tool::MpiRanks ranks(argc, argv);
  return run(ranks, argc, argv);
}
