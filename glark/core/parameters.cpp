// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace glark::core {
namespace {

using Kind = Parameter::Kind;

constexpr GLint no_limit = std::numeric_limits<GLint>::max();
constexpr float any = std::numeric_limits<float>::max();

constexpr std::array depth_source_tokens{TokenName{GL_DEPTH_TAG_ARK, "DEPTH_TAG_ARK"},
                                         TokenName{GL_UNIFORM_DEPTH_ARK, "UNIFORM_DEPTH_ARK"},
                                         TokenName{GL_MEASURED_DEPTH_ARK, "MEASURED_DEPTH_ARK"}};
constexpr std::array polygon_split_tokens{TokenName{GL_POLYGON_TRIANGLES_ARK, "POLYGON_TRIANGLES_ARK"},
                                          TokenName{GL_POLYGON_CENTROID_ARK, "POLYGON_CENTROID_ARK"}};
constexpr std::array interior_tokens{TokenName{GL_MINIMUM_INTERIOR_ARK, "MINIMUM_INTERIOR_ARK"},
                                     TokenName{GL_SMOOTH_INTERIOR_ARK, "SMOOTH_INTERIOR_ARK"}};
constexpr std::array channel_tokens{TokenName{GL_RED, "RED"}, TokenName{GL_GREEN, "GREEN"}, TokenName{GL_BLUE, "BLUE"},
                                    TokenName{GL_ALPHA, "ALPHA"}};
constexpr auto refinement_tokens = [] {
  std::array<TokenName, refinements.size()> tokens{};
  for (std::size_t i = 0; i < refinements.size(); ++i) {
    tokens[i] = {refinements[i].token, refinements[i].token_name};
  }
  return tokens;
}();

// The position of the value among the tokens, which is the enumerator's.
template <std::size_t count>
int index_of(const std::array<TokenName, count>& tokens, double value) {
  const auto token = static_cast<GLenum>(value);
  const auto found = std::find_if(tokens.begin(), tokens.end(), [&](const TokenName& t) { return t.token == token; });
  return static_cast<int>(found - tokens.begin());
}

template <std::size_t count, class Enumerator>
GLenum token_at(const std::array<TokenName, count>& tokens, Enumerator value) {
  return tokens.at(static_cast<std::size_t>(value)).token;
}

Bounds not_negative(const ParameterLimits& /*limits*/) { return {0, no_limit}; }
Bounds degrees(const ParameterLimits& /*limits*/) { return {0, 180}; }
Bounds level(const ParameterLimits& limits) { return {0, limits.level}; }
Bounds attribute(const ParameterLimits& limits) { return {limits.first_attribute, limits.attribute_count - 1}; }
Bounds attribute_or_none(const ParameterLimits& limits) {
  return {limits.first_attribute, limits.attribute_count - 1, true};
}
Bounds texture_unit_or_none(const ParameterLimits& limits) { return {0, limits.texture_unit_count - 1, true}; }

constexpr std::string_view attribute_values = "a generic vertex\nattribute index";

constexpr std::array own_parameters{
    Parameter{.name = GL_REFINEMENT_ARK,
              .text = "REFINEMENT_ARK",
              .kind = Kind::token,
              .get = [](const ArkState& s) -> double { return token_at(refinement_tokens, s.refinement); },
              .set = [](ArkState& s,
                        double value) { s.refinement = static_cast<Refinement>(index_of(refinement_tokens, value)); },
              .tokens = refinement_tokens,
              .initial = "LINEAR_INPUTS_ARK",
              .setting = "refine"},
    Parameter{
        .name = GL_DEPTH_SOURCE_ARK,
        .text = "DEPTH_SOURCE_ARK",
        .kind = Kind::token,
        .get = [](const ArkState& s) -> double { return token_at(depth_source_tokens, s.depth_source); },
        .set = [](ArkState& s,
                  double value) { s.depth_source = static_cast<DepthSource>(index_of(depth_source_tokens, value)); },
        .tokens = depth_source_tokens,
        .initial = "DEPTH_TAG_ARK"},
    Parameter{.name = GL_UNIFORM_DEPTH_LEVEL_ARK,
              .text = "UNIFORM_DEPTH_LEVEL_ARK",
              .get = [](const ArkState& s) -> double { return s.uniform_level; },
              .set = [](ArkState& s, double value) { s.uniform_level = static_cast<GLuint>(value); },
              .bounds = level,
              .initial = "0",
              .values = "0 to POOL_LEVEL_ARK",
              .setting = "level"},
    Parameter{.name = GL_DEPTH_TAG_ATTRIBUTE_ARK,
              .text = "DEPTH_TAG_ATTRIBUTE_ARK",
              .get = [](const ArkState& s) -> double { return s.tag_attribute; },
              .set = [](ArkState& s, double value) { s.tag_attribute = static_cast<GLuint>(value); },
              .bounds = attribute,
              .initial = "MAX_VERTEX_ATTRIBS - 1",
              .values = attribute_values},
    Parameter{
        .name = GL_POLYGON_SPLIT_ARK,
        .text = "POLYGON_SPLIT_ARK",
        .kind = Kind::token,
        .get = [](const ArkState& s) -> double { return token_at(polygon_split_tokens, s.polygon_split); },
        .set = [](ArkState& s,
                  double value) { s.polygon_split = static_cast<PolygonSplit>(index_of(polygon_split_tokens, value)); },
        .tokens = polygon_split_tokens,
        .initial = "POLYGON_TRIANGLES_ARK",
        .setting = "polygons"},
    Parameter{.name = GL_PATTERN_INTERIOR_ARK,
              .text = "PATTERN_INTERIOR_ARK",
              .kind = Kind::token,
              .get = [](const ArkState& s) -> double { return token_at(interior_tokens, s.smooth_interior); },
              .set = [](ArkState& s, double value) { s.smooth_interior = index_of(interior_tokens, value) == 1; },
              .tokens = interior_tokens,
              .initial = "MINIMUM_INTERIOR_ARK"},
    Parameter{.name = GL_EDGE_PIXELS_ARK,
              .text = "EDGE_PIXELS_ARK",
              .get = [](const ArkState& s) -> double { return s.edge_pixels; },
              .set =
                  [](ArkState& s, double value) {
                    s.measure.pixels = static_cast<float>(value);
                    s.edge_pixels = static_cast<GLint>(value);
                  },
              .bounds = not_negative,
              .initial = "8",
              .values = "0 or more",
              .setting = "edge-pixels"},
    Parameter{.name = GL_EDGE_DEGREES_ARK,
              .text = "EDGE_DEGREES_ARK",
              .get = [](const ArkState& s) -> double { return s.measure.degrees; },
              .set = [](ArkState& s, double value) { s.measure.degrees = static_cast<float>(value); },
              .bounds = degrees,
              .initial = "0",
              .values = "0 to 180",
              .setting = "curvature"},
    Parameter{.name = GL_SCREEN_ERROR_ARK,
              .text = "SCREEN_ERROR_ARK",
              .kind = Kind::number,
              .get = [](const ArkState& s) -> double { return s.measure.error; },
              .set = [](ArkState& s, double value) { s.measure.error = static_cast<float>(value); },
              .least = 0,
              .most = any,
              .initial = "0",
              .values = "0 or more",
              .setting = "screen-error"},
    Parameter{.name = GL_TRIANGLE_BUDGET_ARK,
              .text = "TRIANGLE_BUDGET_ARK",
              .get = [](const ArkState& s) -> double { return s.measure.budget; },
              .set = [](ArkState& s, double value) { s.measure.budget = static_cast<unsigned>(value); },
              .bounds = not_negative,
              .initial = "0",
              .values = "0 or more",
              .setting = "budget"},
    Parameter{.name = GL_DISCONTINUITY_ATTRIBUTE_ARK,
              .text = "DISCONTINUITY_ATTRIBUTE_ARK",
              .get = [](const ArkState& s) -> double { return s.discontinuity_attribute; },
              .set = [](ArkState& s, double value) { s.discontinuity_attribute = static_cast<GLuint>(value); },
              .bounds = attribute,
              .initial = "MAX_VERTEX_ATTRIBS - 2",
              .values = attribute_values},
    Parameter{.name = GL_SCALAR_TAG_ATTRIBUTE_ARK,
              .text = "SCALAR_TAG_ATTRIBUTE_ARK",
              .get = [](const ArkState& s) -> double { return s.scalar_tag_attribute; },
              .set = [](ArkState& s, double value) { s.scalar_tag_attribute = static_cast<GLuint>(value); },
              .bounds = attribute,
              .initial = "MAX_VERTEX_ATTRIBS - 3",
              .values = attribute_values},
    Parameter{.name = GL_DISPLACEMENT_UNIT_ARK,
              .text = "DISPLACEMENT_UNIT_ARK",
              .get = [](const ArkState& s) -> double { return s.displacement.unit; },
              .set = [](ArkState& s, double value) { s.displacement.unit = static_cast<int>(value); },
              .bounds = texture_unit_or_none,
              .initial = "-1",
              .values = "-1 or a texture image\nunit"},
    Parameter{
        .name = GL_DISPLACEMENT_CHANNEL_ARK,
        .text = "DISPLACEMENT_CHANNEL_ARK",
        .kind = Kind::token,
        .get = [](const ArkState& s) -> double { return token_at(channel_tokens, s.displacement.channel); },
        .set = [](ArkState& s,
                  double value) { s.displacement.channel = static_cast<unsigned>(index_of(channel_tokens, value)); },
        .tokens = channel_tokens,
        .initial = "RED",
        .values = "RED, GREEN, BLUE, ALPHA"},
    Parameter{.name = GL_DISPLACEMENT_COORDINATE_ARK,
              .text = "DISPLACEMENT_COORDINATE_ARK",
              .get = [](const ArkState& s) -> double { return s.displacement.coordinate; },
              .set = [](ArkState& s, double value) { s.displacement.coordinate = static_cast<int>(value); },
              .bounds = attribute_or_none,
              .initial = "-1",
              .values = "-1 or a generic vertex\nattribute index"},
    Parameter{.name = GL_DISPLACEMENT_SCALE_ARK,
              .text = "DISPLACEMENT_SCALE_ARK",
              .kind = Kind::number,
              .get = [](const ArkState& s) -> double { return s.displacement.scale; },
              .set = [](ArkState& s, double value) { s.displacement.scale = static_cast<float>(value); },
              .least = -any,
              .most = any,
              .initial = "1",
              .values = "a number"},
    Parameter{.name = GL_DISPLACEMENT_BIAS_ARK,
              .text = "DISPLACEMENT_BIAS_ARK",
              .kind = Kind::number,
              .get = [](const ArkState& s) -> double { return s.displacement.bias; },
              .set = [](ArkState& s, double value) { s.displacement.bias = static_cast<float>(value); },
              .least = -any,
              .most = any,
              .initial = "0",
              .values = "a number"},
    Parameter{.name = GL_GEOMORPH_ARK,
              .text = "GEOMORPH_ARK",
              .kind = Kind::boolean,
              .get = [](const ArkState& s) -> double { return s.geomorph ? 1 : 0; },
              .set = [](ArkState& s, double value) { s.geomorph = value != 0; },
              .initial = "FALSE",
              .values = "FALSE, TRUE",
              .setting = "geomorph"},
    Parameter{.name = GL_WELD_ARK,
              .text = "WELD_ARK",
              .kind = Kind::boolean,
              .get = [](const ArkState& s) -> double { return s.weld ? 1 : 0; },
              .set = [](ArkState& s, double value) { s.weld = value != 0; },
              .initial = "FALSE",
              .values = "FALSE, TRUE",
              .setting = "no-weld"},
};

template <std::size_t refinement>
Parameter parameter_of_shape_number() {
  const ShapeNumber& number = refinements[refinement].number;
  return {.name = number.token,
          .text = number.token_name,
          .kind = Kind::number,
          .get = [](const ArkState& s) -> double { return s.shape_numbers[refinement]; },
          .set = [](ArkState& s, double value) { s.shape_numbers[refinement] = static_cast<float>(value); },
          .least = number.least,
          .most = number.most,
          .initial = number.initial_text,
          .values = number.values,
          .setting = number.key};
}

// The rows above, and one for each refinement with a number that programs can set.
struct Table {
  std::array<Parameter, own_parameters.size() + refinements.size()> rows{};
  std::size_t count = own_parameters.size();

