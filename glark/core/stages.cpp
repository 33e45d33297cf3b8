// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/stages.h"

namespace glark::core {

Stages::Stages(const Environment& environment)
    : env_(environment),
      pool_(env_),
      capture_(env_),
      programs_(env_, capture_.stage()),
      passes_(env_, pool_, capture_),
      kept_(env_),
      meshes_(env_),
      planner_(env_, {pool_, capture_, programs_, passes_.weld_stage(), feedback_in_use_, meshes_}),
      feedback_(env_, feedback_in_use_, planner_, programs_.in_use()),
      draw_(env_, {pool_, planner_, capture_, kept_, programs_, passes_, feedback_in_use_, feedback_, meshes_}) {}

// Adds the counts that only the GPU knows to the statistics.
void Stages::read_counts() {
  if (!env_.options.read_counts) {
    return;
  }
  ErrorScope errors(env_.errors);
  capture_.read_uncounted();
  passes_.sorter().read_counts();
}

// Between glBegin and glEnd, GL answers no queries: the bindings are not read again.
void Stages::frame_finished() {
  const Quiet quiet(env_.gl, env_.bindings().debug_output);
  read_counts();
  passes_.sorter().frame_finished();
  kept_.frame_finished();
  draw_.frame_finished();
  meshes_.frame_finished();
  env_.compilation.frame_finished();
  ends_frames_ = true;
}

void Stages::pixels_read() {
  if (!ends_frames_) {
    meshes_.frame_finished();
    env_.compilation.frame_finished();
  }
}

void Stages::release() {
  const Quiet quiet(env_.gl, env_.bindings().debug_output);
  ErrorScope errors(env_.errors);
  read_counts();
  programs_.release();
  kept_.release();
  draw_.release();
  capture_.release();
  passes_.release();
  env_.compilation.release();
  env_.state.programs().pipelines().release();
  pool_.release();
}

}  // namespace glark::core
