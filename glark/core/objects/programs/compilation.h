// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// When a context compiles the programs of glark. Some drivers need seconds for all of them. At the spread pace, a frame
// compiles for a limited time; the draws that need more stay unrefined in this frame.
#pragma once

#include <cstddef>
#include <set>
#include <span>

#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/report/compile_progress.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

enum class CompilePace { at_once, spread };

class Compilation {
 public:
  // `now`: a clock, in seconds.
  using Clock = double (*)();
  explicit Compilation(const gl::Dispatch& gl, Clock now = seconds_now) : gl_(gl), now_(now) {}

  const gl::Dispatch& gl() const { return gl_; }
  CompilePace pace() const { return pace_; }
  void set_pace(CompilePace pace) { pace_ = pace; }
  void begin_draw(CompilePace pace) {
    pace_ = pace;
    refused_ = false;
  }

  // Returns whether the program `which` may be compiled now. The address tells programs apart.
  bool may_begin(const void* which);
  // Returns whether a program of this draw must wait for the next frame.
  bool refused() const { return refused_; }

  // Compiles the pass unless that has failed before. Returns whether it is built. Wrap in an ErrorScope.
  bool build(ComputePass& pass, const ComputeText& text, std::span<const char* const> uniforms);

  // Repeats a step that needs several passes, until all of them are compiled. So the log knows how many are missing.
  template <class Reserve>
  bool at_once(const Reserve& reserve) {
    const CompilePace pace = pace_;
    bool done = false;
    do {
      begin_turn();
      done = reserve();
    } while (refused_);
    pace_ = pace;
    return done;
  }

  // Measures a program while it lives: one that is compiled, or the first draw with it.
  class Step {
   public:
    enum class Kind { program, first_draw };
    explicit Step(Compilation& compilation, Kind kind = Kind::program)
        : compilation_(compilation), kind_(kind), begin_(compilation.now_()) {}
    ~Step() { compilation_.note(compilation_.now_() - begin_, kind_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Compilation& compilation_;
    Kind kind_;
    double begin_;
  };

  void frame_finished();
  // Returns whether a frame has ended.
  bool has_shown_frame() const { return shown_frame_; }
  void release();

  static double seconds_now();
  static constexpr double seconds_a_frame = 0.02;

 private:
  void begin_turn();
  void note(double seconds, Step::Kind kind);
  void warm_up(const ComputePass& pass);

  const gl::Dispatch& gl_;
  Clock now_;
  CompilePace pace_ = CompilePace::at_once;
  bool in_turns_ = false;
  bool refused_ = false;
  bool shown_frame_ = false;
  double seconds_ = 0;             // of this frame
  std::size_t programs_ = 0;       // of this frame
  std::set<const void*> waiting_;  // known to be needed
  CompileProgress progress_;
  GLuint no_groups_ = 0;  // a buffer with the command that dispatches nothing
};

}  // namespace glark::core
