// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The writers behind create_points(), and what they share.
#pragma once

#include <glark/point_stream.h>

#include <memory>

#include "glark/clients/geometry/write/output_file.h"

namespace glark::stream {

// What a writer is made from.
struct Creation {
  std::filesystem::path file;
  Schema schema;
  std::optional<std::uint64_t> count;
  WriteOptions options;
};

// Throws Error for a name whose ending create_points() does not know.
void require_streamed_ending(const std::filesystem::path& file);

std::unique_ptr<PointWriter> ply_writer(const Creation& creation);
std::unique_ptr<PointWriter> las_writer(const Creation& creation);
std::unique_ptr<PointWriter> raw_writer(const Creation& creation);
std::unique_ptr<PointWriter> stl_writer(const Creation& creation);
// PLY as text, XYZ or PTS.
std::unique_ptr<PointWriter> text_writer(const Creation& creation, const std::string& format);

// A PLY header. Its length does not depend on the count, so that the count can be put in later.
std::string ply_header(const Schema& schema, std::uint64_t count, bool text);

// Calls `step`, and turns errors of OutputFile into Error.
template <class Step>
auto writing(const Step& step) {
  try {
    return step();
  } catch (const std::runtime_error& error) {
    throw Error(Element::file, 0, error.what());
  }
}

// The file of a writer, and the number of points that it has got.
class WriterFile {
 public:
  explicit WriterFile(const Creation& creation)
      : name_(creation.file.string()),
        count_(creation.count),
        file_(writing([&] { return std::make_unique<geometry::OutputFile>(creation.file); })) {
    if (file_->is_direct() && !count_)
      throw Error(Element::file, 0,
                  name_ +
                      ": is a pipe or a device, for which the number of points must be known in advance; write to "
                      "a file");
  }
  const std::string& name() const { return name_; }
  std::uint64_t points() const { return points_; }
  std::uint64_t expected() const { return count_.value_or(0); }
  void add(std::string_view bytes) {
    writing([&] { file_->write(bytes); });
  }
  void count(std::size_t points) { points_ += points; }
  // header: the final bytes of the beginning. They replace the first ones if the count was not known.
  void finish(std::string_view header) {
    if (count_ && *count_ != points_)
      throw Error(Element::file, 0,
                  name_ + ": " + std::to_string(*count_) + " points were announced, " + std::to_string(points_) +
                      " were written; nothing is kept");
    writing([&] {
      if (!file_->is_direct() && !header.empty()) file_->overwrite(0, header);
      file_->commit();
    });
  }

 private:
  std::string name_;
  std::optional<std::uint64_t> count_;
  std::unique_ptr<geometry::OutputFile> file_;
  std::uint64_t points_ = 0;
};

}  // namespace glark::stream
