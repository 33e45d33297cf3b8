// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Marks for the shared client libraries.
#ifndef GLARK_EXPORT_H
#define GLARK_EXPORT_H

#define GLARK_EXPORT __attribute__((visibility("default"))) /* programs may call it */
#define GLARK_PRIVATE __attribute__((visibility("hidden"))) /* not exported, although it is part of an exported class */

#endif  // GLARK_EXPORT_H
