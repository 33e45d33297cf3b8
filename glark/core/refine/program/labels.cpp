// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/labels.h"

#include <fmt/format.h>

#include <map>

#include "glark/core/report/shown_shader.h"

namespace glark::refine {
namespace {

std::string_view stage_name(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER: return "vert";
    case GL_TESS_CONTROL_SHADER: return "tesc";
    case GL_TESS_EVALUATION_SHADER: return "tese";
    case GL_GEOMETRY_SHADER: return "geom";
    case GL_FRAGMENT_SHADER: return "frag";
    default: return "comp";
  }
}

void show(const core::Program& program, GLenum stage, std::string_view kind, unsigned object,
          const std::string& source) {
  core::show_shader({program.hash, program.fixed_function ? 0 : program.name, stage_name(stage), kind, object, source});
}

// The choices of the key, in a fixed order: "pn-tagged-welded-placed".
std::string kind_of(const core::DerivedKey& key) {
  if (key.at_corner) return "corners";
  const core::RefinementTraits& traits = core::traits_of(key.refinement);
  std::string kind(traits.word);
  kind += key.displaced ? "-displaced" : "";
  kind += key.normal_attribute == core::made_normal ? "-made" : "";
  kind += key.normal_attribute != core::own_normal ? "-normal" : "";
  kind += key.tagged ? "-tagged" : "";
  kind += key.welded && traits.curves_positions ? "-welded" : "";
  kind += key.border ? "-border" : "";
  kind += key.placed ? "-placed" : "";
  kind += key.at_points ? "-points" : "";
  kind += key.morphing ? "-morphing" : "";
  kind += key.flat_colors ? "-flat" : "";
  kind += key.provoking_corner == 0 ? "-first" : "";
  kind += key.clamp_colors ? "" : "-unclamped";
  return kind;
}

}  // namespace

std::string label(const core::Program& program) {
  const std::string name = program.fixed_function ? "fixed function"
                           : program.assembly     ? "assembly program"
                                                  : fmt::format("program {}", program.name);
  return fmt::format("{} [{}]", name, core::hash_text(program.hash));
}

void show_originals(const core::Program& program) {
  std::map<GLenum, unsigned> objects;
  for (const core::StageSource& stage : program.stages) {
    show(program, stage.stage, "original", objects[stage.stage]++, *stage.source);
  }
}

void show_derived(const core::Program& program, const core::DerivedKey& key,
                  const std::vector<std::string>& vertex_sources) {
  if (!core::wants_shaders()) return;
  for (std::size_t i = 0; i < vertex_sources.size(); ++i) {
    show(program, GL_VERTEX_SHADER, kind_of(key), static_cast<unsigned>(i), vertex_sources[i]);
  }
}

}  // namespace glark::refine
