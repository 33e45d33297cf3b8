// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-bench, with OSMesa, and glark-bench-egl, with the driver of the system: compares refinement with its competitors
// and prints a table. See docs/reference/benchmarks.md.
#include <malloc.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "tests/bench/cases/case.h"
#include "tests/bench/gl.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/subject/model.h"

namespace {

constexpr const char* help = R"(usage: glark-bench [options]
Measures refined draws against the same triangles refined beforehand and against tessellation shaders, the pattern pool,
capture and binning, calls that are passed through, and subdivision surfaces (QAS). Prints a table; 'short' is a target that is missed.

  --filter TEXT  only cases whose name contains TEXT; several times: one of the texts
  --list         the names of the cases
  --quick        fewer rounds
  --thorough     more rounds
  --json FILE    also writes the figures to FILE
  --csv FILE     the same as lines of measure,quantity,value
  --models DIR   PLY files (decompressed) for the figures that are about models
  --help         this text

Exit status: 0 measured, whatever the figures say; 1 something could not be measured; 2 wrong usage.
)";

struct Options {
  std::vector<std::string> filters;
  std::string json;
  std::string csv;
  bool list = false;
  bool help = false;
  glark::bench::Effort effort;
};

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--filter" && has_value) {
      options.filters.emplace_back(argv[++i]);
    } else if (word == "--json" && has_value) {
      options.json = argv[++i];
    } else if (word == "--csv" && has_value) {
      options.csv = argv[++i];
    } else if (word == "--models" && has_value) {
      glark::bench::models_folder = argv[++i];
    } else if (word == "--list") {
      options.list = true;
    } else if (word == "--help") {
      options.help = true;
    } else if (word == "--quick") {
      options.effort.total_seconds = 0.2;
    } else if (word == "--thorough") {
      options.effort.total_seconds = 3;
    } else {
      std::cerr << "glark-bench: '" << word << "' is not an option, or lacks its value; see --help\n";
      return false;
    }
  }
  return true;
}

std::vector<glark::bench::Case> all_cases() {
  std::vector<glark::bench::Case> cases;
  glark::bench::add_draw_cases(cases);
  glark::bench::add_pool_cases(cases);
  glark::bench::add_capture_cases(cases);
  glark::bench::add_scene_cases(cases);
  glark::bench::add_adaptive_cases(cases);
#ifdef GLARK_BENCH_QAS
  glark::bench::add_qas_cases(cases);
  glark::bench::add_qas_draw_cases(cases);
#endif
#ifdef GLARK_BENCH_SURFEL
  glark::bench::add_surfel_cases(cases);
#endif
  glark::bench::add_shape_cases(cases);
  glark::bench::add_figure_cases(cases);
  glark::bench::add_screen_error_cases(cases);
  glark::bench::add_weld_cases(cases);
#ifndef GLARK_BENCH_EGL  // these run programs that use OSMesa, or an X server
  glark::bench::add_call_cases(cases);
#ifdef GLARK_BENCH_PANEL
  glark::bench::add_panel_cases(cases);
#endif
#endif
  return cases;
}

// llvmpipe allocates its vertices again for every draw. Without this setting, page faults would take most of the time.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the greatest value that glibc accepts
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 64 << 20);
}

// Draws by pointers use the default vertex array. Their buffers are gone, and some drivers read every enabled array.
void disable_default_arrays() {
  glBindVertexArray(0);
  GLint inputs = 0;
  glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &inputs);
  for (GLint input = 0; input < inputs; ++input) glDisableVertexAttribArray(static_cast<GLuint>(input));
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) glDisableClientState(array);
}

// Every case begins with an empty vertex array and no program, so that it does not read arrays of an earlier case.
void run_case(const glark::bench::Case& one, glark::bench::Report& report, const glark::bench::Effort& effort) {
  disable_default_arrays();
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glUseProgram(0);
  glDisable(GL_ARK);
  try {
    one.run(report, effort);
  } catch (const std::exception& exception) {
    report.add_error(exception.what());
  }
  glDeleteVertexArrays(1, &array);
}

int measure(const std::vector<glark::bench::Case>& cases, const Options& options) {
  const glark::bench::Offscreen offscreen;
  if (!offscreen.ready()) {
    std::cerr << "glark-bench: the driver gives no context\n";
    return 1;
  }
  glark::bench::Report report;
  for (const auto& one : cases) {
    run_case(one, report, options.effort);
  }
  std::cout << glark::bench::machine() << "\n\n" << report.table() << std::flush;
  if (!options.json.empty() && !report.write_json(options.json)) {
    std::cerr << "glark-bench: cannot write " << options.json << '\n';
    return 1;
  }
  if (!options.csv.empty() && !report.write_csv(options.csv)) {
    std::cerr << "glark-bench: cannot write " << options.csv << '\n';
    return 1;
  }
  return report.has_errors() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) return 2;
  if (options.help) {
    std::cout << help;
    return 0;
  }
  std::vector<glark::bench::Case> cases = all_cases();
  if (!options.filters.empty()) {
    std::erase_if(cases, [&](const auto& one) {
      return std::ranges::none_of(options.filters,
                                  [&](const auto& text) { return one.name.find(text) != std::string::npos; });
    });
  }
  if (options.list) {
    for (const auto& one : cases) std::cout << one.name << '\n';
    return 0;
  }
  if (cases.empty()) {
    std::cerr << "glark-bench: no case contains the text of --filter; see --list\n";
    return 2;
  }
  keep_freed_memory();
  return measure(cases, options);
}
