// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The program ffmpeg, which encodes the frames that we send it.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "shim/contexts/surface.h"

namespace glark::shim {

class Encoder {
 public:
  // Starts ffmpeg, which is no child of this process: the program never meets it in wait(). `problem`: why it cannot.
  static Encoder start(const std::string& file, Size size, std::string& problem);

  bool running() const { return socket_ >= 0; }
  // Rows from the top, red, green and blue. Blocks while ffmpeg is busy. False: ffmpeg has ended.
  bool add(std::span<const unsigned char> pixels, Size size);
  // Waits until the film is complete, but not forever.
  void finish();

 private:
  bool send_all(const void* bytes, std::size_t count) const;

  int socket_ = -1;
};

}  // namespace glark::shim
