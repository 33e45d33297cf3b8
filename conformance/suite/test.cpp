// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/suite/test.h"

#include <fmt/core.h>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "conformance/gl/observer.h"

namespace glark::conformance {
namespace {

constexpr std::size_t most_messages = 30;
constexpr std::size_t most_images = 12;

// Thrown to end a case whose verdict is set.
struct CaseEnd {};

// FNV-1a gives the same hash on every machine; std::hash need not.
unsigned hash_of(std::string_view text) {
  unsigned hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

bool has_token(const char* list, std::string_view token) {
  std::istringstream words(list != nullptr ? list : "");
  for (std::string word; words >> word;)
    if (word == token) return true;
  return false;
}

}  // namespace

std::string error_name(GLenum error) {
  switch (error) {
    case GL_NO_ERROR: return "no error";
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
    default: return fmt::format("error {}", error);
  }
}

std::string as_text(long long value) { return std::to_string(value); }
std::string as_text(unsigned long long value) { return std::to_string(value); }
std::string as_text(double value) { return fmt::format("{:.9g}", value); }
std::string as_text(bool value) { return value ? "true" : "false"; }
std::string as_text(const std::string& value) { return '"' + value + '"'; }
std::string as_text(const void* value) { return fmt::format("{}", value); }

Test::Test(Platform& platform, Api api, std::string_view name, unsigned random_seed)
    : platform_(platform),
      api_(api),
      context_(platform.create_context(api, nullptr)),
      random_(hash_of(name) ^ random_seed),
      seed_(random_seed) {
  load_functions(platform, is_gles());
}

int Test::version() const {
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  return 10 * major + minor;
}

bool Test::has_extension(std::string_view name) const {
  // Either query will do here. A case of its own checks that both have the name.
  if (api_ == Api::gl_compat && has_token(reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS)), name))
    return true;
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* const extension = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (extension != nullptr && name == reinterpret_cast<const char*>(extension)) return true;
  }
  return false;
}

std::unique_ptr<Context> Test::create_context(Context* share) { return platform_.create_context(api_, share); }

bool Test::expect(bool holds, std::string_view what) {
  ++expectations_;
  if (observer != nullptr) observer->expects(what);
  if (holds) return true;
  if (verdict_ != Verdict::internal_error) verdict_ = Verdict::fail;
  log(what);
  return false;
}

bool Test::expect_near(double actual, double expected, double tolerance, std::string_view what) {
  if (std::abs(actual - expected) <= tolerance) return expect(true, what);
  return expect(false, std::string(what) + ": expected " + as_text(expected) + " within " + as_text(tolerance) +
                           ", got " + as_text(actual));
}

bool Test::expect_error(GLenum expected, std::string_view what) {
  const GLenum error = gl.GetError();
  if (error == expected) return expect(true, what);
  return expect(false, std::string(what) + ": expected " + error_name(expected) + ", got " + error_name(error));
}

bool Test::expect_same_picture(const Picture& actual, const Picture& expected, std::string_view what, int tolerance,
                               int allowed) {
  const int different = count_different(actual, expected, tolerance);
  if (different <= allowed) return expect(true, what);
  attach("expected", expected);
  attach("actual", actual);
  attach("difference", difference_of(expected, actual, tolerance));
  return expect(false,
                fmt::format("{}: {} pixels differ by more than {}, {} may", what, different, tolerance, allowed));
}

void Test::require(bool holds, std::string_view what) {
  if (!expect(holds, what)) throw CaseEnd{};
}

void Test::not_supported(std::string_view why) {
  if (verdict_ == Verdict::pass) verdict_ = Verdict::not_supported;
  log(why);
  throw CaseEnd{};
}

void Test::internal_error(std::string_view why) {
  verdict_ = Verdict::internal_error;
  log(why);
  throw CaseEnd{};
}

void Test::quality_warning(std::string_view why) {
  ++expectations_;
  if (verdict_ == Verdict::pass) verdict_ = Verdict::quality_warning;
  log(why);
}

void Test::log(std::string_view text) {
  if (messages_.size() < most_messages) messages_.emplace_back(text);
  if (messages_.size() == most_messages) messages_.back() = "... and more";
}

void Test::attach(std::string_view name, const Picture& picture) {
  if (images_.size() < most_images) images_.push_back({std::string(name), picture});
}

int Test::random_int(int low, int high) {
  // The library's distributions give different values in different implementations.
  return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
}

float Test::random_float(float low, float high) {
  return low + (high - low) * (static_cast<float>(random_() >> 8U) / static_cast<float>((1U << 24U) - 1));
}

void Test::conclude(Verdict verdict, std::string_view why) {
  verdict_ = verdict;
  log(why);
}

namespace {

Result result_of(Test& test) { return {test.verdict(), test.messages(), test.images()}; }

// Runs one half of a case. An exception and a pending GL error count.
void run_half(Test& test, const std::function<void(Test&)>& half) {
  try {
    half(test);
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError())
      test.fail("an error is pending at the end: " + error_name(error));
  } catch (const CaseEnd&) {
    // The verdict is set.
  } catch (const std::exception& error) {
    test.conclude(Verdict::internal_error, error.what());
  }
}

// An answer of "not supported" that nobody expects would hide a failure.
void check_support(Test& test, const Case& test_case) {
  if (test.verdict() == Verdict::not_supported && !test_case.is_optional)
    test.conclude(Verdict::internal_error, "NotSupported, but the case is not marked as optional");
}

}  // namespace

Result run_case(const Case& test_case, Platform& platform, Api api, unsigned random_seed) {
  if (!test_case.check) return {Verdict::unimplemented, {"planned: " + test_case.plan}, {}};
  if (!test_case.apis.contains(api))
    return {Verdict::not_supported, {"does not concern " + std::string(name_of(api))}, {}};
  {
    Test test(platform, api, test_case.name, random_seed);
    if (!test.has_extension("GL_ARK_adaptive_refinement"))
      return {Verdict::not_supported, {"no GL_ARK_adaptive_refinement among the extensions"}, {}};
    if (gl.ARKinit == nullptr)
      return {Verdict::fail,
              {"GetStringi(EXTENSIONS) lacks the extension's name, so loaders find none of its functions"},
              {}};
    if (test_case.control) {
      run_half(test, test_case.control);
      if (test.verdict() == Verdict::fail)
        test.conclude(Verdict::internal_error, "the control failed, without refinement");
      check_support(test, test_case);
      if (test.verdict() == Verdict::internal_error || test.verdict() == Verdict::not_supported) return result_of(test);
    }
  }
  if (observer != nullptr) observer->begins_again();
  Test test(platform, api, test_case.name, random_seed);
  run_half(test, test_case.check);
  if (test.verdict() == Verdict::pass && test.expectations() == 0)
    test.conclude(Verdict::internal_error, "nothing was checked");
  check_support(test, test_case);
  return result_of(test);
}

}  // namespace glark::conformance
