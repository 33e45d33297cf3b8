// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/recorder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <string>

#include "glark/core/report/log.h"
#include "shim/contexts/contexts.h"
#include "shim/frames/encoder.h"
#include "shim/frames/read_frame.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

using Clock = std::chrono::steady_clock;

// At most 30 pictures a second, because the program waits for the encoder.
constexpr auto shortest_interval = std::chrono::milliseconds(33);

// The film shows the window that ends a frame first.
struct Recording {
  std::mutex mutex;
  bool tried = false;
  pid_t process = 0;
  void* drawable = nullptr;
  Clock::time_point last_picture;
  Encoder encoder;
};

// Never destroyed, because drivers may draw from their exit handlers.
Recording& recording() {
  static Recording& instance = *new Recording;
  return instance;
}

void complain(const std::string& reason) {
  core::log(core::LogLevel::error, fmt::format("the film {} cannot be recorded: {}", options().record_file, reason));
}

void start(Recording& film, Size size) {
  film.tried = true;
  film.process = getpid();
  film.drawable = current_surface().drawable;
  std::string problem;
  film.encoder = Encoder::start(options().record_file, size, problem);
  if (!problem.empty()) complain(problem);
}

__attribute__((destructor)) void finish_at_exit() {
  Recording& film = recording();
  if (film.process == getpid()) film.encoder.finish();
}

}  // namespace

void record_frame(core::Context& context) {
  if (options().record_file.empty()) return;
  const Size size = current_size();
  Recording& film = recording();
  const std::lock_guard lock(film.mutex);
  if (size.width <= 0 || size.height <= 0) return;
  if (!film.tried) start(film, size);
  if (!film.encoder.running() || film.process != getpid() || film.drawable != current_surface().drawable) return;
  const Clock::time_point now = Clock::now();
  if (now - film.last_picture < shortest_interval) return;
  film.last_picture = now;
  if (!film.encoder.add(read_frame(context, size), size)) complain("ffmpeg has ended; its messages are above");
}

}  // namespace glark::shim
