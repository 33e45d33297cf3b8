// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/mpi/rank_mesh.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/ranks/sample/sample.h"
#include "glark/tool/mpi/face_records.h"
#include "glark/tool/scan/info/contents.h"
#include "glark/tool/scan/parts/large_mesh_steps.h"
#include "glark/tool/scan/parts/sample_search.h"
#include "glark/tool/scan/parts/sheets.h"

namespace glark::tool {
namespace {

using stream::together;

constexpr std::uint64_t vertices_a_step = 3 << 10;  // whole triangles of three corners each
constexpr std::uint64_t faces_a_step = 1 << 10;
constexpr std::size_t batch = 3 << 13;  // vertices
constexpr const char* map_name = "samples";

// What all ranks know about the file.
struct Kind {
  std::uint64_t has_triangles = 0, has_normals = 0, has_corners = 0;  // corners: each triangle has points of its own
  std::uint64_t samples = 0;                                          // wanted
};

// A mesh that several ranks read. The steps are called in their order, on all ranks.
class RankMesh {
 public:
  RankMesh(MpiRanks& ranks, const Files& files, const PartsOptions& options, const RankFolders& folders)
      : ranks_(ranks), files_(files), options_(options), folders_(folders), workers_(options.threads) {}

  void read_contents() {
    std::vector<Kind> kind(1);
    together(ranks_, [&] {
      if (!is_first()) return;
      contents_ = contents_of_large(files_);
      kind[0].has_triangles = contents_["triangles"].get<std::uint64_t>() > 0 ? 1 : 0;
      kind[0].has_normals = has_attribute(contents_, "normals") ? 1 : 0;
      kind[0].has_corners = contents_.contains("corners") ? 1 : 0;
      const std::size_t count = sample_count(files_, options_);
      kind[0].samples = kind[0].has_triangles == 0 && options_.target > 0 ? options_.target : count;
    });
    broadcast_values(ranks_, kind);
    kind_ = kind[0];
  }

  void sample() {
    stream::SampleOptions sampling = sampling_options(files_, static_cast<std::size_t>(kind_.samples), options_);
    Progress progress("sampling " + files_.input);
    if (is_first()) sampling.progress = [&](double fraction) { progress.show(fraction); };
    stream::sample(ranks_,
                   {stream::file_source(path_of(files_), files_.format), folders_.temporary,
                    [&](const stream::Schema& schema) { return writer_to(samples_, schema); }},
                   sampling);
    if (kind_.has_triangles == 0) return;
    if (kind_.has_normals == 0) samples_.normals.clear();  // those of the triangles are better
    std::vector<double> origin(samples_.origin.begin(), samples_.origin.end());
    broadcast_values(ranks_, origin);
    std::copy(origin.begin(), origin.end(), samples_.origin.begin());
    broadcast_values(ranks_, samples_.positions);
    broadcast_values(ranks_, samples_.normals);
  }

  LargeMesh connect() {
    if (kind_.has_triangles == 0) return {std::move(samples_), std::move(contents_)};
    Sheets sheets(samples_.point_count());
    if (!read_triangles(sheets)) return read_alone();
    Sheets all(samples_.point_count());
    gather(ranks_, stream::bytes_of(sheets.merged()), [&](std::size_t, std::span<const char> bytes) {
      std::vector<Sheet> received(bytes.size() / sizeof(Sheet));
      std::copy(bytes.begin(), bytes.end(), stream::bytes_of(received).begin());
      all.add(received);
    });
    if (!is_first()) return {};
    return {without_lonely_samples(samples_, all.take_triangles()), std::move(contents_)};
  }

 private:
  bool is_first() const { return ranks_.rank() == 0; }

  // Each rank reads a range of the triangles. Returns false if the file does not allow that.
  bool read_triangles(Sheets& sheets) {
    std::unique_ptr<stream::PointReader> points;
    std::unique_ptr<FaceRecords> faces;
    together(ranks_, [&] {
      points = stream::open_points(
          path_of(files_),
          {.format = files_.format, .normals = true, .channels = false, .keep_invalid = files_.skip_invalid});
      if (kind_.has_corners == 0) faces = faces_in(path_of(files_), files_.format);
    });
    const bool has_ranges = points->can_seek() && points->count() && (kind_.has_corners != 0 || faces);
    if (stream::least(ranks_, has_ranges ? 1 : 0) == 0) return false;
    const SampleSearch search(samples_);
    if (kind_.has_corners != 0) {
      together(ranks_, [&] { connect_corners(*points, search, sheets); });
      return true;
    }
    return connect_faces(*points, *faces, search, sheets);
  }

