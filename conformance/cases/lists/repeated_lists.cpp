// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists that are called several times, by every kind of name, and with other current values (chapter 21).
#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr int calls = 4;

void triangle() {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-0.75F, -0.5F);
  gl.Vertex2f(0.75F, -0.75F);
  gl.Vertex2f(0.25F, 0.75F);
  gl.End();
}

void compile_as(GLuint list, const std::function<void()>& commands) {
  gl.NewList(list, GL_COMPILE);
  commands();
  gl.EndList();
}

void refine() {
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
}

// Fixed function: the list has only vertices. Their other attributes are current at the call.
void check_inherited(Test& t) {
  const GLuint list = gl.GenLists(1);
  refine();
  compile_as(list, triangle);
  for (int round = 0; round < 3; ++round)
    for (int again = 0; again < calls; ++again) {
      const auto part = static_cast<float>(round) / 2;
      gl.Color4f(1 - part, part, 0.5F, 1);
      gl.DepthTag1i(static_cast<GLuint>(round + 1));
      gl.Disable(GL_ARK);
      const Picture plain = picture_of([list] { gl.CallList(list); });
      gl.Enable(GL_ARK);
      t.expect_same_picture(picture_of([list] { gl.CallList(list); }), plain, "the list with this color", 2, 20);
      t.expect_equal(count_generated([list] { gl.CallList(list); }), GLuint{4} << (2 * round),
                     "triangles with this tag");
    }
}

// After each call the list's last values are current, even if an implementation need not capture its triangles again.
void check_left_behind(Test& t) {
  const GLuint list = gl.GenLists(1);
  refine();
  compile_as(list, [] {
    gl.DepthTag1i(2);
    gl.Color4f(0, 1, 0, 1);
    triangle();
    gl.Begin(GL_TRIANGLES);
    for (const GLuint corner : {0U, 1U, 2U}) {
      gl.DepthTag1i(1 + corner);
      gl.Color4f(0.25F * static_cast<float>(corner), 0, 1, 1);
      gl.Vertex2f(corner == 1 ? 0.5F : -0.5F, corner == 2 ? 0.5F : -0.5F);
    }
    gl.End();
  });
  for (int again = 0; again < 2 * calls; ++again) {
    gl.DepthTag1i(4);
    gl.Color4f(1, 1, 1, 1);
    gl.CallList(list);
    GLfloat color[4] = {0, 0, 0, 0};
    gl.GetFloatv(GL_CURRENT_COLOR, color);
    t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the tag that the list leaves");
    t.expect_near(color[0], 0.5, 0.01, "the red that the list leaves");
    t.expect_equal(count_generated(triangle), 64U, "triangles with the tag that it leaves");
  }
}

// A list that sets values and restores those before. The draws after it have what was current, also when they repeat.
void check_restored(Test& t, bool pushes) {
  const GLuint list = gl.GenLists(1);
  refine();
  compile_as(list, [pushes] {
    if (pushes) gl.PushAttrib(GL_CURRENT_BIT);
    gl.Color4f(1, 0, 0, 1);
    gl.DepthTag1i(0);
    gl.PopAttrib();
  });
  const GLfloat corners[] = {-0.75F, -0.5F, 0.75F, -0.75F, 0.25F, 0.75F};
  gl.VertexPointer(2, GL_FLOAT, 0, corners);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (const int round : {0, 1})
    for (int again = 0; again < calls; ++again) {
      gl.Color4f(0, round == 0 ? 1.0F : 0.5F, 1, 1);
      gl.DepthTag1i(static_cast<GLuint>(round + 1));
      if (!pushes) gl.PushAttrib(GL_CURRENT_BIT);
      gl.CallList(list);
      t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), round + 1, "the tag that was restored");
      gl.Disable(GL_ARK);
      const Picture plain = picture_of(draw);
      gl.Enable(GL_ARK);
      t.expect_same_picture(picture_of(draw), plain, "a draw with the restored color", 2, 20);
      t.expect_equal(count_generated(draw), GLuint{4} << (2 * round), "triangles with the restored tag");
    }
}

