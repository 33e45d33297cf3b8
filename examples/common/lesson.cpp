// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#define GL_GLEXT_PROTOTYPES
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <getopt.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "examples/common/frame.h"
#include "examples/common/look.h"

namespace lesson {
namespace {

void print_help(const char* program, const Lesson& lesson) {
  const char* const name = std::strrchr(program, '/') == nullptr ? program : std::strrchr(program, '/') + 1;
  std::printf(
      "%s: %s\n\n  %s                 opens a window\n  %s --png FILE      writes a picture (--png may be left out)\n",
      name, lesson.title, name, name);
  std::printf("  --size 640x480     of the window or the picture\n  --press KEYS       presses these keys first\n");
  std::printf("  --seconds T        the time that the picture shows\n");
  std::printf("  --frames N         draws N frames; the picture shows the last one\n\nKeys:\n");
  for (const Key& key : lesson.keys) std::printf("  %c  %s\n", key.key, key.help);
  std::printf("  h  these lines (in the window)\n  q  quit (in the window)\n");
}

// Returns false for --help and for wrong arguments, with the exit status.
bool read_arguments(int argc, char** argv, const Lesson& lesson, Arguments& arguments, int& status) {
  static const option options[] = {{"png", required_argument, nullptr, 'p'},
                                   {"size", required_argument, nullptr, 's'},
                                   {"press", required_argument, nullptr, 'k'},
                                   {"seconds", required_argument, nullptr, 't'},
                                   {"frames", required_argument, nullptr, 'f'},
                                   {"help", no_argument, nullptr, 'h'},
                                   {nullptr, 0, nullptr, 0}};
  bool valid = true;
  for (int found = 0; (found = getopt_long(argc, argv, "h", options, nullptr)) != -1;) {
    if (found == 'p') arguments.picture = optarg;
    char rest = 0;
    if (found == 's') valid = valid && std::sscanf(optarg, "%dx%d%c", &arguments.width, &arguments.height, &rest) == 2;
    if (found == 'k') arguments.keys = optarg;
    if (found == 't') valid = valid && std::sscanf(optarg, "%lf%c", &arguments.seconds, &rest) == 1;
    if (found == 'f') valid = valid && std::sscanf(optarg, "%d%c", &arguments.frames, &rest) == 1;
    if (found == 'h') print_help(argv[0], lesson);
    if (found == 'h' || found == '?') {
      status = found == 'h' ? 0 : 2;
      return false;
    }
  }
  if (optind + 1 == argc && arguments.picture.empty()) arguments.picture = argv[optind++];
  valid = valid && std::isfinite(arguments.seconds) && optind == argc && arguments.width > 0 && arguments.height > 0 &&
          arguments.frames > 0;
  if (!valid) std::fprintf(stderr, "%s: wrong arguments; --help shows the right ones\n", argv[0]);
  status = valid ? 0 : 2;
  return valid;
}

}  // namespace

View& view() {
  static View view;
  return view;
}

bool& silent() {
  static bool silent = false;
  return silent;
}

void draw_frame(const Lesson& lesson, int width, int height, double seconds) {
  view().width = width;
  view().height = height;
  use_part(0, 1);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  lesson.draw(seconds);
}

bool press(const Lesson& lesson, char name) {
  const auto key = std::find_if(lesson.keys.begin(), lesson.keys.end(), [&](const Key& k) { return k.key == name; });
  if (key != lesson.keys.end()) key->press();
  return key != lesson.keys.end();
}

void press_all(const Lesson& lesson, const std::string& names) {
  for (const char name : names)
    if (!press(lesson, name)) throw std::runtime_error(std::string("there is no key ") + name + "; --help lists them");
}

void say(const char* format, ...) {
  char line[256];
  va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof(line), format, values);
  va_end(values);
  say(std::string(line));
}

unsigned count_triangles(const std::function<void()>& draw) {
  GLuint query = 0;
  GLuint count = 0;
  glGenQueries(1, &query);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glDisable(GL_RASTERIZER_DISCARD);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

std::string triangles_as_text(const std::function<void()>& draw) {
  const unsigned count = count_triangles(draw);
  return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
}

int run(int argc, char** argv, const Lesson& lesson) try {
  Arguments arguments{"", lesson.width, lesson.height, "", 0, 1};
  int status = 0;
  if (!read_arguments(argc, argv, lesson, arguments, status)) return status;
  return arguments.picture.empty() ? show_window(lesson, arguments) : write_picture(lesson, arguments);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
  return 1;
}

}  // namespace lesson
