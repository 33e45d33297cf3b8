// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/stream.h>
#include <glark/stream.h>

#include <memory>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
namespace stream = glark::stream;

struct glark_stream_reader {
  std::unique_ptr<stream::PointReader> reader;
};

namespace {

static_assert(static_cast<int>(stream::Element::point) == GLARK_STREAM_POINT);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<stream::Error>(error, step);
}

glark_stream_doubles doubles_of(std::span<const double> span) { return {span.data(), span.size()}; }

stream::SampleOptions options_of(const glark_stream_sample_options* given) {
  stream::SampleOptions options;
  if (given == nullptr) return options;
  options.target = given->target;
  options.error = given->error;
  options.memory = given->memory;
  options.threads = given->threads;
  options.skip_invalid = given->skip_invalid;
  return options;
}

}  // namespace

glark_code glark_stream_open_points(const char* file, const char* format, glark_stream_reader** reader,
                                    glark_error* error) {
  return guarded(error, [&] {
    glark_stream_reader*& result = needed(reader, "reader");
    stream::ReadOptions options;
    if (format != nullptr) options.format = format;
    auto opened = std::make_unique<glark_stream_reader>();
    opened->reader = stream::open_points(&needed(file, "file"), options);
    result = opened.release();
  });
}

void glark_stream_reader_free(glark_stream_reader* reader) { delete reader; }

bool glark_stream_reader_count(const glark_stream_reader* reader, uint64_t* count) {
  if (reader == nullptr || !reader->reader->count()) return false;
  if (count != nullptr) *count = *reader->reader->count();
  return true;
}

bool glark_stream_reader_has_normals(const glark_stream_reader* reader) {
  return reader != nullptr && reader->reader->schema().normals;
}

size_t glark_stream_reader_channel_count(const glark_stream_reader* reader) {
  return reader == nullptr ? 0 : reader->reader->schema().channels.size();
}

const char* glark_stream_reader_channel_name(const glark_stream_reader* reader, size_t channel) {
  if (channel >= glark_stream_reader_channel_count(reader)) return nullptr;
  return reader->reader->schema().channels[channel].name.c_str();
}

glark_code glark_stream_reader_read(glark_stream_reader* reader, size_t most, glark_stream_points* points,
                                    glark_error* error) {
  return guarded(error, [&] {
    glark_stream_points& result = needed(points, "points");
    const stream::Points read = needed(reader, "reader").reader->read(most);
    result = {read.first, doubles_of(read.positions), array_of(read.normals), doubles_of(read.channels)};
  });
}

glark_code glark_stream_reader_seek(glark_stream_reader* reader, uint64_t point, glark_error* error) {
  return guarded(error, [&] { needed(reader, "reader").reader->seek(point); });
}

glark_stream_sample_options glark_stream_default_sample_options(void) {
  const stream::SampleOptions options;
  return {options.target, options.error, options.memory, options.threads, options.skip_invalid};
}

glark_code glark_stream_sample_file(const char* large, const char* small, const glark_stream_sample_options* options,
                                    glark_stream_sample_report* report, glark_error* error) {
  return guarded(error, [&] {
    const stream::SampleReport done =
        stream::sample_file(&needed(large, "large"), &needed(small, "small"), options_of(options));
    if (report != nullptr)
      *report = {done.points, done.left_out, done.samples, done.cells.size(), done.in_core, done.is_shuffled};
  });
}

glark_stream_transfer_options glark_stream_default_transfer_options(void) {
  const stream::TransferOptions options;
  return {options.neighbours, options.singular, options.threads};
}

glark_code glark_stream_transfer(const char* large, const char* from, const char* to, const char* output,
                                 const glark_stream_transfer_options* options, uint64_t* points, glark_error* error) {
  return guarded(error, [&] {
    stream::TransferOptions how;
    if (options != nullptr) {
      how.neighbours = options->neighbours;
      how.singular = options->singular;
      how.threads = options->threads;
    }
    const stream::TransferReport report = stream::transfer(&needed(large, "large"), &needed(from, "from"),
                                                           &needed(to, "to"), &needed(output, "output"), how);
    if (points != nullptr) *points = report.points;
  });
}
