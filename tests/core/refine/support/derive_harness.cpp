// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/core/refine/support/derive_harness.h"

#include <cstring>

namespace glark::refine::test {
namespace {

template <typename Function>
Function function(const char* name) {
  return reinterpret_cast<Function>(get_proc(name));
}
#define GLARK_GL(name, type) const auto name = function<type>(#name)

std::string log_of(GLuint object, bool program) {
  GLARK_GL(glGetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC);
  GLARK_GL(glGetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC);
  std::string log(4096, '\0');
  GLsizei length = 0;
  (program ? glGetProgramInfoLog : glGetShaderInfoLog)(object, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(length);
  return log.empty() ? "failed without a log" : log;
}

GLuint compile(GLenum stage, const std::string& source, std::string& error) {
  GLARK_GL(glCreateShader, PFNGLCREATESHADERPROC);
  GLARK_GL(glShaderSource, PFNGLSHADERSOURCEPROC);
  GLARK_GL(glCompileShader, PFNGLCOMPILESHADERPROC);
  GLARK_GL(glGetShaderiv, PFNGLGETSHADERIVPROC);
  const GLuint shader = glCreateShader(stage);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == 0) error += log_of(shader, false) + source;
  return shader;
}

// ES links no program without a fragment shader.
std::string fragment_shader(const std::string& vertex) {
  const std::size_t version = vertex.find("#version");
  const bool es = vertex.find(" es\n") != std::string::npos;
  if (es) return vertex.substr(version, vertex.find('\n', version) - version) + "\nvoid main() {}\n";
  return version == std::string::npos || vertex.find("#version 100") != std::string::npos
             ? "#version 100\nvoid main() {}\n"
             : "";
}

GLuint link(const std::vector<std::string>& sources, const std::vector<std::string>& varyings, bool es,
            std::string& error) {
  GLARK_GL(glCreateProgram, PFNGLCREATEPROGRAMPROC);
  GLARK_GL(glAttachShader, PFNGLATTACHSHADERPROC);
  GLARK_GL(glTransformFeedbackVaryings, PFNGLTRANSFORMFEEDBACKVARYINGSPROC);
  GLARK_GL(glLinkProgram, PFNGLLINKPROGRAMPROC);
  GLARK_GL(glGetProgramiv, PFNGLGETPROGRAMIVPROC);
  const GLuint program = glCreateProgram();
  for (const std::string& source : sources) glAttachShader(program, compile(GL_VERTEX_SHADER, source, error));
  const std::string fragment = es ? fragment_shader(sources.back()) : "";
  if (!fragment.empty()) glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment, error));
  std::vector<const char*> names;
  for (const std::string& varying : varyings) names.push_back(varying.c_str());
  if (!names.empty())
    glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(), GL_INTERLEAVED_ATTRIBS);
  if (!error.empty()) return program;
  glLinkProgram(program);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == 0) error += log_of(program, true) + sources.back();
  return program;
}

bool is_es() {
  GLARK_GL(glGetString, const GLubyte* (*)(GLenum));
  return std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))).starts_with("OpenGL ES");
}

void set_attribute(GLuint program, const std::string& name, const std::vector<float>& data, int size, GLuint divisor) {
  GLARK_GL(glGetAttribLocation, PFNGLGETATTRIBLOCATIONPROC);
  GLARK_GL(glGenBuffers, PFNGLGENBUFFERSPROC);
  GLARK_GL(glBindBuffer, PFNGLBINDBUFFERPROC);
  GLARK_GL(glBufferData, PFNGLBUFFERDATAPROC);
  GLARK_GL(glVertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC);
  GLARK_GL(glEnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC);
  GLARK_GL(glVertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC);
  const GLint location = glGetAttribLocation(program, name.c_str());
  if (location < 0) return;  // the shader does not need it
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(), GL_STATIC_DRAW);
  glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(location);
  glVertexAttribDivisor(location, divisor);
}

