// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Random programs: draws, writes of buffers, current values, vertex arrays and display lists in any order, in two
// contexts at once. One context draws unrefined, the other one refines by outputs. After every step, both must show the
// same picture and have the same current values. Reading these each time also keeps the plain driver in order:
// otherwise Mesa 22.3 sometimes draws with stale values.
#include <array>
#include <cstring>
#include <functional>
#include <random>
#include <string>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

constexpr int buffers = 4;
constexpr int arrays = 3;
constexpr int lists = 4;
constexpr int program_count = 3;
constexpr std::size_t buffer_vertices = 12;
constexpr int steps = 60;

// The objects of one context.
struct World {
  std::array<GLuint, buffers> vertices{};
  std::array<GLuint, buffers> indices{};
  std::array<GLuint, arrays> vertex_arrays{};
  std::array<GLuint, program_count> programs{};  // the first is the fixed function
};

struct Step {
  std::string name;
  std::function<void(World&)> run;
};

class Script {
 public:
  explicit Script(unsigned seed) : random_(seed) {}

  World make_world() const {
    World world;
    for (int i = 0; i < buffers; ++i) {
      const auto at = static_cast<std::size_t>(i);
      world.vertices.at(at) = make_buffer(GL_ARRAY_BUFFER, vertices_of(static_cast<unsigned>(i)));
      world.indices.at(at) = make_buffer(GL_ARRAY_BUFFER, indices_of(static_cast<unsigned>(i)));
    }
    glGenVertexArrays(arrays, world.vertex_arrays.data());
    for (const GLuint array : {world.vertex_arrays[0], world.vertex_arrays[1], world.vertex_arrays[2], GLuint{0}}) {
      glBindVertexArray(array);
      glBindBuffer(GL_ARRAY_BUFFER, world.vertices[0]);
      point_conventional_arrays(nullptr);
    }
    world.programs[1] = link_program({.vertex = "#version 120\nvoid main() { gl_Position = gl_Vertex; gl_FrontColor = "
                                                "gl_Color.bgra; }\n"});
    world.programs[2] = link_program(
        {.vertex = "#version 430 compatibility\nin vec4 glark_test_extra; flat out vec4 c;\n"
                   "void main() { gl_Position = gl_Vertex; c = 0.5 * gl_Color + 0.5 * glark_test_extra; }\n",
         .fragment = "#version 430\nflat in vec4 c; out vec4 result;\nvoid main() { result = vec4(c.rgb, 1.0); }\n"});
    return world;
  }

  Step next() {
    switch (pick(12)) {
      case 0:
      case 1: return state(pick(9));
      case 2:
      case 3: return pointers();
      case 4:
      case 5:
      case 6: return draw();
      case 7: return write();
      case 8: return compile();
      case 9:
      case 10: return call();
      default: return immediate(Attributes::any);
    }
  }

 private:
  unsigned pick(unsigned count) { return static_cast<unsigned>(random_() % count); }

  static std::vector<ColoredVertex> vertices_of(unsigned seed) {
    std::mt19937 random(seed + 1000);
    const auto within = [&] { return static_cast<GLfloat>(random() % 2001) / 1000 - 1; };
    std::vector<ColoredVertex> vertices(buffer_vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      ColoredVertex& vertex = vertices[i];
      vertex.position = {within(), within()};
      vertex.color = i % 3 == 0 ? std::array{std::abs(within()), std::abs(within()), 0.5F} : vertices[i - 1].color;
    }
    return vertices;
  }

  static std::vector<GLushort> indices_of(unsigned seed) {
    std::mt19937 random(seed + 2000);
    std::vector<GLushort> indices(buffer_vertices);
    for (GLushort& index : indices) index = static_cast<GLushort>(random() % buffer_vertices);
    return indices;
  }

