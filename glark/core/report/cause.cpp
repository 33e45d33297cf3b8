// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/cause.h"

#include <array>

namespace glark::core {
namespace {

constexpr std::array<CauseText, cause_count> cause_texts{{
    {"not_triangles", "the draw has no triangles (points, lines, patches or adjacency)", "nothing to do"},
    {"level_zero",
     "every edge has depth 0 and the refinement is a built-in one: the coarse triangle is the refined one",
     "raise the level"},
    {"no_program", "no program is in use whose sources glark has seen",
     "link programs from GLSL source while glark is loaded"},
    {"program_not_derived", "no refinement program could be derived from the application's",
     "see the log line of the program"},
    {"program_pipeline", "the program pipeline has no vertex stage whose source glark has seen",
     "give it a vertex program linked from GLSL source while glark is loaded"},
    {"program_gone", "the program in use was deleted, or its last link failed: OpenGL cannot return to it",
     "delete programs after their last draw"},
    {"program_binary", "the program was loaded from a binary, or from SPIR-V",
     "make the application compile its shaders from GLSL"},
    {"assembly_program",
     "an ARB assembly vertex program is enabled that glark cannot translate, or that belongs to a program which uses "
     "the "
     "extension itself",
     "see the log line of the program; use GLSL"},
    {"tessellation", "the application tessellates by itself", "nothing to do"},
    {"too_many_attributes", "the vertex attributes of three corners do not fit into the attributes of one instance",
     "use fewer or smaller attributes"},
    {"primitive_id", "a fragment or geometry shader reads gl_PrimitiveID, which would number refined triangles",
     "refine the program by its own calls of the extension"},
    {"cull_distance", "a later stage reads gl_CullDistance, whose values differ in refined triangles",
     "pass the distance in an output of its own"},
    {"materials_vary",
     "a display list calls glMaterial between the vertices, and the first ones have the material of the caller",
     "set the material before the first vertex, or use glColorMaterial and glColor"},
    {"geometry_shader", "the geometry shader places its triangles by itself, or reads integers of every vertex",
     "nothing to do"},
    {"side_effects", "the vertex stage writes to buffers, images or counters, once per vertex of the application",
     "move the writes to another draw"},
    {"transform_feedback", "the application captures transform feedback",
     "nothing to do; a program that calls the extension ends the feedback before it changes refinement parameters"},
    {"primitive_query", "the application counts primitives or pipeline statistics", "nothing to do"},
    {"polygon_mode", "the application draws polygons, or one side of them, as lines or points",
     "nothing to do; --wireframe shows refined triangles"},
    {"render_mode", "selection or feedback is on", "nothing to do"},
    {"rasterizer_discard", "nothing is rasterised", "nothing to do"},
    {"indirect_unbounded", "the number of vertices is known to the GPU only, and has no bound",
     "use an indirect draw with a known count"},
    {"invalid_draw", "OpenGL refuses the call", "see the application's glGetError"},
    {"out_of_memory", "no memory for the coarse triangles of the draw", "draw fewer triangles a call"},
    {"left_shader", "the user named the shader program to be left alone", "take its hash out of leave-shaders"},
    {"rule", "a rule of the configuration file leaves such draws alone", "change the [[rule]] with refine = \"none\""},
    {"screen_quad",
     "one or two triangles that neither read nor write depth are taken for a full-screen pass or a user interface",
     "--everything, or --leave-draws without screen-quads"},
    {"overlay", "what is blended and neither reads nor writes depth is taken for a user interface",
     "--everything, or --leave-draws without overlays"},
    {"orthographic",
     "what the fixed function draws without perspective and without depth is taken for a user interface",
     "--everything, or --leave-draws without orthographic"},
    {"blended", "the user wants blended draws to be left alone", "take blended out of leave-draws"},
    {"no_depth_test", "the user wants draws without depth test to be left alone",
     "take no-depth-test out of leave-draws"},
    {"no_depth_writes", "the user wants draws that write no depth to be left alone",
     "take no-depth-writes out of leave-draws"},
    {"no_surface",
     "smooth curves only what is known to be a surface: the vertices have no normals of their own, the vertex stage "
     "cannot run between them, or glBegin..glEnd draws a single polygon",
     "--normal if the normal was not found; --normals geometry makes normals; --refine pn, linear or outputs refines "
     "such draws, too"},
    {"mesh_waits", "smooth curves a mesh when two frames have shown all passes over it",
     "nothing to do; --refine pn curves at once"},
    {"mesh_flat", "another pass over the same mesh cannot be curved, and a mesh has one shape",
     "--refine pn curves every pass by itself"},
    {"unknown_partner",
     "a pass that cannot be curved must meet another mesh in depth, and glark does not know which one",
     "--refine pn curves every pass by itself"},
    {"compiling", "glark compiles a few of its shader programs in each frame, and the draw needs more of them",
     "nothing to do; --wait compiles at once"},
    {"budget", "--budget goes to what shows: the draw is a background, or it cannot be curved", "run without --budget"},
}};

}  // namespace

const CauseText& text_of(Cause cause) { return cause_texts.at(static_cast<std::size_t>(cause)); }

}  // namespace glark::core
