// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that writes a buffer, between two draws that read it as a vertex array.
#include "conformance/cases/cases.h"
#include "conformance/cases/changes/buffer_content.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

void map_range(Scene& s, GLbitfield flags) {
  write_mapped(s, gl.MapBufferRange(GL_ARRAY_BUFFER, 0, s.colour_bytes(), GL_MAP_WRITE_BIT | flags));
}

// Runs a compute shader for each vertex.
void compute(Test& t, const Scene& s, const std::string& source, GLbitfield barrier, const std::function<void()>& run) {
  const std::string text = glsl_head(t) + "layout(local_size_x = 1) in;\n" + source;
  const char* const texts = text.c_str();
  const GLuint program = gl.CreateShaderProgramv(GL_COMPUTE_SHADER, 1, &texts);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) t.internal_error("the compute shader does not build");
  gl.UseProgram(program);
  run();
  gl.MemoryBarrier(barrier);
  gl.UseProgram(s.program);
  gl.DeleteProgram(program);
}

constexpr char storing[] =
    "layout(std430, binding = 1) buffer Colours { uint c[]; };\n"
    "void main() { c[gl_WorkGroupID.x] = 0xff008020u + 0x190301u * (gl_WorkGroupID.x % 8u); }\n";

void store(Test& t, Scene& s) {
  compute(t, s, storing, GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, [&] {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, s.colours);
    gl.DispatchCompute(static_cast<GLuint>(s.vertices()), 1, 1);
  });
}

void store_indirectly(Test& t, Scene& s) {
  compute(t, s, storing, GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, [&] {
    const GLuint groups[] = {static_cast<GLuint>(s.vertices()), 1, 1};
    s.made.push_back(make_buffer(GL_DISPATCH_INDIRECT_BUFFER, groups, sizeof(groups)));
    gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 1, s.colours, 0, s.colour_bytes());
    gl.DispatchComputeIndirect(0);
  });
}

// Binds two buffers at once. The one that is written is the first one, or the second one.
void store_in_one_of_two(Test& t, Scene& s, bool has_ranges, bool is_first) {
  const std::vector<GLubyte> content(static_cast<std::size_t>(s.colour_bytes()));
  s.made.push_back(make_buffer(GL_SHADER_STORAGE_BUFFER, content.data(), s.colour_bytes()));
  compute(t, s, storing, GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, [&] {
    const GLuint buffers[] = {is_first ? s.colours : s.made.back(), is_first ? s.made.back() : s.colours};
    const GLintptr offsets[] = {0, 0};
    const GLsizeiptr sizes[] = {s.colour_bytes(), s.colour_bytes()};
    const GLuint first = is_first ? 1 : 0;
    has_ranges ? gl.BindBuffersRange(GL_SHADER_STORAGE_BUFFER, first, 2, buffers, offsets, sizes)
               : gl.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, first, 2, buffers);
    gl.DispatchCompute(static_cast<GLuint>(s.vertices()), 1, 1);
  });
}

// Writes through a buffer texture.
void store_image(Test& t, Scene& s) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_BUFFER, texture);
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, s.colours);
  compute(t, s,
          "layout(r32ui, binding = 0) writeonly uniform highp uimageBuffer colours;\n"
          "void main() { imageStore(colours, int(gl_WorkGroupID.x),"
          " uvec4(0xff008020u + 0x190301u * (gl_WorkGroupID.x % 8u))); }\n",
          GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, [&] {
            gl.BindImageTexture(0, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32UI);
            gl.DispatchCompute(static_cast<GLuint>(s.vertices()), 1, 1);
          });
  gl.DeleteTextures(1, &texture);
}