  // Calls take(first, samples) for the vertices of this rank, some at a time.
  template <class Take>
  void find_samples(stream::PointReader& points, const SampleSearch& search, const Take& take) const {
    const stream::RankRange range = range_of(ranks_, *points.count(), vertices_a_step);
    points.seek(range.begin);
    std::vector<std::uint32_t> found;
    for (std::uint64_t at = range.begin; at < range.end; at += found.size()) {
      const stream::Points some = points.read(static_cast<std::size_t>(std::min<std::uint64_t>(batch, range.end - at)));
      if (some.size() == 0) throw std::runtime_error(files_.input + ": ends early; it was changed while it was read");
      found.resize(some.size());
      workers_.each(found.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          std::array<float, 3> normal{};
          if (!some.normals.empty()) std::copy_n(&some.normals[3 * i], 3, normal.begin());
          found[i] = search.sample_of(
              search.vertex_of({some.positions[3 * i], some.positions[3 * i + 1], some.positions[3 * i + 2]}, normal));
        }
      });
      take(at, found);
    }
  }

  // Three vertices that follow one another are a triangle.
  void connect_corners(stream::PointReader& points, const SampleSearch& search, Sheets& sheets) const {
    find_samples(points, search, [&](std::uint64_t, const std::vector<std::uint32_t>& found) {
      for (std::size_t i = 0; i + 2 < found.size(); i += 3) sheets.add({found[i], found[i + 1], found[i + 2]});
    });
  }

  // The samples of all vertices go to a file that all ranks read.
  bool connect_faces(stream::PointReader& points, const FaceRecords& faces, const SampleSearch& search,
                     Sheets& sheets) const {
    std::optional<stream::WorkFolder> folder;  // of rank 0
    std::optional<stream::TemporaryFile> file;
    const std::filesystem::path map = stream::WorkFolder::path_in(folders_.work, map_name);
    together(ranks_, [&] {
      if (!is_first()) return;
      folder.emplace(folders_.work, "glark simplify\n", false);
      file.emplace(stream::KeptFile{map});
    });
    together(ranks_, [&] {
      if (!std::filesystem::exists(map))
        throw std::runtime_error(map.string() +
                                 ": only some ranks see this file; write to a file system that all of them share");
      if (!is_first()) file.emplace(stream::KeptFile{map});
    });
    together(ranks_, [&] {
      find_samples(points, search, [&](std::uint64_t first, const std::vector<std::uint32_t>& found) {
        file->write(first * sizeof(std::uint32_t), stream::bytes_of(std::span<const std::uint32_t>(found)));
      });
      file->flush();
    });
    bool are_triangles = true;
    together(ranks_, [&] {
      VertexMap samples(SharedNumbers{map, *points.count()}, static_cast<std::size_t>(options_.memory / 8));
      const stream::RankRange range = range_of(ranks_, faces.count(), faces_a_step);
      are_triangles = faces.each(range.begin, range.end, [&](const std::array<std::uint32_t, 3>& corners) {
        if (*std::max_element(corners.begin(), corners.end()) <
            samples.size())  // else the whole reading says what is wrong
          sheets.add({samples.at(corners[0]), samples.at(corners[1]), samples.at(corners[2])});
        else
          are_triangles = false;
      });
    });
    return stream::least(ranks_, are_triangles ? 1 : 0) > 0;
  }

  // Rank 0 reads all triangles.
  LargeMesh read_alone() {
    LargeMesh large;
    together(ranks_, [&] {
      if (!is_first()) return;
      ClusterMesh mesh(samples_, folders_.temporary, static_cast<std::size_t>(options_.memory / 8), workers_);
      add_triangles(files_, contents_, mesh);
      large = {without_lonely_samples(samples_, mesh.take_triangles()), std::move(contents_)};
    });
    return large;
  }

  MpiRanks& ranks_;
  const Files& files_;
  const PartsOptions& options_;
  const RankFolders& folders_;
  const common::Workers workers_;
  Kind kind_;
  Report contents_;             // of rank 0
  geometry::Geometry samples_;  // with colours on rank 0 only
};

}  // namespace

LargeMesh read_by_ranks(MpiRanks& ranks, const Files& files, const PartsOptions& options, const RankFolders& folders) {
  RankMesh mesh(ranks, files, options, folders);
  mesh.read_contents();
  mesh.sample();
  return mesh.connect();
}

}  // namespace glark::tool
