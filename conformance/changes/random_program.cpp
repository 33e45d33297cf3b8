// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/random_program.h"

#include <fmt/core.h>

#include <algorithm>

#include "conformance/changes/paths.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

// Not a distribution of the library: these differ from implementation to implementation.
std::size_t below(std::mt19937& random, std::size_t bound) { return random() % bound; }

bool is_there(const Change& change, Api api, int version) {
  return change.apis.contains(api) && (api == Api::gles || version >= change.version);
}

// The draws of a program are few and repeat, because only then is there something to keep.
std::vector<Combination> few_draws(std::mt19937& random, Api api) {
  std::vector<Combination> few;
  while (few.size() < 3) {
    Combination one;
    one.path = below(random, paths().size());
    one.refinement = below(random, refinement_count);
    one.depths = static_cast<Depths>(below(random, depths_names.size()));
    one.history = 1 + static_cast<int>(below(random, 4));
    if (paths()[one.path].apis.contains(api)) few.push_back(one);
  }
  return few;
}

GLint parameter_of(GLuint buffer, GLenum name) {
  GLint before = 0;
  gl.GetIntegerv(GL_COPY_READ_BUFFER_BINDING, &before);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  GLint value = 0;
  gl.GetBufferParameteriv(GL_COPY_READ_BUFFER, name, &value);
  gl.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(before));
  return value;
}

// Returns whether a draw may read so many bytes of a buffer: it has them, and the application does not write to it.
bool is_readable(GLint buffer, long long bytes) {
  const auto name = static_cast<GLuint>(buffer);
  return buffer != 0 && parameter_of(name, GL_BUFFER_SIZE) >= bytes && parameter_of(name, GL_BUFFER_MAPPED) == GL_FALSE;
}

GLint attribute(GLuint index, GLenum name) {
  GLint value = 0;
  gl.GetVertexAttribiv(index, name, &value);
  return value;
}

bool is_array_readable(GLuint index, GLsizei vertices) {
  if (attribute(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED) == GL_FALSE) return true;
  GLint64 first = 0;
  GLint buffer = 0;
  const auto binding = static_cast<GLuint>(attribute(index, GL_VERTEX_ATTRIB_BINDING));
  gl.GetIntegeri_v(GL_VERTEX_BINDING_BUFFER, binding, &buffer);
  gl.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, binding, &first);
  GLint stride = 0;
  gl.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, binding, &stride);
  const long long begin = first + attribute(index, GL_VERTEX_ATTRIB_RELATIVE_OFFSET);
  return is_readable(buffer, begin + static_cast<long long>(stride) * (vertices - 1) + 4);
}

bool is_block_readable(GLuint program) {
  const GLuint block = gl.GetUniformBlockIndex(program, "Block");
  if (block == GL_INVALID_INDEX) return true;
  GLint point = 0;
  GLint buffer = 0;
  GLint64 first = 0;
  gl.GetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &point);
  gl.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, static_cast<GLuint>(point), &buffer);
  gl.GetInteger64i_v(GL_UNIFORM_BUFFER_START, static_cast<GLuint>(point), &first);
  return is_readable(buffer, first + 16);
}

// Returns whether all reads of a draw are defined. After some sequences of changes, an array is longer than its buffer, a
// uniform block lies behind the end of its buffer, or a buffer is mapped.
bool is_defined(const Scene& scene) {
  if (!is_block_readable(scene.program)) return false;
  for (GLuint index = 0; index < 16; ++index)
    if (!is_array_readable(index, scene.vertices())) return false;
  GLint indices = 0;
  GLint commands = 0;
  gl.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &indices);
  gl.GetIntegerv(GL_DRAW_INDIRECT_BUFFER_BINDING, &commands);
  return is_readable(indices, 2LL * scene.vertices()) && is_readable(commands, 36);
}

void ignore_errors() {
  while (gl.GetError() != GL_NO_ERROR) {
  }
}

// Some changes make triangles that overlap, like a restart index among the indices. An implementation may change the
// order of the triangles, so each pixel shows the maximum of all of them.
void show_the_brightest() {
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
}

// The picture without refinement. It leaves refinement off.
Picture plain_picture(const std::function<void()>& draw) {
  gl.Disable(GL_ARK);
  return picture_of(draw);
}

int difference(const Picture& actual, const Picture& expected) {
  return count_different(actual, expected, most_difference);
}

// Draws as often as the step says. Returns the difference of the first wrong picture.
std::optional<std::string> draw(const Scene& scene, Combination one) {
  one.triangles = scene.vertices() / 3;
  const auto call = [&] { paths()[one.path].draw(scene); };
  const Picture plain = plain_picture(call);
  set_refinement(one);
  for (int i = 0; i < one.history; ++i) {
    const Picture refined = picture_of(call);
    if (difference(refined, plain) <= most_edge_pixels) continue;
    // After textures changed, llvmpipe's vertex stage may read old memory until something else changes. Then the next
    // unrefined picture is another one.
    const int different = difference(refined, plain_picture(call));
    if (different > most_edge_pixels)
      return fmt::format("{}, draw {}: {} pixels differ by more than {}, {} may", text_of(one), i + 1, different,
                         most_difference, most_edge_pixels);
    gl.Enable(GL_ARK);
  }
  return {};
}

}  // namespace

RandomProgram random_program(std::mt19937& random, Api api, int version, std::size_t steps) {
  std::vector<const Change*> changes;
  for (const Change* each : all_changes())
    if (is_there(*each, api, version)) changes.push_back(each);
  const std::vector<Combination> draws = few_draws(random, api);
  RandomProgram program{sizes[below(random, sizes.size())], {}};
  while (program.steps.size() < steps) {
    Step step;
    if (!program.steps.empty() && below(random, 2) == 0) step.change = changes[below(random, changes.size())];
    step.draw = draws[below(random, draws.size())];
    program.steps.push_back(step);
  }
  return program;
}

std::optional<std::string> run(Test& t, const RandomProgram& program) {
  const std::unique_ptr<Context> own = t.create_context();
  std::optional<std::string> wrong;
  {
    const bool reads_all = std::any_of(program.steps.begin(), program.steps.end(), [](const Step& step) {
      return step.change != nullptr ? step.change->concern == Concern::integers
                                    : paths()[step.draw.path].draws_instances;
    });
    Scene scene(t, program.triangles, reads_all);
    for (const Path& path : paths())
      if (path.prepare != nullptr && path.apis.contains(t.api())) path.prepare(t, scene);
    show_the_brightest();
    for (const Step& step : program.steps) {
      if (step.change != nullptr)
        step.change->make(t, scene);
      else if (is_defined(scene))
        wrong = draw(scene, step.draw);
      ignore_errors();  // one change may have deleted what another one uses
      if (wrong) break;
    }
  }
  own->release_current();
  t.context().make_current();
  return wrong;
}

std::string text_of(const RandomProgram& program) {
  std::string text = fmt::format("{} triangles", program.triangles);
  for (const Step& step : program.steps) {
    Combination draw = step.draw;
    draw.triangles = program.triangles;
    text += fmt::format(
        "\n{}", step.change != nullptr ? step.change->leaf : fmt::format("{}, {} times", text_of(draw), draw.history));
  }
  return text;
}

}  // namespace glark::conformance
