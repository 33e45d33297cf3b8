// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/show/show.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "conformance/gl/observer.h"
#include "conformance/show/call.h"
#include "conformance/suite/test.h"

namespace glark::conformance {
namespace {

GladGLContext real;  // the functions that make the calls

#include "conformance/shown_commands.inc"

std::string_view find_name(std::string_view group, std::uint32_t value) {
  const auto is_before = [](const NamedValue& a, const NamedValue& b) {
    return a.group != b.group ? a.group < b.group : a.value < b.value;
  };
  const NamedValue wanted{group, value, ""};
  const auto* const found = std::lower_bound(std::begin(named_values), std::end(named_values), wanted, is_before);
  return found != std::end(named_values) && !is_before(wanted, *found) ? found->name : "";
}

class Notes final : public Observer {
 public:
  Notes() {
    call_sink = {&program_, &real, find_name};
    observer = this;
  }
  ~Notes() override { observer = nullptr; }

  void loaded(GladGLContext& functions) override {
    real = functions;
    note_calls(functions);
    if (is_begun_) program_.add("// another context is current");
    is_begun_ = true;
  }
  void expects(std::string_view what) override {
    std::string text(what);
    std::replace(text.begin(), text.end(), '\n', ' ');
    program_.add("// checked: " + text);
  }
  void begins_again() override {
    program_.clear();
    is_begun_ = false;
  }
  std::string text(std::string_view head) const { return program_.text(head); }

 private:
  CProgram program_;
  bool is_begun_ = false;
};

std::string head_of(const Case& shown, Api api) {
  std::string head = fmt::format("// {}\n", shown.name);
  head += in_lines("Plan: " + shown.plan, "// ");
  if (!shown.wrong.empty()) head += in_lines("Wrong: " + shown.wrong, "// ");
  for (const std::string& clause : shown.clauses) head += in_lines(clause + ": " + sentence_of(clause), "// ");
  head += "//\n";
  head += in_lines(
      fmt::format(
          "The calls of the case on {}. Names of objects and locations of inputs are those of one run. What only "
          "asks OpenGL is left out.",
          name_of(api)),
      "// ");
  head += api == Api::gles ? "#include <GLES3/gl32.h>\n"
                           : "#define GL_GLEXT_PROTOTYPES\n#include <GL/gl.h>\n#include <GL/glext.h>\n";
  return head + "#include <GL/glark.h>\n#include <math.h>\n#include <stddef.h>\n\n";
}

}  // namespace

std::string show(const Case& shown, Platform& platform, Api api, unsigned random_seed) {
  const Notes notes;
  const Result result = run_case(shown, platform, api, random_seed);
  std::string text = head_of(shown, api);
  text += fmt::format("// Verdict: {}\n", name_of(result.verdict));
  for (const std::string& message : result.messages) text += in_lines(message, "// ");
  return notes.text(text + '\n');
}

}  // namespace glark::conformance
