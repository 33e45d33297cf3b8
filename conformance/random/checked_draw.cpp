// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/checked_draw.h"

#include <fmt/core.h>

#include <cmath>

#include "conformance/random/left_state.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr int most_difference = 6;
constexpr int most_edge_pixels = 120;  // of 16384: rounding along the edges of triangles, which may overlap

std::vector<GLenum> errors_now() {
  std::vector<GLenum> errors;
  for (GLenum error = gl.GetError(); error != GL_NO_ERROR && errors.size() < 8; error = gl.GetError())
    errors.push_back(error);
  return errors;
}

struct Drawn {
  Picture picture;
  std::vector<GLenum> errors;
  LeftState state;
};

class CheckedDraw {
 public:
  CheckedDraw(World& w, const RandomStep& step) : w_(w), step_(step), choice_(step.seed) {
    reads_state_ = choice_.coin();
    counts_ = choice_.coin();
  }

  std::optional<WrongDraw> run() {
    const bool is_refined_first = choice_.coin();
    // A list or a primitive leaves values that the next one begins with.
    if (w_.is_fixed())
      for (int i = 0; i < 2; ++i) draw(false);
    errors_now();
    Drawn plain;
    if (!is_refined_first) plain = drawn(false);
    std::vector<Drawn> refined;
    for (int i = 0; i < step_.times; ++i) refined.push_back(drawn(true));
    if (is_refined_first) plain = drawn(false);
    for (std::size_t i = 0; i < refined.size(); ++i)
      if (const auto wrong = difference(refined[i], plain))
        return WrongDraw{fmt::format("{}, draw {}: {}", step_.path->name, i + 1, *wrong), refined[i].picture,
                         plain.picture};
    if (const auto wrong = counted()) return WrongDraw{fmt::format("{}: {}", step_.path->name, *wrong)};
    gl.Enable(GL_ARK);
    errors_now();
    return {};
  }

 private:
  void draw(bool is_refined) {
    if (is_refined)
      gl.Enable(GL_ARK);
    else
      gl.Disable(GL_ARK);
    w_.values = Values(step_.seed + 1);
    step_.path->draw(w_);
  }

  Drawn drawn(bool is_refined) {
    Drawn result;
    prepare_surface();
    draw(is_refined);
    result.errors = errors_now();
    if (reads_state_) result.state = left_state(w_);
    result.picture = read_picture(surface_size, surface_size);
    return result;
  }

  // Makes the surface black, whatever masks and tests are set. Not by ClearBufferfv: without refinement, too, Mesa 22.3
  // leaves the surface of a core context by EGL as it is.
  static void prepare_surface() {
    GLfloat colour[4] = {};
    GLboolean mask[4] = {};
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, colour);
    gl.GetBooleanv(GL_COLOR_WRITEMASK, mask);
    const bool scissor = gl.IsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
    const bool discard = gl.IsEnabled(GL_RASTERIZER_DISCARD) == GL_TRUE;
    if (scissor) gl.Disable(GL_SCISSOR_TEST);
    if (discard) gl.Disable(GL_RASTERIZER_DISCARD);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.ClearColor(colour[0], colour[1], colour[2], colour[3]);
    gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
    if (scissor) gl.Enable(GL_SCISSOR_TEST);
    if (discard) gl.Enable(GL_RASTERIZER_DISCARD);
  }

  std::optional<std::string> difference(const Drawn& refined, const Drawn& plain) {
    if (refined.errors != plain.errors)
      return fmt::format("the error is {}, without refinement {}", text_of(refined.errors), text_of(plain.errors));
    const int pixels = count_different(refined.picture, plain.picture, most_difference);
    if (pixels > most_edge_pixels)
      return fmt::format("{} pixels differ by more than {}, {} may", pixels, most_difference, most_edge_pixels);
    return difference_of(refined.state, plain.state);
  }

  static std::string text_of(const std::vector<GLenum>& errors) {
    return errors.empty() ? "none" : error_name(errors[0]);
  }

  // The depth of all edges, if it is the same for all and known.
  std::optional<int> known_depth() const {
    const GLint source = integer_of(GL_DEPTH_SOURCE_ARK);
    if (source == GL_UNIFORM_DEPTH_ARK) return integer_of(GL_UNIFORM_DEPTH_LEVEL_ARK);
    if (source != GL_DEPTH_TAG_ARK || integer_of(GL_GEOMORPH_ARK) != 0 || w_.is_fixed()) return {};
    const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
    const int pool = integer_of(GL_POOL_LEVEL_ARK);
    if (array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED) == GL_FALSE) {
      const float tag = current_value(attribute)[0];
      return tag > 0 ? std::min(pool, static_cast<int>(std::floor(std::min(tag, 99.0F) + 0.5F))) : 0;
    }
    if (array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING) != static_cast<GLint>(w_.places[0])) return {};
    const int tag = tag_of_type(static_cast<GLenum>(array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_TYPE)));
    return tag < 0 ? std::optional<int>() : std::min(pool, tag);
  }

  // With a known depth, a draw without an error counts 4^depth triangles for each coarse one.
  std::optional<std::string> counted() {
    if (!counts_ || integer_of(GL_REFINEMENT_ARK) == 0) return {};
    const std::optional<int> depth = known_depth();
    if (!depth || w_.is_fixed() || step_.path->counts_freely) return {};
    const GLuint coarse = generated(false);
    const GLuint refined = generated(true);
    if (refined != coarse << 2U * static_cast<unsigned>(*depth))
      return fmt::format("{} triangles are counted, not 4^{} times {}", refined, *depth, coarse);
    return {};
  }

  GLuint generated(bool is_refined) {
    GLuint query = 0;
    GLuint result = 0;
    Values how(step_.seed + 2);
    gl.GenQueries(1, &query);
    const bool is_indexed = how.coin() && gl.BeginQueryIndexed != nullptr;
    if (is_indexed)
      gl.BeginQueryIndexed(GL_PRIMITIVES_GENERATED, 0, query);
    else
      gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
    draw(is_refined);
    if (how.coin() && gl.EndQueryIndexed != nullptr)
      gl.EndQueryIndexed(GL_PRIMITIVES_GENERATED, 0);
    else
      gl.EndQuery(GL_PRIMITIVES_GENERATED);
    draw(is_refined);  // this one does not count
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
    gl.DeleteQueries(1, &query);
    return result;
  }

  World& w_;
  const RandomStep& step_;
  Values choice_;
  bool reads_state_ = false;
  bool counts_ = false;
};

}  // namespace

std::optional<WrongDraw> checked_draw(World& w, const RandomStep& step) { return CheckedDraw(w, step).run(); }

std::optional<WrongDraw> run(Test& t, const RandomSequence& sequence) {
  const std::unique_ptr<Context> own = t.create_context();
  std::optional<WrongDraw> wrong;
  {
    World world(t, sequence.kind);
    for (const RandomStep& step : sequence.steps) {
      world.values = Values(step.seed);
      if (step.row != nullptr)
        step.row->make(world);
      else
        wrong = checked_draw(world, step);
      errors_now();  // one row may have deleted what another one uses
      if (wrong) break;
    }
  }
  own->release_current();
  t.context().make_current();
  return wrong;
}

}  // namespace glark::conformance