// Four lists with different numbers of triangles, named in every type.
void check_names(Test& t) {
  const GLuint base = 300;
  refine();
  for (GLuint i = 1; i <= 4; ++i)
    compile_as(base + i, [i] {
      gl.DepthTag1i(i - 1);
      triangle();
    });
  for (GLuint i = 0; i < 4; ++i)
    compile_as(base + 256 * (i + 1), triangle);  // the value if the names were little-endian
  gl.ListBase(base);
  const GLubyte bytes[] = {1, 3};
  const GLbyte signed_bytes[] = {1, 3};
  const GLshort shorts[] = {1, 3};
  const GLushort unsigned_shorts[] = {1, 3};
  const GLint integers[] = {1, 3};
  const GLuint unsigned_integers[] = {1, 3};
  const GLfloat floats[] = {1, 3};
  const GLubyte twos[] = {0, 1, 0, 3};
  const GLubyte threes[] = {0, 0, 1, 0, 0, 3};
  const GLubyte fours[] = {0, 0, 0, 1, 0, 0, 0, 3};
  const std::pair<GLenum, const void*> names[] = {{GL_UNSIGNED_BYTE, bytes}, {GL_BYTE, signed_bytes},
                                                  {GL_SHORT, shorts},        {GL_INT, integers},
                                                  {GL_FLOAT, floats},        {GL_UNSIGNED_SHORT, unsigned_shorts},
                                                  {GL_2_BYTES, twos},        {GL_3_BYTES, threes},
                                                  {GL_4_BYTES, fours},       {GL_UNSIGNED_INT, unsigned_integers}};
  for (const auto& [type, list] : names) {
    const auto call = [type = type, list = list] { gl.CallLists(2, type, list); };
    t.expect_equal(count_generated(call), 1U + 16U, "triangles of lists by names of type " + as_text(type));
    compile_as(900, call);
    t.expect_equal(count_generated([] { gl.CallList(900); }), 1U + 16U, "by a list that calls them");
    gl.ListBase(base + 1);
    t.expect_equal(count_generated([] { gl.CallList(900); }), 4U + 64U, "with another list base at the call");
    gl.ListBase(base);
  }
  t.expect_no_error("the lists");
}

// A compiled ListBase takes effect when its list is called.
void check_compiled_base(Test& t) {
  const GLubyte name[] = {1};
  refine();
  gl.DepthTag1i(1);
  compile_as(301, triangle);
  compile_as(401, [] {
    triangle();
    triangle();
  });
  gl.ListBase(300);
  compile_as(900, [] { gl.ListBase(400); });
  const auto call = [&name] { gl.CallLists(1, GL_UNSIGNED_BYTE, name); };
  t.expect_equal(count_generated(call), 4U, "triangles with the list base before the call");
  gl.CallList(900);
  t.expect_equal(count_generated(call), 8U, "triangles with the list base that the list sets");
  t.expect_no_error("the calls");
}

void check_pool_while_compiling(Test& t) {
  refine();
  gl.DepthTag1i(4);
  compile_as(1, [] {
    triangle();
    gl.ARKinit(2);
  });
  t.expect_equal(integer_of(GL_POOL_LEVEL_ARK), 2, "the level of ARKinit within a list");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "the tag, which is not above the level");
  gl.ARKinit(4);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "the tag with a deeper pool");
  t.expect_equal(count_generated(triangle), 16U, "triangles with this tag");
  gl.DepthTag1i(3);
  gl.CallList(1);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the list does not set it");
}

constexpr GLuint push_list = 11, pop_list = 12, both_list = 13, nested_push = 14, nested_pop = 15, other_push = 16;

void compile_stack_lists() {
  const GLubyte names[] = {pop_list - 10};
  compile_as(push_list, [] { gl.PushAttrib(GL_ENABLE_BIT); });
  compile_as(pop_list, [] { gl.PopAttrib(); });
  compile_as(both_list, [] {
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    triangle();
    gl.PopAttrib();
  });
  compile_as(nested_push, [] {
    gl.CallList(both_list);
    gl.CallList(push_list);
    triangle();
  });
  compile_as(nested_pop, [&] {
    triangle();
    gl.CallLists(1, GL_UNSIGNED_BYTE, names);  // with the list base at the time of the call
  });
  compile_as(other_push, [] { gl.PushAttrib(GL_CURRENT_BIT); });
}

