// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A film of pictures, encoded by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>

namespace glark::tool {

class Film {
 public:
  // 30 pictures a second. The file's ending chooses the kind: .mp4, .webm, .gif ... Throws std::runtime_error without
  // ffmpeg.
  explicit Film(const std::string& file);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Adds the current framebuffer.
  void add_picture(int width, int height);
  // Throws std::runtime_error if ffmpeg fails.
  void finish();

 private:
  std::string file_;
  std::FILE* pipe_ = nullptr;
  pid_t encoder_ = 0;
};

}  // namespace glark::tool
