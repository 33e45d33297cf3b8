// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The main function of the clients with a GLX window. A client defines GLX(name), find_functions() and a scene before
// it includes this file. GLX(name) stands for the function glXname, however the client found it. find_functions() is
// called before the first use of GLX.
#pragma once

#include <string.h>

static Window open_window(Display* display, const XVisualInfo* visual) {
  XSetWindowAttributes attributes;
  memset(&attributes, 0, sizeof attributes);
  const Window root = RootWindow(display, visual->screen);
  attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const Window window = XCreateWindow(display, root, 0, 0, picture_size, picture_size, 0, visual->depth, InputOutput,
                                      visual->visual, CWColormap | CWBorderPixel, &attributes);
  XMapWindow(display, window);
  XSync(display, False);
  return window;
}

int main(int argc, char** argv) {
  static unsigned char pixels[4 * picture_size * picture_size];
  const int frames = frame_count(argc, argv);
  find_functions();
  Display* display = XOpenDisplay(NULL);
  require(display != NULL, "no display");
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, None};
  XVisualInfo* visual = GLX(ChooseVisual)(display, DefaultScreen(display), wanted);
  require(visual != NULL, "no visual");
  const Window window = open_window(display, visual);
  const GLXContext context = GLX(CreateContext)(display, visual, NULL, True);
  require(context && GLX(MakeCurrent)(display, window, context), "no GLX context");
#ifdef GLX_CLIENT_AFTER_CURRENT
  GLX_CLIENT_AFTER_CURRENT
#endif
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) {
    scene_draw();
    if (frame == frames - 1) scene_read(pixels);
    GLX(SwapBuffers)(display, window);
  }
  GLX(MakeCurrent)(display, None, NULL);
  GLX(DestroyContext)(display, context);
  XCloseDisplay(display);
  return write_picture(argv[2], pixels);
}
