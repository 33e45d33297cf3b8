// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::shim {

// Call it at the end of each frame. Reads the settings again after SIGHUP, or if the configuration file has changed; the
// file is looked at twice a second. Only for programs that are refined without calling the extension.
void watch_settings();

}  // namespace glark::shim
