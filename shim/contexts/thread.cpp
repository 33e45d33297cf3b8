// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/thread.h"

namespace glark::shim {

constinit thread_local Thread current_thread __attribute__((tls_model("initial-exec"))) = {&first_call, nullptr};

}  // namespace glark::shim
