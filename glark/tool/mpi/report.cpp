// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/tool/mpi/commands.h"
#include "glark/tool/scan/peak_memory.h"

namespace glark::tool {

void print_of_all(MpiRanks& ranks, Report report, bool json) {
  const stream::Traffic sent = ranks.traffic();  // before the numbers of this report are sent
  report["peak_memory_bytes"] = stream::greatest(ranks, peak_memory());
  report["ranks"] = ranks.size();
  report["bytes_sent"] = stream::sum(ranks, sent.bytes);
  report["messages_sent"] = stream::sum(ranks, sent.messages);
  if (ranks.rank() == 0) print(report, json);
}

}  // namespace glark::tool
