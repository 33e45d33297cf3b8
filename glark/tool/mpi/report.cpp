// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <ctime>

#include "glark/clients/stream/ranks/agreement.h"
#include "glark/tool/mpi/commands.h"
#include "glark/tool/scan/peak_memory.h"

namespace glark::tool {
namespace {

// The seconds that this process has computed, in all of its threads. It also computes while it waits for messages.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

void print_of_all(MpiRanks& ranks, Report report, bool json) {
  const stream::Traffic sent = ranks.traffic();  // before the numbers of this report are sent
  report["peak_memory_bytes"] = stream::greatest(ranks, peak_memory());
  report["cpu_seconds"] = stream::greatest(ranks, cpu_seconds());
  report["ranks"] = ranks.size();
  report["bytes_sent"] = stream::sum(ranks, sent.bytes);
  report["messages_sent"] = stream::sum(ranks, sent.messages);
  if (ranks.rank() == 0) print(report, json);
}

}  // namespace glark::tool
