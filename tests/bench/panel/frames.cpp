// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program with a window that draws the same small scene again and again. It prints the time of a frame in
// milliseconds: the median, the least, and the time of all processors together; then 1 if the panel is on the
// screen, otherwise 0. glark-bench runs it without glark, with the panel closed, and with the panel open.
//   glark-bench-frames WIDTH HEIGHT FRAMES
#include <SDL.h>
#include <SDL_opengl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#define GL(name) gl##name
#include "tests/clients/scene/scene_fixed.h"

namespace {

constexpr int first_frames = 20;  // programs are compiled, meshes are kept

struct Window {
  int width = 0;
  int height = 0;
  SDL_Window* window = nullptr;

  bool open() {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    window = SDL_CreateWindow("glark-bench-frames", 0, 0, width, height, SDL_WINDOW_OPENGL);
    if (window == nullptr || SDL_GL_CreateContext(window) == nullptr) return false;
    SDL_GL_SetSwapInterval(0);
    scene_setup();
    glViewport(width - 300, 0, 300, 300);
    return true;
  }

  void frame() const {
    scene_draw();
    SDL_GL_SwapWindow(window);
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    }
  }

  // The scene leaves the upper left corner empty; the panel does not. llvmpipe keeps the back buffer when it is shown.
  bool shows_panel() const {
    std::array<unsigned char, 4> empty{};
    std::array<unsigned char, 4> corner{};
    glReadPixels(width / 2, height - 50, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, empty.data());
    glReadPixels(50, height - 50, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, corner.data());
    return empty != corner;
  }
};

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void measure(const Window& window, int frames) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  const double begin_processor = processor_ms();
  for (int i = 0; i < frames; ++i) {
    const auto begin = Clock::now();
    window.frame();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  const double processor = (processor_ms() - begin_processor) / frames;
  std::sort(times.begin(), times.end());
  std::printf("%.4f %.4f %.4f %d\n", times[times.size() / 2], times.front(), processor, window.shows_panel() ? 1 : 0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  Window window{std::atoi(argv[1]), std::atoi(argv[2])};
  const int frames = std::atoi(argv[3]);
  if (!window.open() || frames < 1) {
    std::fprintf(stderr, "glark-bench-frames: no window with OpenGL: %s\n", SDL_GetError());
    return 1;
  }
  for (int i = 0; i < first_frames; ++i) window.frame();
  measure(window, frames);
  SDL_Quit();
  return 0;
}