  Step state(unsigned kind) {
    const auto x = static_cast<GLfloat>(pick(4)) / 3;
    const auto y = static_cast<GLfloat>(pick(4)) / 3;
    const unsigned choice = pick(12);
    return {"state " + std::to_string(kind), [=](World& world) {
              switch (kind) {
                case 0: glColor3f(x, y, 0.25F); break;
                case 1: glColor4ub(static_cast<GLubyte>(255 * x), static_cast<GLubyte>(255 * y), 200, 255); break;
                case 2: glVertexAttrib4f(5, x, y, 1, 1); break;
                case 3: glUseProgram(world.programs.at(choice % program_count)); break;
                case 4:
                  glMatrixMode(GL_MODELVIEW);
                  glLoadIdentity();
                  glRotatef(90 * x, 0, 0, 1);
                  break;
                case 5: glShadeModel(choice % 2 == 0 ? GL_FLAT : GL_SMOOTH); break;
                case 6:
                  glProvokingVertex(choice % 2 == 0 ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
                  break;
                case 7:
                  glBindVertexArray(choice % (arrays + 1) == 0 ? 0 : world.vertex_arrays.at(choice % (arrays + 1) - 1));
                  break;
                default:
                  glPushAttrib(GL_CURRENT_BIT);
                  glColor3f(y, x, 1);
                  if (choice % 2 == 0) glVertexAttrib4f(5, y, x, 0, 1);
                  glPopAttrib();
                  break;
              }
            }};
  }

  Step pointers() {
    const unsigned buffer = pick(buffers);
    const bool colors = pick(3) > 0;
    const bool extra = pick(3) == 0;
    return {"pointers", [=](World& world) {
              glBindBuffer(GL_ARRAY_BUFFER, world.vertices.at(buffer));
              point_conventional_arrays(nullptr);
              if (!colors) glDisableClientState(GL_COLOR_ARRAY);
              glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), byte_offset(8));
              extra ? glEnableVertexAttribArray(5) : glDisableVertexAttribArray(5);
            }};
  }

  Step draw() {
    const GLenum mode = std::array{GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN}.at(pick(3));
    const auto count = static_cast<GLsizei>(6 + 3 * pick(2));
    const unsigned kind = pick(6);
    const unsigned buffer = pick(buffers);
    const auto first = static_cast<GLint>(pick(4));
    std::vector<GLushort> own = indices_of(pick(1000));
    return {"draw " + std::to_string(kind), [=](World& world) {
              glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, kind == 5 ? 0 : world.indices.at(buffer));
              const void* const start = kind == 5 ? own.data() : nullptr;
              switch (kind) {
                case 0: glDrawArrays(mode, first, count); break;
                case 1: glDrawArraysInstanced(mode, first, count, 2); break;
                case 2: glDrawRangeElements(mode, 0, 11, count, GL_UNSIGNED_SHORT, start); break;
                case 3: glDrawElementsBaseVertex(mode, 6, GL_UNSIGNED_SHORT, nullptr, 0); break;
                default: glDrawElements(mode, count, GL_UNSIGNED_SHORT, start); break;
              }
            }};
  }

  Step write() {
    const unsigned kind = pick(6);
    const unsigned buffer = pick(buffers);
    const unsigned other = (buffer + 1 + pick(buffers - 1)) % buffers;
    const std::vector<ColoredVertex> vertices = vertices_of(pick(1000));
    const std::vector<GLushort> indices = indices_of(pick(1000));
    return {"write " + std::to_string(kind), [=](World& world) {
              const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(ColoredVertex));
              const GLuint target = world.vertices.at(buffer);
              glBindBuffer(GL_COPY_WRITE_BUFFER, kind == 5 ? world.indices.at(buffer) : target);
              switch (kind) {
                case 0: glBufferSubData(GL_COPY_WRITE_BUFFER, 0, bytes / 2, vertices.data()); break;
                case 1: glBufferData(GL_COPY_WRITE_BUFFER, bytes, vertices.data(), GL_DYNAMIC_DRAW); break;
                case 2: {
                  void* const memory = glMapBufferRange(GL_COPY_WRITE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT);
                  std::memcpy(memory, vertices.data(), static_cast<std::size_t>(bytes));
                  glUnmapBuffer(GL_COPY_WRITE_BUFFER);
                  break;
                }
                case 3:
                  glBindBuffer(GL_COPY_READ_BUFFER, world.vertices.at(other));
                  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes);
                  break;
                case 4: glNamedBufferSubData(target, bytes / 4, bytes / 2, vertices.data()); break;
                default:
                  glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(indices.size() * sizeof(GLushort)),
                                  indices.data());
                  break;
              }
            }};
  }

  enum class Attributes { none, from_the_first, any };

  Step immediate(Attributes attributes) {
    const GLenum mode = std::array{GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINES}.at(pick(4));
    const std::vector<ColoredVertex> vertices = vertices_of(pick(1000));
    const std::size_t count = 6 + 3 * pick(2);
    const std::size_t color_from = attributes == Attributes::any ? pick(8) : attributes == Attributes::none ? count : 0;
    const std::size_t extra_at = attributes == Attributes::any ? pick(12) : attributes == Attributes::none ? count : 0;
    return {"immediate", [=](World&) {
              glBegin(mode);
              for (std::size_t i = 0; i < count; ++i) {
                if (i >= color_from) glColor3fv(vertices[i].color.data());
                if (i == extra_at) glVertexAttrib4f(5, vertices[i].color[0], 1, vertices[i].color[1], 1);
                glVertex2fv(vertices[i].position.data());
              }
              glEnd();
            }};
  }

  // Mesa 22.3 crashes or draws wrong if an attribute appears after the first vertex in a list. It also forgets current
  // values that lists set between draws. So the glBegins of one list set all attributes, or no attribute.
  // Mesa 22.3 also executes glShadeModel before the vertices that precede it.
  Step compile() {
    const GLuint list = pick(lists);
    const GLenum mode = pick(4) == 0 ? GL_COMPILE_AND_EXECUTE : GL_COMPILE;
    const Attributes attributes = pick(2) == 0 ? Attributes::none : Attributes::from_the_first;
    std::vector<Step> contents;
    for (unsigned i = 0; i < 1 + pick(3); ++i) {
      contents.push_back(pick(4) == 0 ? state(std::array{3U, 4U, 6U}.at(pick(3))) : immediate(attributes));
    }
    const bool nested = list > 0 && pick(3) == 0;
    return {"compile " + std::to_string(list), [=](World& world) {
              glNewList(first_list + list, mode);
              for (const Step& step : contents) step.run(world);
              if (nested) glCallList(first_list + list - 1);
              glEndList();
            }};
  }

  Step call() {
    const GLuint list = pick(lists);
    const std::array<GLubyte, 2> names = {static_cast<GLubyte>(pick(lists)), static_cast<GLubyte>(pick(lists))};
    const bool several = pick(3) == 0;
    return {"call " + std::to_string(list), [=](World&) {
              if (!several) {
                glCallList(first_list + list);
                return;
              }
              glListBase(first_list);
              glCallLists(2, GL_UNSIGNED_BYTE, names.data());
            }};
  }

  static constexpr GLuint first_list = 100;
  std::mt19937 random_;
};

