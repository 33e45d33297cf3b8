// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that writes a buffer, between two draws that read it as a vertex array.
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

std::size_t bytes_of(const Scene& s) { return 4 * static_cast<std::size_t>(s.vertices()); }
GLsizeiptr size_of(const Scene& s) { return 4 * GLsizeiptr{s.vertices()}; }

// Another buffer with the other colours, bound to the target.
GLuint source_of(Scene& s, GLenum target) {
  s.made.push_back(make_buffer(target, s.new_colours().data(), bytes_of(s)));
  return s.made.back();
}

constexpr std::uint32_t one_colour = 0xff30c0f0;

void write_mapped(Test& t, Scene& s, void* mapped) {
  t.require(mapped != nullptr, "the buffer can be mapped");
  std::memcpy(mapped, s.new_colours().data(), bytes_of(s));
}

void unmap(Test& t) { t.require(gl.UnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE, "the mapped content is kept"); }

void map_range(Test& t, Scene& s, GLbitfield flags) {
  write_mapped(t, s, gl.MapBufferRange(GL_ARRAY_BUFFER, 0, size_of(s), GL_MAP_WRITE_BIT | flags));
}

void map_named(Test& t, Scene& s, GLbitfield flags) {
  write_mapped(t, s, gl.MapNamedBufferRange(s.colours, 0, size_of(s), GL_MAP_WRITE_BIT | flags));
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
    gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 1, s.colours, 0, size_of(s));
    gl.DispatchComputeIndirect(0);
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

// A counter counts down from the colour of the first vertices, once for each vertex.
void count(Test& t, Scene& s) {
  compute(t, s,
          "layout(binding = 0, offset = 0) uniform atomic_uint one; layout(binding = 0, offset = 4) uniform "
          "atomic_uint two;\n"
          "void main() { for (int i = 0; i < 0x7000; ++i) { atomicCounterDecrement(one); atomicCounterIncrement(two); "
          "} }\n",
          GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ATOMIC_COUNTER_BARRIER_BIT, [&] {
            gl.BindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, s.colours);
            gl.DispatchCompute(1, 1, 1);
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

void feed_back_object(Test& t, Scene& s) {
  GLuint object = 0;
  gl.CreateTransformFeedbacks(1, &object);
  gl.TransformFeedbackBufferRange(object, 0, s.colours, 0, size_of(s));
  feed_back(t, s, [&] { gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object); });
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.DeleteTransformFeedbacks(1, &object);
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

// A texture whose pixels are the other colours.
GLuint texture_of(const Scene& s) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, s.vertices() / 6, 6, 0, GL_RGBA, GL_UNSIGNED_BYTE, s.new_colours().data());
  return texture;
}

void read_texture(Scene& s, const std::function<void(GLuint)>& read) {
  const GLuint texture = texture_of(s);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, s.colours);
  read(texture);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.BindTexture(GL_TEXTURE_2D, s.image);
  gl.DeleteTextures(1, &texture);
}

// The result of a query becomes the colour of the first vertices: no sample passes, so they turn black.
void query(Test&, Scene& s, const std::function<void(GLuint)>& read) {
  GLuint name = 0;
  gl.GenQueries(1, &name);
  gl.BeginQuery(GL_SAMPLES_PASSED, name);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.Finish();
  gl.BindBuffer(GL_QUERY_BUFFER, s.colours);
  read(name);
  gl.BindBuffer(GL_QUERY_BUFFER, 0);
  gl.DeleteQueries(1, &name);
}

void delete_and_name_again(Test&, Scene& s) {
  gl.DeleteBuffers(1, &s.colours);
  s.colours = make_buffer(GL_ARRAY_BUFFER, s.new_colours().data(), bytes_of(s));
  s.point_at(0);
}

void copy(Scene& s, GLenum from, GLenum to) {
  source_of(s, from);
  gl.BindBuffer(to, s.colours);
  gl.CopyBufferSubData(from, to, 0, 0, size_of(s));
}

