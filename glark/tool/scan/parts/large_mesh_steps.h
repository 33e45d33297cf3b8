// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The steps of reading a large mesh that are the same for one process and for several.
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "glark/tool/scan/parts/cluster_mesh.h"
#include "glark/tool/scan/parts/large_mesh.h"

namespace glark::tool {

// What the file has. Warns of attributes that are lost. Throws std::runtime_error for a file that can be read only once.
Report contents_of_large(const Files& files);
// Whether some attribute of the contents has this name.
bool has_attribute(const Report& contents, const char* name);

// The folder for temporary files.
std::filesystem::path folder_of(const Files& files);

// How many samples to take. Throws std::runtime_error if the memory is too small for the target.
std::size_t sample_count(const Files& files, const PartsOptions& options);
stream::SampleOptions sampling_options(const Files& files, std::size_t target, const PartsOptions& options);
// A writer that adds points to the geometry.
std::unique_ptr<stream::PointWriter> writer_to(geometry::Geometry& geometry, const stream::Schema& schema);

// Reads all points and triangles, one after the other.
void add_triangles(const Files& files, const Report& contents, ClusterMesh& mesh);
// The mesh of the samples that triangles have.
geometry::Geometry without_lonely_samples(const geometry::Geometry& samples, std::vector<std::uint32_t> triangles);

}  // namespace glark::tool
