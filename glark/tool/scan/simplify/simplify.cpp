// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark simplify FILE -o OUT: reduces the number of triangles, or of points if there are no triangles.
#include "glark/tool/scan/simplify/simplify_command.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/quality.h"
#if GLARK_HAS_STREAM
#include "glark/tool/scan/parts/large_mesh.h"
#endif

namespace glark::tool {
namespace {

SimplifyInput read_input(const SimplifyCommand& command) {
#if GLARK_HAS_STREAM
  if (const Memory memory = memory_for(command.memory); must_read_in_parts(command.files, memory)) {
    if (!command.reference.empty())
      throw std::runtime_error(
          "--measure keeps the whole file in the memory; measure the result: glark info OUT --measure");
    LargeMesh large = read_in_parts(command.files, {memory.bytes, command.options.target, command.options.threads});
    warn(command.files.input + ": read in parts, for it does not fit into the memory");
    return {std::move(large.geometry), std::move(large.contents), false};
  }
#endif
  return read_whole(command);
}

void run(const SimplifyCommand& command) {
  check_output(command.files);
  const Progress reading("reading");
  const SimplifyInput input = read_input(command);
  print(simplify(command, input, reading), command.files.json);
}

}  // namespace

void add_simplify(CLI::App& app) {
  CLI::App* command = app.add_subcommand("simplify", "Reduce triangles, or points if there are no triangles");
  const auto simplification = std::make_shared<SimplifyCommand>();
  describe(*command, *simplification);
  describe_measure(*command, simplification->reference);
  command->callback([simplification, command] {
    set_method(*command, *simplification);
    run(*simplification);
  });
}

}  // namespace glark::tool
