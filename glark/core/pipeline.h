// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw call from end to end: capture, edge depths and bins, derived program, submit, restore.
#pragma once

#include <bitset>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "glark/core/capture/capture.h"
#include "glark/core/capture/feedback_aside.h"
#include "glark/core/depth/bins.h"
#include "glark/core/depth/centroid_split.h"
#include "glark/core/depth/measure.h"
#include "glark/core/depth/ordered.h"
#include "glark/core/draw_cache.h"
#include "glark/core/draw_call.h"
#include "glark/core/draw_key.h"
#include "glark/core/draw_plan.h"
#include "glark/core/pattern/gpu_pool.h"
#include "glark/core/refine/fixed_function/state.h"
#include "glark/core/refine/program/program_builder.h"
#include "glark/core/report.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/submit/submit.h"
#include "glark/core/weld/weld.h"

namespace glark::core {

class Context;

class Pipeline {
 public:
  explicit Pipeline(Context& context);
  // glARKinit: false without memory; the old pool is then kept.
  bool build_pool(unsigned max_level);
  // Draws refined, or as the application asked; counts either.
  void draw(const DrawCall& call);

  // glBegin..glEnd in a mode of triangles: how many triangles fit. 0: the caller begins as the application asked.
  std::uint64_t begin_immediate(GLenum mode);
  void end_immediate(std::uint64_t triangles);

  // The application's transform feedback, when it enabled GL_ARK itself: it captures refined triangles. False: nothing was done.
  bool begin_feedback(GLenum mode);
  // Begun while GL_ARK was disabled: if the first draw is glDrawARP, that takes it over.
  void await_feedback(GLenum mode) { awaited_feedback_ = mode; }
  void end_feedback();
  // Before a draw that stays as it is: unless refined triangles were captured, it is captured, and so is all that follows.
  void hand_back_feedback();
  bool watches_feedback() const { return owns_feedback() || awaited_feedback_ != GL_NONE; }
  // As it begins: notes how many vertices the buffers hold, for draws of them.
  void note_feedback_room();
  // Vertices that a draw from that transform feedback object can have at most; nothing if glark has not seen it begun.
  std::optional<std::uint64_t> feedback_vertices(GLuint object) const;
  // The driver does not see the conflict, as ours is paused between our draws.
  bool feedback_refuses(GLenum mode) const;
  bool owns_feedback() const { return feedback_program_ != nullptr; }
  // The program of the feedback is the one for tags that vary: all its draws go that way.
  bool feedback_tagged() const { return owns_feedback() && feedback_program_->layout.tagged; }

  // The derived program for the state of now, for GL_REFINEMENT_STATUS_ARK; null if it cannot be built.
  std::shared_ptr<DerivedProgram> derived_for(Program& program, Program* owner);
  Program* program_for_refinement(GLuint name);  // 0: fixed function
  void set_fixed_function_refinement(std::string source);
  const std::string& fixed_function_refinement() const { return fixed_function_refinement_; }
  void forget_program(GLuint name);  // linked again or deleted
  void discard(Program& program);

  void tag_attribute_changed();  // captures read the tag from another attribute

  void count_passed(Cause cause);
  void frame_finished();
  void release();
  std::vector<GLuint> take_kept_buffers();  // for whoever deletes them

 private:
  using Plan = DrawPlan;