std::vector<Change> common() {
  return {
      {"BufferData",
       {"BufferData"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.BufferData(GL_ARRAY_BUFFER, size_of(s), s.new_colours().data(), GL_STATIC_DRAW); }},
      {"BufferSubData",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.BufferSubData(GL_ARRAY_BUFFER, 0, size_of(s), s.new_colours().data()); }},
      {"other_target",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_COPY_WRITE_BUFFER, s.colours);
         gl.BufferSubData(GL_COPY_WRITE_BUFFER, 0, size_of(s), s.new_colours().data());
       }},
      {"one_vertex",
       {"BufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         // The middle of the smaller mesh has large triangles; in the larger one, a row of triangles changes.
         const GLsizei first = s.vertices() < 100 ? 3 : s.vertices() / 2;
         gl.BufferSubData(GL_ARRAY_BUFFER, 4 * GLintptr{first}, size_of(s) / 8, s.new_colours().data() + first);
       }},
      {"MapBufferRange",
       {"MapBufferRange", "UnmapBuffer"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         map_range(t, s, 0);
         unmap(t);
       }},
      {"invalidating_map",
       {"MapBufferRange"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         map_range(t, s, GL_MAP_INVALIDATE_BUFFER_BIT);
         unmap(t);
       }},
      {"unsynchronized_map",
       {"MapBufferRange"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         gl.Finish();
         map_range(t, s, GL_MAP_UNSYNCHRONIZED_BIT);
         unmap(t);
       }},
      {"FlushMappedBufferRange",
       {"FlushMappedBufferRange"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         map_range(t, s, GL_MAP_FLUSH_EXPLICIT_BIT);
         gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, size_of(s));
         unmap(t);
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
      {"imageStore", {"BindImageTexture", "TexBuffer"}, Concern::arrays, store_image},
      {"atomic_counter", {"DispatchCompute", "BindBufferBase"}, Concern::arrays, count},
  };
}