// Pushes while ARK is `before`, sets ARK to the opposite, pops. Returns the state after that.
void expect_restored(Test& t, const std::function<void()>& push, const std::function<void()>& pop, bool is_saved,
                     const std::string& what) {
  for (const bool before : {true, false}) {
    before ? gl.Enable(GL_ARK) : gl.Disable(GL_ARK);
    push();
    before ? gl.Disable(GL_ARK) : gl.Enable(GL_ARK);
    gl.CallList(both_list);
    t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{!before},
                   what + ": a list that pushes and pops leaves ARK as it was");
    pop();
    t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{before == is_saved}, what + (before ? ", enabled" : ", disabled"));
    gl.Enable(GL_ARK);
    t.expect_equal(integer_of(GL_ATTRIB_STACK_DEPTH), 0, what + ": the depth of the stack");
  }
}

void check_stack(Test& t, bool is_compiled_late) {
  if (!is_compiled_late) compile_stack_lists();
  refine();
  if (is_compiled_late) compile_stack_lists();
  gl.ListBase(10);
  const auto call = [](GLuint list) { return [list] { gl.CallList(list); }; };
  const auto push = [] { gl.PushAttrib(GL_ENABLE_BIT); };
  const auto pop = [] { gl.PopAttrib(); };
  expect_restored(t, call(push_list), pop, true, "pushed by a list");
  expect_restored(t, push, call(pop_list), true, "popped by a list");
  expect_restored(t, call(push_list), call(pop_list), true, "pushed and popped by lists");
  expect_restored(t, call(nested_push), call(nested_pop), true, "pushed and popped by lists in lists");
  expect_restored(t, call(other_push), call(pop_list), false, "pushed by a list without ENABLE_BIT");
  const GLushort names[] = {push_list - 10, other_push - 10, pop_list - 10};
  expect_restored(
      t, [&] { gl.CallLists(3, GL_UNSIGNED_SHORT, names); }, pop, true, "pushed by CallLists");
  const auto compile_and_execute = [](GLuint list, const std::function<void()>& commands) {
    return [list, commands] {
      gl.NewList(list, GL_COMPILE_AND_EXECUTE);
      commands();
      gl.EndList();
    };
  };
  expect_restored(t, compile_and_execute(17, push), compile_and_execute(18, call(pop_list)), true,
                  "by lists that are compiled and executed");
  expect_restored(t, call(17), call(18), true, "by the same lists, called");
  t.expect_no_error("the calls");
}

// Draws whose vertices inherit the tag and a colour: with arrays, with Begin and End, and from a list.
void draw_arrays() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }
void call_triangle() { gl.CallList(31); }

void set_values(bool is_first) {
  gl.DepthTag1i(is_first ? 3 : 1);
  gl.Color4f(is_first ? 0.25F : 1, is_first ? 1 : 0.5F, 0.5F, 1);
  gl.MultiTexCoord2f(GL_TEXTURE1, is_first ? 0.5F : 0, 0);
  gl.VertexAttrib1f(at_extra, is_first ? 0.25F : 0.125F);
}

// PopAttrib restores values, in each way in which a list may execute it. No values are queried: an implementation may
// learn them so.
void check_popped(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 6) in float extra; out vec4 colour;\n"
                    "void main() { colour = gl_Color; colour.b = gl_MultiTexCoord1.x + extra;\n"
                    "  gl_Position = position; }\n"}));
  upload(one_triangle(), false);
  gl.DisableVertexAttribArray(at_extra);
  refine();
  const GLuint name = 32;
  compile_as(31, triangle);
  compile_as(32, [] { gl.PopAttrib(); });
  compile_as(33, [] { gl.CallList(32); });
  compile_as(34, [&] { gl.CallLists(1, GL_UNSIGNED_INT, &name); });
  compile_as(35, [] {
    gl.PopAttrib();
    triangle();
  });
  using Step = void (*)();
  const Step pops[] = {[] { gl.PopAttrib(); },
                       [] { gl.CallList(32); },
                       [] { gl.CallList(33); },
                       [] { gl.CallList(34); },
                       [] { gl.CallList(35); },
                       [] {
                         gl.NewList(36, GL_COMPILE_AND_EXECUTE);
                         gl.PopAttrib();
                         gl.EndList();
                       }};
  for (const Step draw : {Step{draw_arrays}, Step{triangle}, Step{call_triangle}}) {
    set_values(true);
    gl.Disable(GL_ARK);
    const Picture plain = picture_of(draw);
    gl.Enable(GL_ARK);
    for (std::size_t i = 0; i < std::size(pops); ++i)
      for (int again = 0; again < 2; ++again) {
        const std::string what = "after PopAttrib in way " + as_text(i);
        set_values(true);
        for (int times = 0; times < calls; ++times) draw();
        gl.PushAttrib(GL_CURRENT_BIT);
        set_values(false);
        t.expect_equal(count_generated(draw), 4U, "triangles with the other values");
        t.expect(count_different(picture_of(draw), plain, 8) > 300, "the other values show");
        pops[i]();
        t.expect_equal(count_generated(draw), 64U, "triangles " + what);
        t.expect_same_picture(picture_of(draw), plain, what, 2, 20);
      }
  }
  t.expect_no_error("the calls");
}

