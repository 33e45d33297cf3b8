// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a case has in its hands while it runs.
#pragma once

#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
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
  // Of the context: 43 for OpenGL 4.3, 32 for OpenGL ES 3.2.
  int version() const;
  bool has_extension(std::string_view name) const;
  // Another context, current in this thread from the beginning; throws what ends the case as an internal error.
  std::unique_ptr<Context> create_context(Context* share = nullptr);
  // The one that the case began with.
  Context& context() { return *context_; }

  // Notes a failure unless `holds`, and goes on. `what` says what should have been.
  bool expect(bool holds, std::string_view what);
  template <typename A, typename B>
  bool expect_equal(const A& actual, const B& expected, std::string_view what);
  // |actual - expected| <= tolerance; NaN is never near.
  bool expect_near(double actual, double expected, double tolerance, std::string_view what);
  // Takes one error off the GL; GL_NO_ERROR is no error.
  bool expect_error(GLenum expected, std::string_view what);
  bool expect_no_error(std::string_view what) { return expect_error(GL_NO_ERROR, what); }
  // A failure keeps both, and their difference. At most `allowed` pixels may differ by more than `tolerance` in a channel.
  bool expect_same_picture(const Picture& actual, const Picture& expected, std::string_view what, int tolerance = 0,
                           int allowed = 0);
  // Ends the case unless `holds`: nothing after it makes sense.
  void require(bool holds, std::string_view what);
  void fail(std::string_view what) { expect(false, what); }

  // These end the case.
  [[noreturn]] void not_supported(std::string_view why);
  [[noreturn]] void internal_error(std::string_view why);

  void quality_warning(std::string_view why);
  void log(std::string_view text);
  void attach(std::string_view name, const Picture& picture);

  std::mt19937& random() { return random_; }
  // Uniform in [low, high].
  int random_int(int low, int high);
  float random_float(float low, float high);

  // How many expectations there were so far: a case without any has judged nothing.
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
  int expectations_ = 0;
  Verdict verdict_ = Verdict::pass;
  std::vector<std::string> messages_;
  std::vector<Image> images_;
};

std::string error_name(GLenum error);

// Runs one case in contexts of its own, control first.
struct Result {
  Verdict verdict = Verdict::missing;
  std::vector<std::string> messages;
  std::vector<Image> images;
};
Result run_case(const Case& test_case, Platform& platform, Api api, unsigned random_seed);

template <typename Value>
std::string as_text(const Value& value) {
  std::ostringstream text;
  text.precision(9);
  text << +value;
  return text.str();
}
inline std::string as_text(const std::string& value) { return '"' + value + '"'; }
inline std::string as_text(bool value) { return value ? "true" : "false"; }
inline std::string as_text(const void* value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename A, typename B>
bool Test::expect_equal(const A& actual, const B& expected, std::string_view what) {
  if (actual == static_cast<A>(expected)) return expect(true, what);
  return expect(false,
                std::string(what) + ": expected " + as_text(static_cast<A>(expected)) + ", got " + as_text(actual));
}

}  // namespace glark::conformance