std::vector<Change> desktop() {
  return {
      {"MapBuffer",
       {"MapBuffer"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         write_mapped(t, s, gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
         unmap(t);
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
         gl.ClearBufferSubData(GL_ARRAY_BUFFER, GL_R32UI, 0, size_of(s), GL_RED_INTEGER, GL_UNSIGNED_INT, &one_colour);
       },
       desktop_apis},
      {"GetTexImage",
       {"GetTexImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [](GLuint) { gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); });
       },
       desktop_apis},
      {"GetTextureImage",
       {"GetTextureImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [&](GLuint texture) {
           gl.GetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, 4 * s.vertices(), nullptr);
         });
       },
       desktop_apis,
       45},
      {"GetTextureSubImage",
       {"GetTextureSubImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [&](GLuint texture) {
           gl.GetTextureSubImage(texture, 0, 0, 0, 0, s.vertices() / 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                 4 * s.vertices(), nullptr);
         });
       },
       desktop_apis,
       45},
      {"GetQueryObjectuiv",
       {"GetQueryObjectuiv"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [](GLuint name) {
           for (std::uintptr_t i = 0; i < 9; ++i)
             gl.GetQueryObjectuiv(name, GL_QUERY_RESULT, reinterpret_cast<GLuint*>(4 * i));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjectiv",
       {"GetQueryObjectiv"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [](GLuint name) {
           for (std::uintptr_t i = 0; i < 9; ++i)
             gl.GetQueryObjectiv(name, GL_QUERY_RESULT, reinterpret_cast<GLint*>(4 * i));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjectui64v",
       {"GetQueryObjectui64v"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [](GLuint name) {
           for (std::uintptr_t i = 0; i < 5; ++i)
             gl.GetQueryObjectui64v(name, GL_QUERY_RESULT, reinterpret_cast<GLuint64*>(8 * i));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjecti64v",
       {"GetQueryObjecti64v"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [](GLuint name) {
           for (std::uintptr_t i = 0; i < 5; ++i)
             gl.GetQueryObjecti64v(name, GL_QUERY_RESULT, reinterpret_cast<GLint64*>(8 * i));
         });
       },
       desktop_apis,
       44},
      {"GetQueryBufferObjectuiv",
       {"GetQueryBufferObjectuiv"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [&](GLuint name) {
           for (GLintptr i = 0; i < 9; ++i) gl.GetQueryBufferObjectuiv(name, s.colours, GL_QUERY_RESULT, 4 * i);
         });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjectiv",
       {"GetQueryBufferObjectiv"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [&](GLuint name) {
           for (GLintptr i = 0; i < 9; ++i) gl.GetQueryBufferObjectiv(name, s.colours, GL_QUERY_RESULT, 4 * i);
         });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjectui64v",
       {"GetQueryBufferObjectui64v"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [&](GLuint name) {
           for (GLintptr i = 0; i < 5; ++i) gl.GetQueryBufferObjectui64v(name, s.colours, GL_QUERY_RESULT, 8 * i);
         });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjecti64v",
       {"GetQueryBufferObjecti64v"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         query(t, s, [&](GLuint name) {
           for (GLintptr i = 0; i < 5; ++i) gl.GetQueryBufferObjecti64v(name, s.colours, GL_QUERY_RESULT, 8 * i);
         });
       },
       desktop_apis,
       45},
      {"TransformFeedbackBufferRange",
       {"TransformFeedbackBufferRange"},
       Concern::arrays,
       feed_back_object,
       desktop_apis,
       45},
  };
}

// Direct state access: the buffer is bound to no target.
std::vector<Change> direct() {
  return {
      {"NamedBufferData",
       {"NamedBufferData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.NamedBufferData(s.colours, size_of(s), s.new_colours().data(), GL_STATIC_DRAW);
       },
       desktop_apis,
       45},
      {"NamedBufferSubData",
       {"NamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.NamedBufferSubData(s.colours, 0, size_of(s), s.new_colours().data());
       },
       desktop_apis,
       45},
      {"MapNamedBuffer",
       {"MapNamedBuffer", "UnmapNamedBuffer"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         write_mapped(t, s, gl.MapNamedBuffer(s.colours, GL_WRITE_ONLY));
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"MapNamedBufferRange",
       {"MapNamedBufferRange"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         map_named(t, s, 0);
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"FlushMappedNamedBufferRange",
       {"FlushMappedNamedBufferRange"},
       Concern::arrays,
       [](Test& t, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         map_named(t, s, GL_MAP_FLUSH_EXPLICIT_BIT);
         gl.FlushMappedNamedBufferRange(s.colours, 0, size_of(s));
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"CopyNamedBufferSubData",
       {"CopyNamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         const GLuint source = source_of(s, GL_COPY_READ_BUFFER);
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.CopyNamedBufferSubData(source, s.colours, 0, 0, size_of(s));
       },
       desktop_apis,
       45},
      {"ClearNamedBufferData",
       {"ClearNamedBufferData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.ClearNamedBufferData(s.colours, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one_colour);
       },
       desktop_apis,
       45},
      {"ClearNamedBufferSubData",
       {"ClearNamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.ClearNamedBufferSubData(s.colours, GL_R32UI, 0, size_of(s), GL_RED_INTEGER, GL_UNSIGNED_INT, &one_colour);
       },
       desktop_apis,
       45},
      {"CreateBuffers",
       {"CreateBuffers", "NamedBufferStorage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.DeleteBuffers(1, &s.colours);
         gl.CreateBuffers(1, &s.colours);
         gl.NamedBufferStorage(s.colours, size_of(s), s.new_colours().data(), 0);
         gl.BindBuffer(GL_ARRAY_BUFFER, s.colours);
         s.point_at(0);
       },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases buffer_writes_cases() {
  static const std::vector<Change> changes = joined({common(), desktop(), direct()});
  return change_cases("buffer", changes, 0);
}

}  // namespace glark::conformance
