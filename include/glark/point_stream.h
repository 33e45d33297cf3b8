// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points read and written a span at a time, so that a file may be larger than the memory. Link to glark-stream.
//
//   const auto reader = glark::stream::open_points("scan.las");
//   const auto writer = glark::stream::create_points("scan.ply", reader->schema(), reader->count());
//   for (auto points = reader->read(); points.size() > 0; points = reader->read()) writer->write(points);
//   writer->finish();
//
// PointReader and PointWriter are interfaces: a program may stream from and to its own places.
#ifndef GLARK_POINT_STREAM_H
#define GLARK_POINT_STREAM_H

#include <glark/error.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glark::stream {

enum class Element { option, file, point };

// An error in an argument or a file: the file, the element, its value, and the remedy.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The type of a number in a file.
enum class Number : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

// A number that each point has besides its position and normal: a colour, an intensity, a class.
struct Channel {
  std::string name;  // as PLY has it: red, green, blue, alpha, intensity, classification, gps_time ...
  Number type = Number::float32;
  friend bool operator==(const Channel&, const Channel&) = default;
};

// What each point of a stream has.
struct Schema {
  Number position = Number::float32;  // float64 if the coordinates have more digits than a float
  bool normals = false;
  std::vector<Channel> channels;
  friend bool operator==(const Schema&, const Schema&) = default;
};

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

// Returns the index of the channel, or none.
GLARK_EXPORT std::size_t channel_index(const Schema& schema, const std::string& name);

// Points that follow one another in a stream. The arrays belong to the reader, and are valid until its next call.
struct Points {
  std::uint64_t first = 0;            // the index of the first point in the stream
  std::span<const double> positions;  // [3 * points], in the file's unit
  std::span<const float> normals;     // [3 * points], of any length; empty without normals
  std::span<const double> channels;   // [channels * points], a point's channels together; bytes are 0 to 255
  std::size_t size() const { return positions.size() / 3; }
};

class GLARK_EXPORT PointReader {
 public:
  PointReader() = default;
  virtual ~PointReader();
  PointReader(const PointReader&) = delete;
  PointReader& operator=(const PointReader&) = delete;

  virtual const std::string& name() const = 0;  // for messages
  virtual const Schema& schema() const = 0;
  virtual std::optional<std::uint64_t> count() const = 0;  // of all points, if it is known before the end
  // Returns the next points: at most `most`, which is 1 or more; none at the end. Errors: Error for a file that ends
  // early or cannot be read, for a word that is no number, for a point whose coordinates are not finite, and for a
  // `most` of 0. A reader of open_points() gives the same Error for an unusable file or point again, until seek().
  virtual Points read(std::size_t most = 4096) = 0;
  // Whether seek() works: for files of binary records, not for text, pipes or compressed files.
  virtual bool can_seek() const = 0;
  // The next read() begins at this point. Errors: Error without can_seek(), or beyond the end.
  virtual void seek(std::uint64_t point) = 0;
};

class GLARK_EXPORT PointWriter {
 public:
  PointWriter() = default;
  virtual ~PointWriter();
  PointWriter(const PointWriter&) = delete;
  PointWriter& operator=(const PointWriter&) = delete;

  virtual const Schema& schema() const = 0;
  // The points have the normals and channels of the schema. Errors: Error if writing fails or a number does not fit.
  virtual void write(const Points& points) = 0;
  // Ends the file and puts it in its place. Without this call, nothing is left behind.
  virtual void finish() = 0;
};

struct ReadOptions {
  // ".ply", ".las", ".xyz" (".txt", ".asc", ".csv"), ".pts", ".stl" or ".raw" (triples of floats); empty: by the name.
  std::string format = {};
  bool normals = true;   // false: normals are not decoded
  bool channels = true;  // false: channels are not decoded
  // Points whose coordinates are NaN or infinite are read as they are, instead of an Error.
  bool keep_invalid = false;
};

// Opens a file of points. PLY and text may be compressed by zstd, or come from a pipe ("/dev/stdin" with a format).
// An STL file gives the three corners of each triangle. Errors: Error for a file that cannot be read, whose format is
// unknown, whose header is wrong or announces more than the file has.
GLARK_EXPORT std::unique_ptr<PointReader> open_points(const std::filesystem::path& file,
                                                      const ReadOptions& options = {});

struct WriteOptions {
  bool text = false;  // PLY as text
  // LAS: the size of a step of the coordinates. 0: a power of ten, at most 2^-20 of the extent of the first points.
  double step = 0;
};

// Creates a file of points: .ply, .las, .xyz, .pts, .stl or .raw by its name. The file appears at finish(), complete.
// A channel that the format cannot hold is left out; schema() tells which ones stay. count: needed for pipes, and for
// .pts. Errors: Error for a folder that cannot be written, or a format that is unknown.
GLARK_EXPORT std::unique_ptr<PointWriter> create_points(const std::filesystem::path& file, const Schema& schema,
                                                        std::optional<std::uint64_t> count = std::nullopt,
                                                        const WriteOptions& options = {});

// Where several passes get their points from.
struct Source {
  std::string name;  // for messages
  // Returns a reader that begins at the first point. Several threads call it.
  std::function<std::unique_ptr<PointReader>(const ReadOptions& options)> open;
  // Differs between sources whose points differ, so that a killed run is not continued with others; may be empty.
  std::string identity = {};
};

// The points of a file. The file must not change between the passes: Error.
GLARK_EXPORT Source file_source(const std::filesystem::path& file, const std::string& format = {});

}  // namespace glark::stream

#endif  // GLARK_POINT_STREAM_H
