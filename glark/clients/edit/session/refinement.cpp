// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/session/refinement.h"

#include <fmt/format.h>
#include <glark/stream.h>

namespace glark::edit {
namespace {

namespace fs = std::filesystem;

std::string before_name(std::size_t line) { return fmt::format("refined-{}.before.ply", line); }
std::string after_name(std::size_t line) { return fmt::format("refined-{}.after.ply", line); }

SamplingView view_of(const Sampling& sampling) { return {sampling.positions, sampling.normals, sampling.colours}; }

std::size_t samples_in_ball(const Ball& ball, std::span<const double> positions) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square += (positions[i + k] - ball.centre[k]) * (positions[i + k] - ball.centre[k]);
    if (square <= ball.radius * ball.radius) ++count;
  }
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

Refined take_samples(const Folder& folder, const fs::path& scan, const Refine& refine, std::size_t line,
                     const Editor& editor, const SessionOptions& options) {
  const EditFiles edit(folder, editor);
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
  Refined refined{read_sampling(before, editor.size()), read_sampling(after, editor.size())};
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
