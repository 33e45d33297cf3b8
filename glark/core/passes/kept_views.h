// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A measured draw that is seen from the same place again keeps its instances: its depths are the same, too. The view is
// the same if the uniforms that positions depend on have the same values. Positions that depend on textures, blocks or
// built-in uniforms may change unseen: their draws are measured each time.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "glark/core/depth/instance_sorter.h"
#include "glark/core/keep/kept_draws.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class KeptViews {
 public:
  KeptViews(const Environment& environment, KeptDraws& kept) : env_(environment), kept_(kept) {}

  // Before a draw: compares its view with that of its last draw, and drops the instances of another view.
  void follow(const DrawPlan& plan, const KeptDraw& kept);
  // Returns whether the instances of the draw should be kept now.
  static bool wants(const DrawPlan& plan, const KeptDraw& kept);
  void keep(const KeptDraw& kept, const depth::BinnedInstances& sorted, const depth::InstanceExtent& extent) {
    kept_.keep_view(*kept.entry, sorted, extent, env_.state.stamps().next());
  }

 private:
  // The uniforms of a program that gives positions on the screen.
  struct Positions {
    bool watched = false;  // nothing that they depend on changes unseen
    std::vector<GLint> locations;
  };
  const Positions& positions_of(const DrawPlan& plan);
  // Nothing: something that the depths depend on may change unseen.
  std::optional<ViewKey> key_of(const DrawPlan& plan);
  bool same_uniforms(const DrawPlan& plan, ViewUniforms& uniforms);
  void read_values(const DrawPlan& plan);

  const Environment& env_;
  KeptDraws& kept_;
  std::map<std::weak_ptr<const DerivedProgram>, Positions, std::owner_less<>> positions_;
  std::vector<std::uint32_t> values_;  // scratch
};

}  // namespace glark::core
