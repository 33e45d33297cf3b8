// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A context by SDL 2, which loads libGL itself. Every function comes from SDL_GL_GetProcAddress.
#include <SDL.h>
#include <SDL_opengl.h>

#include "tests/clients/scene/functions.h"

static struct { SCENE_FIXED_FUNCTIONS(DECLARE_GL) } found;
#define GL(name) found.gl##name
#define FIND_GL(name) *(void**)&found.gl##name = SDL_GL_GetProcAddress("gl" #name);

#include "tests/clients/scene/scene_fixed.h"

int main(int argc, char** argv) {
  static unsigned char pixels[4 * picture_size * picture_size];
  const int frames = frame_count(argc, argv);
  require(SDL_Init(SDL_INIT_VIDEO) == 0, "SDL_Init failed");
  SDL_GL_SetAttribute(SDL_GL_RED_SIZE, 8);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_Window* window = SDL_CreateWindow("sdl2", 0, 0, picture_size, picture_size, SDL_WINDOW_OPENGL);
  require(window != NULL, "no window");
  const SDL_GLContext context = SDL_GL_CreateContext(window);
  require(context != NULL, "no context");
  SCENE_FIXED_FUNCTIONS(FIND_GL)
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) {
    scene_draw();
    if (frame == frames - 1) scene_read(pixels);
    SDL_GL_SwapWindow(window);
  }
  SDL_GL_DeleteContext(context);
  SDL_DestroyWindow(window);
  SDL_Quit();
  return write_picture(argv[2], pixels);
}