  struct CaptureProgram {
    GLuint name = 0;
    std::vector<int> inputs;  // attributes that it reads, by AttributeSlot
  };
  void take_awaited_feedback();
  Cause check_state(const DrawCall& call, bool for_feedback) const;
  Cause plan_draw(const DrawCall& call, Plan& plan);
  Cause find_derived(const DrawCall& call, Plan& plan);
  std::shared_ptr<DerivedProgram> derived_program(const Plan& plan, const DerivedKey& key);
  const CaptureProgram& capture_program_for(const std::shared_ptr<DerivedProgram>& derived);
  Cause find_program(Plan& plan);
  Cause find_pipeline_program(Plan& plan);
  void read_subroutines(const Plan& plan);
  void use_derived(const Plan& plan);
  void use_application_program();  // with its pipeline and subroutines, after programs of ours
  bool leaves_draws() const;
  Cause exemption(const Program& program, std::uint64_t triangles);  // `triangles`: 0 before they are counted
  void count_refined(const Plan& plan);
  refine::FragmentReads fragment_reads(const Program* fragment) const;
  Program* fixed_function_program(Program* fragment);
  void discard_fixed_function(GLuint fragment, Program& program);
  unsigned current_tag() const;
  void plan_depth(const DrawCall& call, Plan& plan) const;
  void plan_wanted_depth(const DrawCall& call, Plan& plan) const;
  EdgeMeasure measure() const;  // off: depths come from elsewhere
  bool can_measure(const Program& program) const;
  Cause plan_measure(Plan& plan);
  bool captures_last_vertex(GLenum mode) const;
  bool splits_at_centroid(const DrawCall& call, const Plan& plan) const;
  std::optional<depth::Decomposition> decomposition_for(GLenum mode, bool last_vertex_convention);
  std::vector<float> probe(GLenum mode, bool last_vertex_convention);
  bool ready_to_split(const Plan& plan, const depth::SplitRequest& request);
  DerivedKey key_of(GLenum mode, bool tagged, bool placed) const;
  void read_uncounted();
  void read_counts();
  void begin_capture(const Plan& plan, capture::Count count, GpuBuffer* own);
  capture::CoarseTriangles end_capture(const Plan& plan, std::uint64_t triangles, bool exact);
  void add_surplus(std::int64_t triangles);  // to what our captures have added to the application's queries
  bool ensure_pool();
  void plan_weld(Plan& plan, DerivedKey key, std::uint64_t triangles);
  void weld(const Plan& plan, const capture::CoarseTriangles& triangles, const GpuBuffer& count, bool split);
  bool has_adaptive_room(const Plan& plan, std::uint64_t triangles) const;
  bool ensure_bins(const Plan& plan, std::uint32_t triangles);
  Cause ensure_room(const Plan& plan, std::uint64_t triangles);
  // What a draw keeps for the next time, or has kept.
  struct Keeping {
    DrawCache::Entry* entry = nullptr;
    bool filled = false;
  };
  bool add_array_inputs(const Plan& plan, const ArrayDraw& draw);
  bool add_segment_inputs(const Plan& plan, const ListSegment& segment);
  void add_welded_words(const Plan& plan);
  bool make_key(const DrawCall& call, const Plan& plan);
  Keeping look_up(const DrawCall& call, const Plan& plan);
  capture::CoarseTriangles capture_draw(const DrawCall& call, const Plan& plan, Keeping& keeping, const Quiet& quiet);
  // What is drawn: the captured triangles, or those about the centroids of their polygons.
  struct Records {
    capture::CoarseTriangles triangles;
    const GpuBuffer* count_command = nullptr;
    bool tags_are_edge_depths = false;
  };
  Records records_of(const Plan& plan, const capture::CoarseTriangles& captured);
  bool takes_in_order(const Plan& plan, const capture::CoarseTriangles& triangles) const;
  depth::BinnedInstances sort(const Plan& plan, const Records& records);
  depth::BinnedInstances binned(const Plan& plan, const Records& records, const Keeping& keeping);
  void submit(const Plan& plan, const capture::CoarseTriangles& captured, const Keeping& keeping);
  bool selects_back_colors(const Plan& plan) const;
  bool adds_specular_colors(const Plan& plan) const;
  bool sets_point_size(const Plan& plan) const;
  void set_point_size(bool by_program);
  void set_modes(const Plan& plan);  // that the refined draw needs otherwise than the application has them
  void reset_modes(const Plan& plan);
  bool takes_edge_flags() const;  // by the application's modes
  void raise_edge_flag();         // every edge of a refined triangle is a boundary edge
  void reset_edge_flag();
  struct Changed {
    bool indirect = false;
    bool storage = false;
  };
  void restore(const Changed& changed);
  void restore_storage();
  void copy_stale_uniforms(const Plan& plan);

  Context& context_;
  const gl::Dispatch& gl_;
  pattern::GpuPool pool_;
  capture::CaptureStage capture_;
  DrawCache kept_;
  DrawKey key_;  // scratch
  weld::WeldStage weld_;
  depth::CentroidSplit centroids_;
  depth::MeasureStage measure_;
  depth::BinStage bins_;
  depth::OrderedStage ordered_;
  submit::SubmitStage submit_;
  refine::ProgramBuilder builder_;
  std::map<std::pair<refine::FixedFunctionState, GLuint>, std::shared_ptr<Program>> fixed_function_;
  refine::FixedFunctionState fixed_function_state_;
  GLuint fixed_function_fragment_ = 0;
  std::string fixed_function_refinement_;
  Plan immediate_plan_;
  bool immediate_exact_ = true;                              // its number of triangles is known without a query
  std::uint64_t immediate_bytes_ = std::uint64_t{32} << 20;  // grows where a strip or fan did not fit
  std::shared_ptr<DerivedProgram> feedback_program_;
  GLenum feedback_mode_ = GL_NONE;
  bool feedback_begun_ = false;  // it has captured
  GLenum awaited_feedback_ = GL_NONE;
  std::unordered_map<GLuint, std::uint64_t> feedback_vertices_;  // by transform feedback object
  using Drawing = std::pair<GLenum, GLenum>;                     // mode, provoking convention
  std::map<Drawing, std::optional<depth::Decomposition>> decompositions_;
  std::bitset<cause_count> logged_;
  // Of this context alone: Mesa 22 does not bear one program drawing in two threads, where the application has two.
  std::map<std::weak_ptr<const DerivedProgram>, CaptureProgram, std::owner_less<>> capture_programs_;
  std::uint64_t pools_built_ = 0;
  bool bins_ready_ = false;
  bool pool_failed_ = false;
  bool counted_on_gpu_ = false;     // adaptive draws since the last reading
  bool uncounted_capture_ = false;  // a uniform draw whose number of triangles the query holds
  unsigned uncounted_level_ = 0;
  bool split_failed_ = false;
  bool storage_changed_ = false;  // by a weld, since it was restored
  bool edge_flag_raised_ = false;
};

}  // namespace glark::core
