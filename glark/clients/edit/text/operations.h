// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One row for each operation: its form, and how it is read.
#pragma once

#include <glark/edit.h>

#include "glark/clients/edit/text/words.h"

namespace glark::edit {

struct Row {
  Form form;
  Operation (*read)(Words& words);  // of the words after the name
};

std::span<const Row> rows();

}  // namespace glark::edit
