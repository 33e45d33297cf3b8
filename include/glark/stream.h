// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans of any size: sampled, edited by their sampling, and refined. Link to glark-stream.
//
//   glark::stream::sample_file("scan.las", "small.ply", {.target = 100000});
//   // small.ply is edited and saved as edited.ply
//   glark::stream::transfer("scan.las", "small.ply", "edited.ply", "edited.las");
#ifndef GLARK_STREAM_H
#define GLARK_STREAM_H

#include <glark/point_stream.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glark::stream {

// Receives the finished fraction of the work, 0 to 1, in the thread that began it. If it throws, the work ends with this
// exception, and the outputs stay as they were.
using Progress = std::function<void(double fraction)>;

struct SampleOptions {
  std::size_t target = 0;  // the most samples; the result has at most 1 % less. 0: `error` is used instead
  // The root mean square distance of the points of a sample from its tangent planes, relative to the diagonal of the
  // bounding box.
  double error = 1e-4;
  std::size_t memory = std::size_t{256} << 20;  // bytes, 40 MiB or more; the sampling itself is not counted
  unsigned threads = 0;                         // 0: as many as the machine has; the result does not depend on it
  bool skip_invalid = false;                    // leaves out points whose coordinates are not finite
  bool allow_in_core = true;                    // false: streams even what fits into the memory
  // A folder for the state of the work, which is made, and removed at the end. If the run is killed, or the disk gets
  // full, the next one continues from there with `resume`, and repeats a twentieth of a pass at most. A folder that has
  // other files is an error; nothing is removed from it. Empty: no folder.
  std::filesystem::path work = {};
  bool resume = false;
  Progress progress = {};
};

// A part of space, the range of the stream that has its points, and its samples.
struct SampledCell {
  std::array<double, 3> corner{};  // the least corner of the cube
  double side = 0;
  std::uint64_t points = 0;
  std::uint64_t first = 0, last = 0;            // indices of the first and the last point
  std::uint64_t first_sample = 0, samples = 0;  // the samples follow one another
  double error = 0;                             // root mean square of the samples' errors, in the positions' unit
};

struct SampleReport {
  std::uint64_t points = 0, left_out = 0, samples = 0;
  bool in_core = false;      // all points fitted into the memory
  bool is_shuffled = false;  // the order has no coherence: the points went through a file of cells
  std::vector<SampledCell> cells;
};

// Samples a scan: clusters of points of a volume-surface tree, a sample each, with the mean normal and colour. Two passes
// read the points. The first one counts the points of each cell of a coarse grid. The second one sums up the points of
// small cubes of each cell. A finished cell gets a tree over these sums, whose clusters are chosen for the whole scan.
// Points whose order has no coherence are sorted into a file of cells first, in the folder `temporary`.
// create: makes the writer, which gets positions, normals, and red green blue as uint8 if the source has them.
// Source: Boubekeur 2007, ch. 4.3; docs/reference/stream.md lists the differences. Errors: Error for a source that cannot
// be read, or that changes between the passes, and for options out of range.
GLARK_EXPORT SampleReport sample(const Source& source, const SampleOptions& options,
                                 const std::filesystem::path& temporary,
                                 const std::function<std::unique_ptr<PointWriter>(const Schema&)>& create);

struct TransferOptions {
  unsigned neighbours = 12;         // the nearest samples that a point follows, 3 to 64; more make colours smoother
  bool singular = false;            // a kernel that keeps sharp borders of colours
  unsigned threads = 0;             // 0: as many as the machine has; the result does not depend on it
  std::filesystem::path work = {};  // as SampleOptions; it must be on the file system of the output
  bool resume = false;
  Progress progress = {};
  // Bytes for all, at least 36 MiB and 4 for each thread. A sampling that does not fit lies in a temporary file in the folder of the output; the
  // cells of it that are used are in memory. The result does not depend on it.
  std::size_t memory = std::size_t{256} << 20;
};

struct TransferReport {
  std::uint64_t points = 0;
  bool is_deformed = false;           // some sample has moved
  std::vector<std::string> channels;  // those that were written
  // Points whose nearest sample is about as far from them as the others: many, if `from` is a sampling of another scan.
  std::uint64_t points_away = 0;
  std::uint64_t cells_on_disk = 0;  // of a sampling that did not fit into the memory; otherwise 0
};

