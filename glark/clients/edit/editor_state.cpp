// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/editor_state.h"

#include <fmt/format.h>

#include "glark/clients/edit/brush/mirror.h"
#include "glark/clients/edit/brush/motion.h"
#include "glark/clients/edit/brush/paint.h"
#include "glark/clients/edit/shape/turned_normals.h"

namespace glark::edit {
namespace {

[[noreturn]] void fail(const std::string& problem) { throw Error(Element::operation, 0, problem); }

std::string text_of(const Vector3d& v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

[[noreturn]] void fail_without_samples(const Ball& ball, const Samples& now) {
  Vector3d low = now.position(0), high = low;
  for (std::size_t i = 1; i < now.size(); ++i) {
    low = common::least(low, now.position(i));
    high = common::greatest(high, now.position(i));
  }
  fail(fmt::format("no sample is within {:.6g} of {}; the samples lie from {} to {}", ball.radius,
                   text_of(common::to_vector(ball.centre)), text_of(low), text_of(high)));
}

// The ball without whose samples an operation does nothing.
template <class Kind>
const Ball* ball_of(const Kind& operation) {
  if constexpr (requires { operation.ball; }) return &operation.ball;
  if constexpr (requires { operation.handle; }) return &operation.handle;
  return nullptr;
}

bool has_samples(const Ball& ball, const Samples& now) {
  for (std::size_t i = 0; i < now.size(); ++i)
    if (common::squared_distance(now.position(i), common::to_vector(ball.centre)) <= ball.radius * ball.radius)
      return true;
  return false;
}

// The samples that moved, and those beside them.
std::vector<std::uint32_t> around(const std::vector<std::uint32_t>& moved, const Graph& graph) {
  std::vector<bool> is_found(graph.size());
  for (const std::uint32_t i : moved) {
    is_found[i] = true;
    for (const std::uint32_t j : graph.of(i)) is_found[j] = true;
  }
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < is_found.size(); ++i)
    if (is_found[i]) found.push_back(static_cast<std::uint32_t>(i));
  return found;
}

void check_positions(const std::vector<Vector3d>& positions) {
  constexpr double most = 1e18;
  for (const Vector3d& p : positions)
    if (!(std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most))
      fail(fmt::format("a sample would move to {}; use smaller numbers", text_of(p)));
}

Samples samples_of(const Sampling& added, const Samples& rest) {
  Samples samples{added.positions, added.normals, added.colours};
  if (samples.normals.empty()) samples.normals = rest.normals;
  if (samples.colours.empty()) samples.colours = rest.colours;
  constexpr std::uint8_t white = 255;
  samples.colours.resize(samples.positions.size(), white);
  samples.normals.resize(samples.positions.size());
  return samples;
}

Change change_of_colours(Colouring colouring) {
  Change change;
  change.painted = std::move(colouring.samples);
  change.colours = std::move(colouring.colours);
  change.has_colours = true;
  return change;
}

}  // namespace

Change Editor::State::change_of(const Paint& paint) const {
  return change_of_colours(colouring_of(with_mirror(paint, symmetric), shape.now));
}

Change Editor::State::change_of(const Project& project) const {
  const Colouring colouring = colouring_of(project, symmetric, shape.now);
  if (colouring.samples.empty()) fail("project: the picture meets no sample; write another EYE, TARGET or DEGREES");
  return change_of_colours(colouring);
}

template <class Kind>
Change Editor::State::change_of(const Kind& operation) const {
  const std::vector<Kind> both = with_mirror(operation, symmetric);
  Motion motion = motion_of(std::span<const Kind>(both), shape);
  check_positions(motion.positions);
  Change change;
  change.moved = std::move(motion.samples);
  change.positions = std::move(motion.positions);
  change.has_colours = shape.has_colours;
  return change;
}

Change Editor::State::change_of(const Refine& refine) const {
  if (!options.refine) fail("refine: the sampling has no scan; open a session");
  if (!shape.triangles.empty()) fail("refine: the sampling has triangles; refine one without");
  const Refined refined = options.refine(with_mirror(refine, symmetric));
  Change change;
  change.has_colours = shape.has_colours;
  change.first = shape.size();
  change.added_before = samples_of(refined.before, {});
  for (std::size_t i = 0; i < change.added_before.size(); ++i)
    change.added_before.set_normal(i, common::unit(change.added_before.normal(i)));
  change.added = samples_of(refined.after, change.added_before);
  return change;
}

// The change is done, and its positions are those before.
void Editor::State::turn_normals(Change& done) {
  done.turned = around(done.moved, shape.graph);
  for (std::uint64_t i = done.first; done.added.size() > 0 && i < shape.size(); ++i)
    done.turned.push_back(static_cast<std::uint32_t>(i));
  done.normals = turned_normals(shape, done.turned, workers);
  if (done.added.size() > 0) {  // the new samples are not there before; they have their normals from now on
    for (std::size_t k = 0; k < done.turned.size(); ++k) done.added.set_normal(k, done.normals[k]);
    done.turned.clear();
    done.normals.clear();
    shape.now.cut(done.first);
    shape.now.append(done.added);
    return;
  }
  for (std::size_t k = 0; k < done.turned.size(); ++k) {
    const Vector3f old = shape.now.normal(done.turned[k]);
    shape.now.set_normal(done.turned[k], done.normals[k]);
    done.normals[k] = old;
  }
}

template <class Kind>
void Editor::State::do_it(const Kind& operation) {
  const Ball* ball = ball_of(operation);
  if (ball != nullptr && !has_samples(*ball, shape.now)) fail_without_samples(*ball, shape.now);
  Change change = change_of(operation);
  exchange(change, shape, workers);
  turn_normals(change);
  try {
    history.add(bytes_of(change));
  } catch (...) {
    exchange(change, shape, workers);
    throw;
  }
}

void Editor::State::move_in_history(std::vector<char> bytes, void (History::*move)(std::span<const char>)) {
  Change change = edit::change_of(bytes);
  exchange(change, shape, workers);
  try {
    (history.*move)(bytes_of(change));
  } catch (...) {
    exchange(change, shape, workers);
    throw;
  }
}

void Editor::State::do_it(const Undo& /*undo*/) {
  if (history.undo_count() == 0) fail("undo: there is no operation before");
  move_in_history(history.last_done(), &History::undo);
}

void Editor::State::do_it(const Redo& /*redo*/) {
  if (history.redo_count() == 0) fail("redo: no operation is undone");
  move_in_history(history.first_undone(), &History::redo);
}

void Editor::State::apply(const Operation& operation) {
  std::visit([&](const auto& each) { do_it(each); }, operation);
}

}  // namespace glark::edit
