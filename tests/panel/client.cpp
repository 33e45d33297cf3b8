// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that knows nothing of glark. It draws the same picture in each frame, and writes one line to its log for
// everything that a panel over its frames could disturb: a pixel, a value that OpenGL returns, an error, a key or a
// click that it gets.
//   panel_client LOG: until the window is closed, or 'q' is pressed
#include <SDL.h>
#include <SDL_opengl.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "tests/core/support/state_snapshot.h"

#define GL(name) gl##name
#include "tests/clients/scene/scene_fixed.h"

namespace {

using glark::core::test::StateSnapshot;

constexpr int side = 720;
using Pixels = std::vector<unsigned char>;

Pixels read_pixels() {
  Pixels pixels(std::size_t{4} * side * side);
  glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

class Client {
 public:
  explicit Client(const char* log) : log_(std::fopen(log, "w")) {}

  int run() {
    if (log_ == nullptr || SDL_Init(SDL_INIT_VIDEO) != 0) return fail("no display");
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    window_ = SDL_CreateWindow("panel_client", 0, 0, side, side, SDL_WINDOW_OPENGL);
    const SDL_GLContext context = window_ != nullptr ? SDL_GL_CreateContext(window_) : nullptr;
    if (context == nullptr) return fail("no window with OpenGL");
    SDL_GL_SetSwapInterval(0);
    scene_setup();
    glViewport(0, 0, side, side);
    names_ = StateSnapshot::find_names();
    say("version", reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    for (int number = 1; !done_; ++number) frame(number);
    SDL_GL_DeleteContext(context);
    SDL_DestroyWindow(window_);
    SDL_Quit();
    say("end", "");
    return 0;
  }

 private:
  int fail(const char* what) {
    std::fprintf(stderr, "%s: %s\n", what, SDL_GetError());
    return 77;
  }
  void say(const char* what, const std::string& detail) {
    std::fprintf(log_, "%s %s\n", what, detail.c_str());
    std::fflush(log_);
  }

  void frame(int number) {
    scene_draw();
    const Pixels pixels = read_pixels();
    if (picture_ != pixels) say(picture_.empty() ? "picture" : "picture changes", std::to_string(number));
    picture_ = pixels;
    const StateSnapshot before = StateSnapshot::take(names_);
    SDL_GL_SwapWindow(window_);
    const std::string difference = StateSnapshot::take(names_).difference(before);
    if (!difference.empty()) say("state changes", difference);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) say("error", std::to_string(error));
    say("frame", std::to_string(number));
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) follow(event);
    SDL_Delay(10);
  }

  void follow(const SDL_Event& event) {
    if (event.type == SDL_QUIT) done_ = true;
    if (event.type == SDL_KEYDOWN) {
      say("key", SDL_GetKeyName(event.key.keysym.sym));
      done_ = done_ || event.key.keysym.sym == SDLK_q;
    }
    if (event.type == SDL_MOUSEBUTTONDOWN)
      say("click", std::to_string(event.button.x) + " " + std::to_string(event.button.y));
  }

  std::FILE* log_;
  SDL_Window* window_ = nullptr;
  StateSnapshot::Names names_;
  Pixels picture_;
  bool done_ = false;
};

}  // namespace

int main(int argc, char** argv) { return argc == 2 ? Client(argv[1]).run() : 2; }