// Counters count up from the colours, four vertices at a time: red gets brighter by 64, or overflows.
void count(Test& t, Scene& s) {
  compute(t, s,
          "layout(binding = 0, offset = 0) uniform atomic_uint reds[4];\n"
          "void main() { for (int i = 0; i < 256; ++i) { atomicCounterIncrement(reds[i % 4]); } }\n",
          GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ATOMIC_COUNTER_BARRIER_BIT, [&] {
            for (GLintptr at = 0; at < s.colour_bytes(); at += 16) {
              gl.BindBufferRange(GL_ATOMIC_COUNTER_BUFFER, 0, s.colours, at, 16);
              gl.DispatchCompute(1, 1, 1);
            }
          });
}

constexpr char feeding[] =
    "flat out uint bits; void main() { bits = 0xff203000u + 40u * uint(gl_VertexID % 6);"
    " gl_Position = vec4(0.0); gl_PointSize = 1.0; }";

// Transform feedback of points, which are never refined.
void feed_back(Test& t, Scene& s, const std::function<void()>& bind) {
  const GLuint program =
      build_program(t, {.vertex = feeding,
                        .fragment = "flat in uint bits; out vec4 pixel; void main() { pixel = vec4(float(bits)); }",
                        .captured = {"bits"}});
  const bool refines = gl.IsEnabled(GL_ARK) == GL_TRUE;
  gl.Disable(GL_ARK);
  gl.UseProgram(program);
  bind();
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, s.vertices());
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl.UseProgram(s.program);
  gl.DeleteProgram(program);
  if (refines) gl.Enable(GL_ARK);
}

// The colours become those of a row of pixels.
void show_pixels(const Scene& s) {
  gl.ClearColor(0.2F, 0.9F, 0.4F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, s.colours);
}

void read_pixels(Test&, Scene& s) {
  show_pixels(s);
  gl.ReadPixels(0, 0, s.vertices() / 6, 6, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void readn_pixels(Test&, Scene& s) {
  show_pixels(s);
  gl.ReadnPixels(0, 0, s.vertices() / 6, 6, GL_RGBA, GL_UNSIGNED_BYTE, 4 * s.vertices(), nullptr);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void delete_and_name_again(Test&, Scene& s) {
  gl.DeleteBuffers(1, &s.colours);
  s.colours = make_buffer(GL_ARRAY_BUFFER, s.new_colours().data(), static_cast<std::size_t>(s.all_colour_bytes()));
  s.point_at(0);
}

void copy(Scene& s, GLenum from, GLenum to) {
  source_of(s, from);
  gl.BindBuffer(to, s.colours);
  gl.CopyBufferSubData(from, to, 0, 0, s.colour_bytes());
}

std::vector<Change> common() {
  return {
      {"BufferData",
       {"BufferData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BufferData(GL_ARRAY_BUFFER, s.all_colour_bytes(), s.new_colours().data(), GL_STATIC_DRAW);
       }},
      {"BufferSubData",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.BufferSubData(GL_ARRAY_BUFFER, 0, s.colour_bytes(), s.new_colours().data()); }},
      {"other_target",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_COPY_WRITE_BUFFER, s.colours);
         gl.BufferSubData(GL_COPY_WRITE_BUFFER, 0, s.colour_bytes(), s.new_colours().data());
       }},
      {"one_vertex",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         // The middle of the smaller mesh has large triangles; in the larger one, a row of triangles changes.
         const GLsizei first = s.vertices() < 100 ? 3 : s.vertices() / 2;
         gl.BufferSubData(GL_ARRAY_BUFFER, 4 * GLintptr{first}, s.colour_bytes() / 8, s.new_colours().data() + first);
       }},
      {"MapBufferRange",
       {"MapBufferRange", "UnmapBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) {
         map_range(s, 0);
         gl.UnmapBuffer(GL_ARRAY_BUFFER);
       }},
      {"invalidating_map",
       {"MapBufferRange"},
       Concern::arrays,
       [](Test&, Scene& s) {
         map_range(s, GL_MAP_INVALIDATE_BUFFER_BIT);
         gl.UnmapBuffer(GL_ARRAY_BUFFER);
       }},
      {"unsynchronized_map",
       {"MapBufferRange"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.Finish();
         map_range(s, GL_MAP_UNSYNCHRONIZED_BIT);
         gl.UnmapBuffer(GL_ARRAY_BUFFER);
       }},
      {"FlushMappedBufferRange",
       {"FlushMappedBufferRange"},
       Concern::arrays,
       [](Test&, Scene& s) {
         map_range(s, GL_MAP_FLUSH_EXPLICIT_BIT);
         gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, s.colour_bytes());
         gl.UnmapBuffer(GL_ARRAY_BUFFER);
       }},
      {"CopyBufferSubData",
       {"CopyBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) { copy(s, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER); }},
      {"copied_by_other_targets",
       {"CopyBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         copy(s, GL_PIXEL_PACK_BUFFER, GL_ARRAY_BUFFER);
         gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
       }},
      {"DeleteBuffers", {"DeleteBuffers", "GenBuffers"}, Concern::arrays, delete_and_name_again},
      {"BeginTransformFeedback",
       {"BeginTransformFeedback", "EndTransformFeedback"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         feed_back(t, s, [&] { gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, s.colours); });
       }},
      {"ReadPixels", {"ReadPixels"}, Concern::arrays, read_pixels},
      {"ReadnPixels", {"ReadnPixels"}, Concern::arrays, readn_pixels, every_api, 45},
      {"DispatchCompute", {"DispatchCompute", "MemoryBarrier"}, Concern::arrays, store},
      {"DispatchComputeIndirect", {"DispatchComputeIndirect"}, Concern::arrays, store_indirectly},
      {"storage_by_bind_buffers_base",
       {"DispatchCompute"},
       Concern::arrays,
       [](Test& t, Scene& s) { store_in_one_of_two(t, s, false, true); },
       desktop_apis,
       44},
      {"storage_by_bind_buffers_base_second",
       {"DispatchCompute"},
       Concern::arrays,
       [](Test& t, Scene& s) { store_in_one_of_two(t, s, false, false); },
       desktop_apis,
       44},
      {"storage_by_bind_buffers_range",
       {"DispatchCompute"},
       Concern::arrays,
       [](Test& t, Scene& s) { store_in_one_of_two(t, s, true, true); },
       desktop_apis,
       44},
      {"imageStore", {"BindImageTexture", "TexBuffer"}, Concern::arrays, store_image},
      {"atomic_counter", {"DispatchCompute", "BindBufferBase"}, Concern::arrays, count},
  };
}

