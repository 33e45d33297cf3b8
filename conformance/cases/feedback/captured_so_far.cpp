// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw that repeats reads the buffer that transform feedback captures to: as vertices, indices, tags, a block, a texture
// or a command. It has to notice what was captured until the feedback is paused, resumed and ended.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <string_view>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using Payload = std::array<GLuint, 4>;  // what each captured vertex has
constexpr std::size_t vertices_of_range = 48;
constexpr std::size_t range_bytes = vertices_of_range * sizeof(Payload);  // a multiple of all alignments
constexpr GLuint at_payload = 3;

constexpr GLuint bits_of(float value) { return std::bit_cast<GLuint>(value); }
constexpr Payload payload_of(float x, float y, float z) { return {bits_of(x), bits_of(y), bits_of(z), bits_of(1)}; }

const void* offset_of_range(std::size_t range) { return reinterpret_cast<const void*>(range * range_bytes); }

// One way to read the captured buffer.
struct CapturedUse {
  const char* leaf;
  std::array<Payload, 2> payloads;
  const char* declaration;  // of the vertex stage
  const char* colour;
  void (*bind)(GLuint buffer, std::size_t range);
  void (*draw)(std::size_t range) = [](std::size_t) { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const char* offset = "vec4(0.0)";
  bool has_tags = false;
};

void point_payload(GLuint buffer, std::size_t range, GLuint divisor) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.EnableVertexAttribArray(at_payload);
  gl.VertexAttribPointer(at_payload, 4, GL_FLOAT, GL_FALSE, 0, offset_of_range(range));
  gl.VertexAttribDivisor(at_payload, divisor);
}

void point_integers(GLuint buffer, std::size_t range) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.EnableVertexAttribArray(at_payload);
  gl.VertexAttribIPointer(at_payload, 4, GL_UNSIGNED_INT, 0, offset_of_range(range));
}

void bind_tags(GLuint buffer, std::size_t range) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(Payload), offset_of_range(range));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
}

void bind_block(GLenum target, GLuint buffer, std::size_t range) {
  gl.BindBufferRange(target, 0, buffer, static_cast<GLintptr>(range * range_bytes), 256);
}

void bind_texels(GLuint buffer, std::size_t range) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_BUFFER, texture);
  gl.TexBufferRange(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer, static_cast<GLintptr>(range * range_bytes), 256);
}

constexpr std::array<Payload, 2> captured_colours = {payload_of(0.9F, 0.25F, 0.1F), payload_of(0.1F, 0.5F, 0.95F)};
constexpr const char* storage_leaf = "storage_block";  // a vertex stage may have none
constexpr const char* payload_input = "layout(location = 3) in vec4 payload;\n";

const CapturedUse captured_uses[] = {
    {"colours", captured_colours, payload_input, "payload",
     [](GLuint buffer, std::size_t range) { point_payload(buffer, range, 0); }},
    {"places",
     {payload_of(0.2F, 0, 0), payload_of(-0.2F, 0.2F, 0)},
     payload_input,
     "vec4(1.0)",
     [](GLuint buffer, std::size_t range) { point_payload(buffer, range, 0); },
     [](std::size_t) { gl.DrawArrays(GL_TRIANGLES, 0, 3); },
     "vec4(payload.xyz, 0.0)"},
    {"of_instances", captured_colours, payload_input, "payload",
     [](GLuint buffer, std::size_t range) { point_payload(buffer, range, 1); },
     [](std::size_t) { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 2); }},
    {"integers",
     {Payload{200, 10, 50, 255}, Payload{20, 100, 250, 255}},
     "layout(location = 3) in uvec4 payload;\n",
     "vec4(payload) / 255.0",
     point_integers},
    {.leaf = "tags",
     .payloads = {payload_of(1, 0, 0), payload_of(3, 0, 0)},
     .declaration = "",
     .colour = "vec4(1.0)",
     .bind = bind_tags,
     .has_tags = true},
    {"elements",
     {Payload{0, 1, 2, 0}, Payload{3, 4, 5, 0}},
     "",
     "vec4(1.0)",
     [](GLuint buffer, std::size_t) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer); },
     [](std::size_t range) { gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, offset_of_range(range)); }},
    {"command",
     {Payload{3, 1, 0, 0}, Payload{3, 1, 3, 0}},
     "",
     "vec4(1.0)",
     [](GLuint buffer, std::size_t) { gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer); },
     [](std::size_t range) { gl.DrawArraysIndirect(GL_TRIANGLES, offset_of_range(range)); }},
    {"uniform_block", captured_colours, "layout(std140, binding = 0) uniform Block { vec4 payload; };\n", "payload",
     [](GLuint buffer, std::size_t range) { bind_block(GL_UNIFORM_BUFFER, buffer, range); }},
    {storage_leaf, captured_colours, "layout(std430, binding = 0) readonly buffer Block { vec4 payload; };\n",
     "payload", [](GLuint buffer, std::size_t range) { bind_block(GL_SHADER_STORAGE_BUFFER, buffer, range); }},
    {"texture_buffer", captured_colours, "layout(binding = 0) uniform highp samplerBuffer payload;\n",
     "texelFetch(payload, 0)", bind_texels},
};