struct Outcome {
  Picture picture;
  std::string errors;
  std::array<GLfloat, 8> current{};  // colour, attribute 5
};

Outcome run(const Step& step, OsmesaContext& context, World& world) {
  context.make_current();
  step.run(world);
  Outcome outcome{.picture = read_picture(), .errors = pending_errors()};
  glGetFloatv(GL_CURRENT_COLOR, outcome.current.data());
  glGetVertexAttribfv(5, GL_CURRENT_VERTEX_ATTRIB, &outcome.current[4]);
  return outcome;
}

class RandomDraws : public testing::TestWithParam<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDraws, testing::Range(0U, 100U));

TEST_P(RandomDraws, SamePictureAfterEveryStep) {
  OsmesaContext plain(Profile::compatibility);
  Script script(GetParam());
  World plain_world = script.make_world();
  glClear(GL_COLOR_BUFFER_BIT);
  OsmesaContext refined(Profile::compatibility);
  World refined_world = script.make_world();
  glClear(GL_COLOR_BUFFER_BIT);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  glEnable(GL_ARK);
  GLuint shown = 0;
  std::string history;
  for (int i = 0; i < steps; ++i) {
    const Step step = script.next();
    history += step.name + "; ";

    const Outcome expected = run(step, plain, plain_world);
    const Outcome actual = run(step, refined, refined_world);
    ASSERT_EQ(actual.errors, expected.errors) << history;
    ASSERT_EQ(actual.current, expected.current) << history;
    ASSERT_LE(differing_pixels(expected.picture, actual.picture), tolerated_pixels) << history;
    shown += differing_pixels(expected.picture, Picture(expected.picture.size(), 0)) > visible_pixels ? 1 : 0;
  }
  EXPECT_GT(shown, static_cast<GLuint>(steps) / 2) << "the program shows nothing";
}

}  // namespace
}  // namespace glark::core::test
