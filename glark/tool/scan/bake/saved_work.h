// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The folder MODEL.glb.partial: what `glark bake --resume` continues from.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "glark/clients/common/resume/work_folder.h"
#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// The folder cannot be written, or has other work.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Its functions throw WorkError.
class SavedWork {
 public:
  // folder: empty for no folder. identity: the input and the options, a line for each. With `resume`, the folder must not
  // have other work.
  SavedWork(const std::filesystem::path& folder, const std::string& identity, bool resume);

  bool resumes() const { return resumes_; }
  // The folder for the state of a part of the work; empty for no folder.
  std::filesystem::path part(const std::string& name) const { return folder_.inner(name); }
  // The positions, normals and triangles of a mesh. noise: of its points.
  void save(const char* name, const geometry::Geometry& mesh, double noise);
  bool load(const char* name, geometry::Geometry& mesh, double& noise) const;
  // The model is written: removes the folder.
  void finish() { folder_.finish(); }

 private:
  common::WorkFolder folder_;
  bool resumes_;
};

}  // namespace glark::tool