// Transfers the edit of a sampling to the scan: `from` became `to`. Each point moves as the samples around it did, and
// normals turn along. A channel of `to` that `from` had not is interpolated at each point. Of a channel whose values
// differ, a point gets the mean of the edited samples around it; where none of these was edited, it keeps its value.
// The samples of `to` correspond to those of `from` by their order, or by a channel "index". Everything else in `large`
// stays as it is, byte by byte: triangles, other channels, records of LAS. `output` has the format of `large`, and the
// ending of its name. It appears at the end, complete; a former file stays until then.
// Source: Boubekeur 2007, ch. 4.4. Errors: Error for files that cannot be read or do not fit together, options out of
// range, an output that is one of the other files or has another ending, a channel that LAS does not have, text PLY,
// samples in another order without a channel "index" (found if neighbours became strangers),
// samples with coordinates above 1e18, coordinates that do not fit into the numbers of the file.
GLARK_EXPORT TransferReport transfer(const std::filesystem::path& large, const std::filesystem::path& from,
                                     const std::filesystem::path& to, const std::filesystem::path& output,
                                     const TransferOptions& options = {});

// Which part of a scan each cell of its sampling has, so that more samples can be taken from that part alone.
struct CellIndex {
  std::uint64_t bytes = 0;   // the size of the scan's file
  std::uint64_t points = 0;  // of the scan
  std::vector<SampledCell> cells;
  std::uint64_t samples = 0;  // of the sampling that the index belongs to; 0: not known
};

// Writes and reads an index as text. The samples of the cells are not kept. Errors: Error for a file that cannot be
// written or read, or that is no index; such a file is not replaced either. A number that an index cannot have is
// damage: not finite, a negative side or error, sides that are not from one octree, more points than the scan has.
GLARK_EXPORT void write_cells(const std::filesystem::path& file, const CellIndex& index);
GLARK_EXPORT CellIndex read_cells(const std::filesystem::path& file);

// The same as sample(), from a file to a file. It writes the index, too: `small` with the ending ".cells" added. Errors:
// those of sample(), and Error if a file to write is `large` itself.
GLARK_EXPORT SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                                      const SampleOptions& options = {});

// The formats of the files of sample_file().
struct SampleFormats {
  std::string large;  // as ReadOptions::format: ".ply", ".las", ... Empty: by the name
  bool text = false;  // writes PLY as text
};
GLARK_EXPORT SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                                      const SampleOptions& options, const SampleFormats& formats);

// The part of an edited sampling that gets more samples: the samples within a box or a sphere after the edit, or those
// with a channel that is not zero. A point of the scan belongs to the region if its nearest sample does.
struct Region {
  enum class Kind : std::uint8_t { box, sphere, channel };
  Kind kind = Kind::box;
  std::array<double, 3> low{}, high{};  // box
  std::array<double, 3> centre{};       // sphere
  double radius = 0;
  std::string channel;
};

struct RefineOptions {
  std::size_t target = 0;  // the most new samples. 0: `error` is used instead
  double error = 1e-4;     // as SampleOptions, relative to the diagonal of the region's points
  // Bytes: half for the sampling, as TransferOptions, and half for the points of the region and their sampling.
  std::size_t memory = std::size_t{256} << 20;
  unsigned neighbours = 12;  // as TransferOptions
  unsigned threads = 0;
};

struct RefineReport {
  std::uint64_t points_read = 0;  // of the scan
  std::uint64_t points = 0;       // in the region
  std::uint64_t samples = 0;      // new ones; they follow the others
};

// The files of refine().
struct RefineFiles {
  std::filesystem::path large;     // the scan
  std::filesystem::path cells;     // the index of the sampling
  std::filesystem::path from, to;  // the sampling before and after the edit; the same file if nothing is edited
  std::filesystem::path output;    // `from` and the new samples
  std::filesystem::path
      edited_output;  // `to` and the new samples, deformed and coloured as those around them; or empty
};

// Takes more samples of a region, of points that are none yet. Only the ranges of the cells around the region are read.
// Source: Boubekeur 2007, ch. 4.5. Errors: Error for files that cannot be read or do not fit together, a scan that was changed, a region without
// samples, or one whose points do not fit into the memory, and an output that is another one of the files.
GLARK_EXPORT RefineReport refine(const RefineFiles& files, const Region& region, const RefineOptions& options = {});

}  // namespace glark::stream

#endif  // GLARK_STREAM_H
