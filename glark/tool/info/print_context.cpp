// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/info/attempt.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "glark/settings/table.h"

namespace glark::tool {
namespace {

struct Limit {
  const char* name;
  GLenum value;
  GLint needed;  // 0: the minimum of OpenGL 4.3 and OpenGL ES 3.2 is enough
};
constexpr std::array limits{
    Limit{"GL_MAX_VERTEX_ATTRIBS", GL_MAX_VERTEX_ATTRIBS, 16},
    Limit{"GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS", GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS, 64},
    Limit{"GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS", GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 4},
    Limit{"GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, 128},
    Limit{"GL_MAX_SHADER_STORAGE_BLOCK_SIZE", GL_MAX_SHADER_STORAGE_BLOCK_SIZE, 0},
};

class Report {
 public:
  Report(const char* way, Api api, GetProc get_proc) : way_(way), api_(api) {
    get_string_ = reinterpret_cast<decltype(get_string_)>(get_proc("glGetString"));
    get_integer_ = reinterpret_cast<decltype(get_integer_)>(get_proc("glGetIntegerv"));
  }

  int print() const {
    if (get_string_ == nullptr || get_integer_ == nullptr || get_string_(GL_VERSION) == nullptr) return no_context;
    std::printf("%s\n  vendor     %s\n  renderer   %s\n  version    %s\n", way_, text(GL_VENDOR), text(GL_RENDERER),
                text(GL_VERSION));
    std::vector<std::string> lacks = missing();
    if (lacks.empty()) {
      std::printf("  refinement yes: GL_ARK_adaptive_refinement\n");
    } else {
      std::printf("  refinement no; it lacks");
      for (std::size_t i = 0; i < lacks.size(); ++i) std::printf("%s %s", i == 0 ? "" : ",", lacks[i].c_str());
      std::printf("\n");
    }
    for (const Limit& limit : limits) std::printf("  %s = %d\n", limit.name, integer(limit.value));
    if (lacks.empty()) print_offer();
    return lacks.empty() ? can_refine : cannot_refine;
  }

 private:
  const char* text(GLenum name) const {
    const auto* found = get_string_(name);
    return found == nullptr ? "(unknown)" : reinterpret_cast<const char*>(found);
  }

  GLint integer(GLenum name) const {
    GLint value = 0;
    get_integer_(name, &value);
    return value;
  }

  std::vector<std::string> missing() const {
    const int version = integer(GL_MAJOR_VERSION) * 10 + integer(GL_MINOR_VERSION);
    const int needed = api_ == Api::es ? 32 : 43;
    if (version < needed) return {api_ == Api::es ? "OpenGL ES 3.2" : "OpenGL 4.3"};
    std::vector<std::string> lacks;
    for (const Limit& limit : limits)
      if (integer(limit.value) < limit.needed)
        lacks.push_back(std::string(limit.name) + " of " + std::to_string(limit.needed));
    return lacks;
  }

  // Prints what a program can use here.
  void print_offer() const {
    std::printf("  levels     0 to 11 (2048 segments an edge)\n");
    const std::string refinements(settings::find_setting("refine")->needed);
    std::printf("  refinement of unmodified programs: %s\n", refinements.c_str());
    std::printf(
        "  commands   glARKinit glDepthTag1i glDepthTagPointerARK glDrawARP glDrawARPElementsARK\n"
        "             glARKParameteriARK glARKParameterfARK glRefinementShaderSourceARK glGetRefinementivARK "
        "glGetRefinementInfoLogARK\n");
  }

  const char* way_;
  Api api_;
  const GLubyte* (*get_string_)(GLenum) = nullptr;
  void (*get_integer_)(GLenum, GLint*) = nullptr;
};

}  // namespace

int print_context(const char* way, Api api, GetProc get_proc) { return Report(way, api, get_proc).print(); }

}  // namespace glark::tool