// Steps of one letter: b begins feedback, d draws into its next range, p pauses, r resumes, e ends it; o binds the default
// feedback object, f the one that captures; a draws what is not captured; R and S read the first and the second range.
struct CaptureSteps {
  const char* name;
  std::string_view steps;
};
constexpr CaptureSteps capture_steps[] = {
    {"paused", "RbdpReR"},          {"ended", "RbdeR"},       {"resumed", "RSbdpRSrdpSeS"},
    {"begun again", "RbdpRebdpRe"}, {"unbound", "RbdpoRfeR"}, {"drawn aside", "RSbdpaRrdpSeS"},
};

// All that the steps change.
struct CapturedScene {
  const CapturedUse& use;
  bool is_refined;  // what is captured
  GLuint capture = 0;
  GLuint reader = 0;
  GLuint captured_mesh = 0;
  std::array<GLuint, 2> readers{};  // vertex arrays, one for each range
  GLuint feedback = 0;
  GLuint buffer = 0;
  GLint payload_location = -1;
  std::array<Picture, 2> pictures{};  // for each payload
  std::array<std::size_t, 2> content{};
  std::size_t range = 0;
};

std::string captured_reader_text(const CapturedUse& use) {
  return fmt::format(
      "layout(location = 0) in vec4 position;\n{}out vec4 colour;\n"
      "void main() {{ colour = {}; gl_Position = vec4(0.7 * position.xyz, 1.0) + {}; }}\n",
      use.declaration, use.colour, use.offset);
}

void fill_captured(CapturedScene& s, std::size_t payload) {
  const std::vector<Payload> all(2 * vertices_of_range, s.use.payloads[payload]);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, s.buffer);
  gl.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(all.size() * sizeof(Payload)), all.data(),
                GL_DYNAMIC_COPY);
  s.content = {payload, payload};
}

void draw_captured_use(CapturedScene& s, std::size_t range) {
  gl.UseProgram(s.reader);
  gl.BindVertexArray(s.readers[range]);
  s.use.bind(s.buffer, range);
  s.use.draw(range);
}

CapturedScene captured_scene(Test& t, const CapturedUse& use, bool is_refined) {
  CapturedScene s{.use = use, .is_refined = is_refined};
  s.capture =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; uniform uvec4 payload;\n"
                                  "flat out uvec4 value; out vec4 colour;\n"
                                  "void main() { value = payload; colour = vec4(1.0); gl_Position = position; }\n",
                        .captured = {"value"}});
  s.payload_location = gl.GetUniformLocation(s.capture, "payload");
  s.reader = build_program(t, {.vertex = captured_reader_text(use)});
  Mesh mesh;
  for (std::size_t i = 0; i < vertices_of_range; ++i) mesh.push_back(one_triangle()[i % 3]);
  s.captured_mesh = upload(mesh, false).array;
  for (std::size_t i = 3; i < 6; ++i) mesh[i].position[0] *= -0.6F;
  std::swap(mesh[3], mesh[4]);
  for (GLuint& reader : s.readers) {
    reader = upload(mesh, false).array;
    gl.DisableVertexAttribArray(at_payload);
  }
  gl.GenBuffers(1, &s.buffer);
  gl.GenTransformFeedbacks(1, &s.feedback);
  for (const std::size_t payload : {1U, 0U}) {
    fill_captured(s, payload);
    s.pictures[payload] = picture_of([&] { draw_captured_use(s, 0); });
  }
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, s.feedback);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, s.buffer);
  return s;
}

