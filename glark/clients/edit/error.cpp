// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/edit.h>

namespace glark::edit {

Error::Error(Element element, std::size_t index, const std::string& what) : ElementError(element, index, what) {}

}  // namespace glark::edit
