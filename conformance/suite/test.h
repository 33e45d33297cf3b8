// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The interface through which a running case creates contexts, checks expectations and logs.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "conformance/gl/gl.h"
#include "conformance/suite/case.h"
#include "conformance/suite/picture.h"
#include "conformance/suite/verdict.h"

namespace glark::conformance {

struct Image {
  std::string name;  // "expected", "actual", "difference", or as the case calls it
  Picture picture;
};

class Test {
 public:
  // `random_seed` and the case's name determine random().
  Test(Platform& platform, Api api, std::string_view name, unsigned random_seed);

  Api api() const { return api_; }
  bool is_compat() const { return api_ == Api::gl_compat; }
  bool is_gles() const { return api_ == Api::gles; }
  // The context's version: 43 for OpenGL 4.3, 32 for OpenGL ES 3.2.
  int version() const;
  bool has_extension(std::string_view name) const;
  // Makes another context and makes it current in this thread. An exception ends the case as an internal error.
  std::unique_ptr<Context> create_context(Context* share = nullptr);
  // The context that the case began with.
  Context& context() { return *context_; }

  // Logs a failure unless `holds`, and continues. `what` names the expectation.
  bool expect(bool holds, std::string_view what);
  template <typename A, typename B>
  bool expect_equal(const A& actual, const B& expected, std::string_view what);
  // Expects the difference, without its sign, to be at most the tolerance. NaN fails.
  bool expect_near(double actual, double expected, double tolerance, std::string_view what);
  // Takes one error from the GL; GL_NO_ERROR stands for no error.
  bool expect_error(GLenum expected, std::string_view what);
  bool expect_no_error(std::string_view what) { return expect_error(GL_NO_ERROR, what); }
  // A failure attaches both pictures and their difference. At most `allowed` pixels may differ by more than `tolerance`
  // in a channel.
  bool expect_same_picture(const Picture& actual, const Picture& expected, std::string_view what, int tolerance = 0,
                           int allowed = 0);
  // Ends the case unless `holds`: use it when nothing after it would make sense.
  void require(bool holds, std::string_view what);
  void fail(std::string_view what) { expect(false, what); }

  // These end the case. A case that calls not_supported() is marked with Case::is_optional.
  [[noreturn]] void not_supported(std::string_view why);
  [[noreturn]] void internal_error(std::string_view why);

  void quality_warning(std::string_view why);
  void log(std::string_view text);
  void attach(std::string_view name, const Picture& picture);

  std::mt19937& random() { return random_; }
  // What --seed says, without the case's name: cases that share a plan need it.
  unsigned seed() const { return seed_; }
  // Uniform in [low, high].
  int random_int(int low, int high);
  float random_float(float low, float high);

  // The number of expectations so far. A case without any has judged nothing.
  int expectations() const { return expectations_; }
  Verdict verdict() const { return verdict_; }
  const std::vector<std::string>& messages() const { return messages_; }
  const std::vector<Image>& images() const { return images_; }
  void conclude(Verdict verdict, std::string_view why);

 private:
  Platform& platform_;
  Api api_;
  std::unique_ptr<Context> context_;
  std::mt19937 random_;
  unsigned seed_;
  int expectations_ = 0;
  Verdict verdict_ = Verdict::pass;
  std::vector<std::string> messages_;
  std::vector<Image> images_;
};

std::string error_name(GLenum error);

// Runs the control and then the case, each in a context of its own.
struct Result {
  Verdict verdict = Verdict::missing;
  std::vector<std::string> messages;
  std::vector<Image> images;
};
Result run_case(const Case& test_case, Platform& platform, Api api, unsigned random_seed);

std::string as_text(long long value);
std::string as_text(unsigned long long value);
// Nine digits tell all floats apart.
std::string as_text(double value);
std::string as_text(bool value);
std::string as_text(const std::string& value);
std::string as_text(const void* value);

template <typename Number>
requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) std::string as_text(Number value) {
  const auto promoted = +value;
  if constexpr (std::is_floating_point_v<Number>)
    return as_text(double{promoted});
  else if constexpr (std::is_signed_v<decltype(promoted)>)
    return as_text(static_cast<long long>(promoted));
  else
    return as_text(static_cast<unsigned long long>(promoted));
}

template <typename A, typename B>
bool Test::expect_equal(const A& actual, const B& expected, std::string_view what) {
  if (actual == static_cast<A>(expected)) return expect(true, what);
  return expect(false,
                std::string(what) + ": expected " + as_text(static_cast<A>(expected)) + ", got " + as_text(actual));
}

}  // namespace glark::conformance
