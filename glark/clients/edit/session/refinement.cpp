// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/session/refinement.h"

#include <fmt/format.h>
#include <glark/stream.h>

#include <algorithm>
#include <array>
#include <set>

namespace glark::edit {
namespace {

namespace fs = std::filesystem;

std::string before_name(std::size_t line) { return fmt::format("refined-{}.before.ply", line); }
std::string after_name(std::size_t line) { return fmt::format("refined-{}.after.ply", line); }

SamplingView view_of(const Sampling& sampling) { return {sampling.positions, sampling.normals, sampling.colours}; }

bool is_in(const Ball& ball, const double* position) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += (position[k] - ball.centre[k]) * (position[k] - ball.centre[k]);
  return square <= ball.radius * ball.radius;
}

std::size_t samples_in_ball(const Ball& ball, std::span<const double> positions) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    if (is_in(ball, &positions[i])) ++count;
  return count;
}

// Files that are removed in any case.
struct Removed {
  std::vector<fs::path> files;
  ~Removed() {
    std::error_code ignored;
    for (const fs::path& file : files) fs::remove(file, ignored);
  }
};

Refined samples_of(const Folder& folder, const fs::path& scan, const Refine& refine, const EditFiles& edit,
                   const Editor& editor, const SessionOptions& options) {
  const fs::path before = folder.path("more.before.ply"), after = folder.path("more.after.ply");
  const Removed removed{{before, after, before.string() + ".cells"}};
  stream::Region region;
  region.kind = stream::Region::Kind::sphere;
  region.centre = refine.ball.centre;
  region.radius = refine.ball.radius;
  stream::RefineOptions how;
  how.target = refine.most > 0 ? refine.most : 3 * samples_in_ball(refine.ball, editor.positions());
  how.memory = options.memory;
  how.threads = options.threads;
  stream::refine({scan, folder.path(cells_file), edit.before(), edit.after(), before, after}, region, how);
  return {read_sampling(before, editor.size()), read_sampling(after, editor.size())};
}

template <class Number>
void append(std::vector<Number>& to, const std::vector<Number>& from, std::size_t sample) {
  if (from.empty()) return;
  const auto first = from.begin() + static_cast<std::ptrdiff_t>(3 * sample);
  to.insert(to.end(), first, first + 3);
}

void append(Sampling& to, const Sampling& from, std::size_t sample) {
  append(to.positions, from.positions, sample);
  append(to.normals, from.normals, sample);
  append(to.colours, from.colours, sample);
}

std::array<double, 3> place_of(const Sampling& sampling, std::size_t sample) {
  return {sampling.positions[3 * sample], sampling.positions[3 * sample + 1], sampling.positions[3 * sample + 2]};
}

// Appends the samples that are not there and lie in none of the balls, whose samples are there. A sample of a ball may
// lie a little outside.
void append_others(Refined& to, const Refined& from, std::span<const Refine> balls) {
  std::set<std::array<double, 3>> places;
  for (std::size_t i = 0; i < to.after.positions.size() / 3; ++i) places.insert(place_of(to.after, i));
  for (std::size_t i = 0; i < from.after.positions.size() / 3; ++i) {
    const double* position = &from.after.positions[3 * i];
    const auto has_it = [&](const Refine& each) { return is_in(each.ball, position); };
    if (places.contains(place_of(from.after, i)) || std::any_of(balls.begin(), balls.end(), has_it)) continue;
    append(to.before, from.before, i);
    append(to.after, from.after, i);
  }
}

}  // namespace

EditFiles::EditFiles(const Folder& folder, const Editor& editor)
    : before_(folder.path("edit.before.ply")), after_(folder.path("edit.after.ply")) {
  write_sampling(before_, {editor.positions_before(), editor.normals_before(), editor.colours_before()});
  write_sampling(after_, {editor.positions(), editor.normals(), editor.colours()});
}

EditFiles::~EditFiles() {
  std::error_code ignored;
  fs::remove(before_, ignored);
  fs::remove(after_, ignored);
}

Refined take_samples(const Folder& folder, const fs::path& scan, std::span<const Refine> balls, std::size_t line,
                     const Editor& editor, const SessionOptions& options) {
  const EditFiles edit(folder, editor);
  Refined refined;
  for (std::size_t k = 0; k < balls.size(); ++k)
    if (k == 0 || samples_in_ball(balls[k].ball, editor.positions()) > 0)  // a mirrored ball may be beside the scan
      append_others(refined, samples_of(folder, scan, balls[k], edit, editor, options), balls.first(k));
  write_sampling(folder.path(before_name(line)), view_of(refined.before));
  write_sampling(folder.path(after_name(line)), view_of(refined.after));
  folder.keep(before_name(line));
  folder.keep(after_name(line));
  return refined;
}

Refined kept_samples(const Folder& folder, std::size_t line) {
  for (const std::string& name : {before_name(line), after_name(line)})
    if (!fs::is_regular_file(folder.path(name)))
      throw Error(Element::file, line, folder.path(name).string() + ": is missing; restore this file of the session");
  return {read_sampling(folder.path(before_name(line))), read_sampling(folder.path(after_name(line)))};
}

}  // namespace glark::edit
