// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <functional>

#include "glark/clients/stream/sample/in_core.h"

namespace glark::stream {

// The same as sample(). Calls published() when the samples are in their place, before the state of the work is removed. So
// a run that is killed within published() can be resumed.
SampleReport sample_and_publish(const Source& source, const SampleOptions& options,
                                const std::filesystem::path& temporary, const CreateWriter& create,
                                const std::function<void(const SampleReport&)>& published);

}  // namespace glark::stream