void set_attributes(GLuint program, const Experiment& experiment) {
  std::vector<float> lattice;
  for (const auto& point : experiment.lattice) {
    for (const float coordinate : point) lattice.push_back(coordinate * 32768.0F);
  }
  set_attribute(program, lattice_input, lattice, 2, 0);
  set_attribute(program, patch_input, {experiment.patch.begin(), experiment.patch.end()}, 4, 1);
  std::vector<float> words = experiment.record.words;
  words.resize((words.size() + 3) / 4 * 4);
  for (std::size_t chunk = 0; chunk < words.size() / 4; ++chunk) {
    const auto begin = words.begin() + static_cast<std::ptrdiff_t>(4 * chunk);
    set_attribute(program, chunk_input_prefix + std::to_string(chunk), {begin, begin + 4}, 4, 1);
  }
}

std::vector<float> draw(GLuint program, std::size_t vertices, std::size_t words_per_vertex) {
  GLARK_GL(glGenBuffers, PFNGLGENBUFFERSPROC);
  GLARK_GL(glBindBufferBase, PFNGLBINDBUFFERBASEPROC);
  GLARK_GL(glBufferData, PFNGLBUFFERDATAPROC);
  GLARK_GL(glUseProgram, PFNGLUSEPROGRAMPROC);
  GLARK_GL(glEnable, void (*)(GLenum));
  GLARK_GL(glBeginTransformFeedback, PFNGLBEGINTRANSFORMFEEDBACKPROC);
  GLARK_GL(glEndTransformFeedback, PFNGLENDTRANSFORMFEEDBACKPROC);
  GLARK_GL(glDrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC);
  GLARK_GL(glMapBufferRange, PFNGLMAPBUFFERRANGEPROC);
  std::vector<float> values(vertices * words_per_vertex);
  const auto bytes = static_cast<GLsizeiptr>(values.size() * sizeof(float));
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_READ);
  glUseProgram(program);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArraysInstanced(GL_POINTS, 0, static_cast<GLsizei>(vertices), 1);
  glEndTransformFeedback();
  const void* const mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  if (mapped == nullptr) return {};
  std::memcpy(values.data(), mapped, values.size() * sizeof(float));
  return values;
}

}  // namespace

std::string link_error(const std::vector<std::string>& sources, const std::vector<std::string>& varyings) {
  std::string error;
  link(sources, varyings, is_es(), error);
  return error;
}

float bits(std::int32_t value) {
  float word = 0;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

Record make_record(const std::vector<FieldValues>& fields) {
  Record record;
  for (const FieldValues& values : fields) {
    capture::Field field;
    field.name = values.name;
    field.type = values.type;
    field.array_size = values.array_size;
    field.is_array = values.is_array;
    field.role = values.role;
    field.offset = record.layout.corner_words;
    field.words = static_cast<int>(values.corners[0].size());
    record.layout.corner_words += field.words;
    record.layout.fields.push_back(field);
  }
  for (int corner = 0; corner < 3; ++corner) {
    for (const FieldValues& values : fields) {
      record.words.insert(record.words.end(), values.corners[corner].begin(), values.corners[corner].end());
    }
  }
  return record;
}

Refined run(const Experiment& experiment) {
  Refined refined;
  DeriveRequest request = experiment.request;
  request.layout = experiment.record.layout;
  const Derivation derivation = derive_vertex_stage(request);
  if (!derivation.ok) return {derivation.error, {}};
  GLARK_GL(glGenVertexArrays, PFNGLGENVERTEXARRAYSPROC);
  GLARK_GL(glBindVertexArray, PFNGLBINDVERTEXARRAYPROC);
  GLARK_GL(glGetError, GLenum(*)());
  GLuint vertex_array = 0;
  glGenVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  const GLuint program = link(derivation.vertex_sources, experiment.varyings, request.es, refined.error);
  if (!refined.error.empty()) return refined;
  set_attributes(program, experiment);
  GLARK_GL(glGetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC);
  GLARK_GL(glProgramUniform1f, PFNGLPROGRAMUNIFORM1FPROC);
  glProgramUniform1f(program, glGetUniformLocation(program, shape_number_uniform), experiment.shape_number);
  const auto width = static_cast<std::size_t>(experiment.captured_words);
  const std::vector<float> values = draw(program, experiment.lattice.size(), width);
  if (values.empty() || glGetError() != GL_NO_ERROR) return {"the draw raised a GL error", {}};
  for (std::size_t i = 0; i < experiment.lattice.size(); ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * width);
    refined.values.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(width));
  }
  return refined;
}

}  // namespace glark::refine::test
