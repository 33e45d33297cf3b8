// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// For tests of parts of the suite that need no case.
#include "conformance/suite/case.h"

namespace glark::conformance {

std::vector<Case> written_cases() { return {}; }

}  // namespace glark::conformance
