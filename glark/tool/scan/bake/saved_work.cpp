// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/bake/saved_work.h"

#include <span>
#include <utility>

namespace glark::tool {
namespace {

[[noreturn]] void fail(const std::string& problem) { throw WorkError(problem); }

common::WorkFolder open_folder(const std::filesystem::path& folder, const std::string& identity, bool resume) {
  if (resume && folder.empty())
    fail("--resume needs a file as the output; pipes and devices have no state of the work");
  if (resume) common::require_same_work(folder, identity, fail);
  return {folder, identity, resume, fail};
}

}  // namespace

SavedWork::SavedWork(const std::filesystem::path& folder, const std::string& identity, bool resume)
    : folder_(open_folder(folder, identity, resume)), resumes_(resume) {}

void SavedWork::save(const char* name, const geometry::Geometry& mesh, double noise) {
  folder_.save(name, [&](common::StateWriter& state) {
    state.put(noise);
    state.put(mesh.origin);
    state.put_all(std::span(mesh.positions));
    state.put_all(std::span(mesh.normals));
    state.put_all(std::span(mesh.triangles));
  });
}

bool SavedWork::load(const char* name, geometry::Geometry& mesh, double& noise) const {
  geometry::Geometry saved;
  double saved_noise = 0;
  const bool is_good = folder_.load(name, [&](common::StateReader& state) {
    return state.get(saved_noise) && state.get(saved.origin) && state.get_all(saved.positions) &&
           state.get_all(saved.normals) && state.get_all(saved.triangles);
  });
  if (!is_good) return false;
  mesh = std::move(saved);
  noise = saved_noise;
  return true;
}

}  // namespace glark::tool