void feed_back_object(Test& t, Scene& s) {
  GLuint object = 0;
  gl.CreateTransformFeedbacks(1, &object);
  gl.TransformFeedbackBufferRange(object, 0, s.colours, 0, s.colour_bytes());
  feed_back(t, s, [&] { gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object); });
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.DeleteTransformFeedbacks(1, &object);
}

std::vector<Change> desktop() {
  return {
      {"MapBuffer",
       {"MapBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) {
         write_mapped(s, gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
         gl.UnmapBuffer(GL_ARRAY_BUFFER);
       },
       desktop_apis},
      {"ClearBufferData",
       {"ClearBufferData"},
       Concern::arrays,
       [](Test&, Scene&) {
         gl.ClearBufferData(GL_ARRAY_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one_colour);
       },
       desktop_apis},
      {"ClearBufferSubData",
       {"ClearBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.ClearBufferSubData(GL_ARRAY_BUFFER, GL_R32UI, 0, s.colour_bytes(), GL_RED_INTEGER, GL_UNSIGNED_INT,
                               &one_colour);
       },
       desktop_apis},
      {"TransformFeedbackBufferRange",
       {"TransformFeedbackBufferRange"},
       Concern::arrays,
       feed_back_object,
       desktop_apis,
       45},
  };
}

}  // namespace

Cases buffer_writes_cases() {
  static const std::vector<Change> changes = joined({common(), desktop()});
  return change_cases("buffer", changes, 0);
}

}  // namespace glark::conformance
