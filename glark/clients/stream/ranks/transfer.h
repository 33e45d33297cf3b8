// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include "glark/clients/stream/ranks/ranks.h"
#include "glark/clients/stream/transfer/edited_scan.h"

namespace glark::stream {

// The same as transfer(), by several ranks, with the same bytes: each rank edits a range of the records, and writes it at
// its place in the file that becomes the output. All ranks read the sampling, and see the same file system. All get the
// same report. options.work must be a folder on the file system of the output; there is no resume.
// Errors: RanksError for those of transfer(), on all ranks. A former output stays then.
TransferReport transfer(Ranks& ranks, const TransferFiles& files, const TransferOptions& options);

}  // namespace glark::stream