void draw_into_range(CapturedScene& s, bool is_captured) {
  if (!is_captured) gl.UseProgram(s.capture);  // it is in use while feedback is active
  gl.BindVertexArray(s.captured_mesh);
  const std::size_t payload = 1 - s.content[s.range];
  gl.Uniform4uiv(s.payload_location, 1, s.use.payloads[payload].data());
  gl.DrawArrays(GL_TRIANGLES, 0, s.is_refined ? 12 : static_cast<GLsizei>(vertices_of_range));
  if (is_captured) s.content[s.range++] = payload;
}

void expect_captured_use(Test& t, CapturedScene& s, std::size_t range, const std::string& what) {
  const std::size_t payload = s.content[range];
  const auto draw = [&] { draw_captured_use(s, range); };
  const GLuint triangles = s.use.has_tags ? (payload == 0 ? 4 : 64) : 4 * (s.use.draw == captured_uses[2].draw ? 2 : 1);
  for (int again = 0; again < 2; ++again) {
    t.expect_same_picture(picture_of(draw), s.pictures[payload], what, 4, 80);
    t.expect_equal(count_generated(draw), triangles, what + ": triangles");
    if (again == 0) repeat_often(draw);
  }
}

void do_capture_step(Test& t, CapturedScene& s, char step, const std::string& what) {
  switch (step) {
    case 'b':
      s.range = 0;
      s.is_refined ? gl.Enable(GL_ARK) : gl.Disable(GL_ARK);
      gl.UseProgram(s.capture);
      gl.BeginTransformFeedback(GL_TRIANGLES);
      break;
    case 'd': draw_into_range(s, true); break;
    case 'a': draw_into_range(s, false); break;
    case 'p': gl.PauseTransformFeedback(); break;
    case 'r':
      s.is_refined ? gl.Enable(GL_ARK) : gl.Disable(GL_ARK);
      gl.UseProgram(s.capture);
      gl.ResumeTransformFeedback();
      break;
    case 'e': gl.EndTransformFeedback(); break;
    case 'o': gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0); break;
    case 'f': gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, s.feedback); break;
    default: gl.Enable(GL_ARK); expect_captured_use(t, s, step == 'R' ? 0 : 1, what);
  }
}

void check_captured_so_far(Test& t, const CapturedUse& use, bool is_refined) {
  if (std::string_view(use.leaf) == storage_leaf && integer_of(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS) < 1)
    t.not_supported("no storage blocks in vertex shaders");
  CapturedScene s = captured_scene(t, use, is_refined);
  use.has_tags ? refine_by_tags(3) : refine_uniformly(1);
  gl.DepthTag1i(use.has_tags ? 1 : 0);  // of what is captured
  for (const CaptureSteps& each : capture_steps) {
    fill_captured(s, 0);
    for (std::size_t at = 0; at < each.steps.size(); ++at)
      do_capture_step(t, s, each.steps[at], fmt::format("{}, step {}", each.name, at));
    t.expect_no_error(each.name);
  }
}

}  // namespace

Cases captured_so_far_cases() {
  Cases cases;
  for (const CapturedUse& use : captured_uses)
    for (const bool is_refined : {true, false})
      cases.push_back(
          {.name = fmt::format("ark.after_vertex.so_far.{}.{}", use.leaf, is_refined ? "refined" : "unrefined"),
           .clauses = {"chapter-14-5", "11.R.13-1", "11.R.10-1"},
           .plan =
               "Repeat a draw that reads the buffer of a feedback object in this way, and capture other values to it "
               "until the feedback is paused, resumed or ended: the draw shows them.",
           .wrong = "What is captured counts as written when the feedback ends, or when it is captured unrefined.",
           .is_optional = std::string_view(use.leaf) == storage_leaf,
           .check = [&use, is_refined](Test& t) { check_captured_so_far(t, use, is_refined); }});
  return cases;
}

}  // namespace glark::conformance
