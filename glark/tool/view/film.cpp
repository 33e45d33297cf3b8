// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "glark/tool/view/draw/gl.h"

namespace glark::tool {
namespace {

// A GIF gets a palette of its own. Other formats get an even width and height, because most encoders require this.
std::string filter_for(const std::string& file) {
  return file.ends_with(".gif") ? "vflip,split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                : "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p";
}

}  // namespace

Film::Film(const std::string& file) : file_(file) {
  std::vector<std::string> words{"ffmpeg", "-loglevel", "error", "-y", "-f",  "image2pipe",     "-framerate", "30",
                                 "-c:v",   "ppm",       "-i",    "-",  "-vf", filter_for(file), file};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(fmt::format("{}: {}", file, std::strerror(errno)));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  const int error = posix_spawnp(&encoder_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  if (error != 0) {
    close(ends[1]);
    throw std::runtime_error(
        fmt::format("{}: the program ffmpeg cannot be run: {}; install it", file, std::strerror(error)));
  }
  signal(SIGPIPE, SIG_IGN);  // ffmpeg tells itself why it ends
  pipe_ = fdopen(ends[1], "wb");
}

Film::~Film() {
  if (pipe_ == nullptr) return;
  std::fclose(pipe_);
  waitpid(encoder_, nullptr, 0);
}

void Film::add_picture(int width, int height) {
  std::vector<unsigned char> pixels(std::size_t{3} * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  fmt::print(pipe_, "P6\n{} {}\n255\n", width, height);
  std::fwrite(pixels.data(), 1, pixels.size(), pipe_);
}

void Film::finish() {
  std::fclose(pipe_);
  pipe_ = nullptr;
  int status = 0;
  waitpid(encoder_, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(file_ + ": ffmpeg could not write it; its message is above");
}

}  // namespace glark::tool