  template <std::size_t... refinement>
  explicit Table(std::index_sequence<refinement...> /*all*/) {
    std::copy(own_parameters.begin(), own_parameters.end(), rows.begin());
    (add(parameter_of_shape_number<refinement>()), ...);
  }
  void add(const Parameter& parameter) {
    if (parameter.name != 0) {
      rows[count++] = parameter;
    }
  }
};

bool is_among(std::span<const TokenName> tokens, GLint value) {
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const TokenName& token) { return token.token == static_cast<GLenum>(value); });
}

bool is_within(const Bounds& bounds, GLint value) {
  return (value >= bounds.least && value <= bounds.most) || (bounds.or_minus_one && value == -1);
}

}  // namespace

std::span<const Parameter> parameters() {
  static const Table table(std::make_index_sequence<refinements.size()>{});
  return std::span(table.rows).first(table.count);
}

const Parameter* find_parameter(GLenum name) {
  const std::span<const Parameter> all = parameters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == name; });
  return found != all.end() ? &*found : nullptr;
}

namespace {

// A measure that gets another value, and the old one again, is a change.
void set(const Parameter& parameter, double value, ArkState& state) {
  const EdgeMeasure before = state.measure;
  parameter.set(state, value);
  state.measure.changes += state.measure == before ? 0 : 1;
}

}  // namespace

GLenum set_integer(const Parameter& parameter, const ParameterLimits& limits, GLint value, ArkState& state) {
  switch (parameter.kind) {
    case Kind::token:
      if (!is_among(parameter.tokens, value)) {
        return GL_INVALID_ENUM;
      }
      break;
    case Kind::boolean:
      if (value != GL_FALSE && value != GL_TRUE) {
        return GL_INVALID_VALUE;
      }
      break;
    case Kind::whole:
      if (!is_within(parameter.bounds(limits), value)) {
        return GL_INVALID_VALUE;
      }
      break;
    case Kind::number: return set_number(parameter, static_cast<GLfloat>(value), state);
  }
  set(parameter, value, state);
  return GL_NO_ERROR;
}

GLenum set_number(const Parameter& parameter, GLfloat value, ArkState& state) {
  if (parameter.kind != Kind::number) {
    return GL_INVALID_ENUM;
  }
  if (!std::isfinite(value) || value < parameter.least || value > parameter.most) {
    return GL_INVALID_VALUE;
  }
  set(parameter, static_cast<double>(value), state);
  return GL_NO_ERROR;
}

}  // namespace glark::core