// GL stops at some depth of nesting, which may be any from 64 on.
void check_recursion(Test& t, bool by_base) {
  const GLubyte names[] = {2};
  refine();
  gl.Disable(GL_ARK);
  compile_as(12, [&] {
    triangle();
    by_base ? gl.CallLists(1, GL_UNSIGNED_BYTE, names) : gl.CallList(12);
  });
  gl.ListBase(10);
  const auto draw = [] { gl.CallList(12); };
  const GLuint plain = count_generated(draw);
  t.require(plain >= 1 && plain < 100000, "GL draws nested lists to some depth");
  gl.Enable(GL_ARK);
  for (const GLint tag : {1, 2}) {
    gl.DepthTag1i(tag);
    for (int again = 0; again < calls; ++again) {
      const GLuint refined = count_generated(draw);
      const GLuint lists = refined >> (2 * tag);  // one more or less may be nested
      t.expect(refined == lists << (2 * tag) && lists + 1 >= plain && lists <= plain + 1, "triangles of nested lists");
    }
  }
  t.expect_no_error("the calls");
}

constexpr Area list_case{.prefix = "ark.list.again.", .apis = compat_only};

}  // namespace

Cases repeated_lists_cases() {
  return {
      list_case("inherited", {"chapter-21-4", "chapter-21-5"},
                "Call a list that has only vertices with several colours and tags, four times each.",
                "The values of an earlier call.", check_inherited),
      list_case("left_behind", {"chapter-21-2", "10.R.1-13"},
                "Call a list that sets colours and tags before and between its vertices, and check the current values.",
                "Only the first calls leave the list's values.", check_left_behind),
      list_case("restored", {"chapter-22-1", "10.R.1-13"},
                "Call a list that pushes, sets a color and a tag and pops them; then draw.",
                "The list's values, which are gone.", [](Test& t) { check_restored(t, true); }),
      list_case("restored_outside", {"chapter-22-1", "10.R.1-13"},
                "Push, call a list that sets a color and a tag and pops them; then draw.",
                "The list's values, which are gone.", [](Test& t) { check_restored(t, false); }),
      list_case("names", {"chapter-21-4", "chapter-21-5"},
                "Call CallLists with names of each type, directly and from a list, with two list bases.",
                "Groups of bytes in the wrong order; the list base at compilation.", check_names),
      list_case("compiled_base", {"chapter-21-4"},
                "ListBase in a list: call CallLists before the list is called, and after.",
                "The base counts during compilation, or never.", check_compiled_base),
      list_case("recursion", {"chapter-21-4"}, "Call a list that calls itself by CallList.", "Fewer lists, or a crash.",
                [](Test& t) { check_recursion(t, false); }),
      list_case("recursion_by_base", {"chapter-21-4"}, "Call a list that calls itself by CallLists.",
                "Fewer lists, or a crash.", [](Test& t) { check_recursion(t, true); }),
      list_case("popped", {"chapter-22-2"},
                "Draw what inherits current values after PopAttrib, which lists execute in several ways.",
                "The values before PopAttrib, because no command sets others.", check_popped),
      list_case("pool", {"chapter-21-7", "11.R.1-6"}, "Call ARKinit with a lower level while a list is compiled.",
                "The current tag stays above the pool, or the list sets it.", check_pool_while_compiling),
      list_case(
          "attributes", {"chapter-22-1"},
          "PushAttrib and PopAttrib in lists, in lists that these call, and outside, with ARK changed in between.",
          "Changes that lists make to the stack are not noticed: ARK stays, or is that of another level.",
          [](Test& t) { check_stack(t, true); }),
      list_case("attributes_before_init", {"chapter-22-1"}, "The same lists, compiled before ARKinit.",
                "Lists that may be drawn unrefined are not inspected.", [](Test& t) { check_stack(t, false); })};
}

}  // namespace glark::conformance
