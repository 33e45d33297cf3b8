// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/edited_scan.h"

#include <fmt/format.h>

#include <algorithm>

#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/format/layouts.h"

namespace glark::stream {
namespace {

const TransferOptions& checked(const TransferOptions& options) {
  if (options.neighbours < 3 || options.neighbours > 64)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: neighbours is {}; 3 to 64 are possible", options.neighbours));
  require_work(options.work, options.resume);
  return options;
}

const TransferFiles& checked(const TransferFiles& files) {
  require_name(files.output, "the output");
  require_other_file(files.output, {files.large, files.from, files.to});
  return files;
}

// The records of the scan are copied, whatever the name of the output says.
void require_same_format(const std::filesystem::path& output, const SourceFile& large, const std::string& format) {
  if (format_of(output, "") == format && !is_compressed(output)) return;
  throw Error(Element::file, 0,
              fmt::format("{}: the output has the format of {}; name it with the ending {}", output.string(),
                          large.name(), format));
}

// The layout of the scan and of the output, but for channels that the edit adds.
Layout binary_layout(const SourceFile& file, const std::string& format, const std::filesystem::path& output) {
  const std::optional<Layout> layout = layout_of(file, format);
  if (!layout || is_compressed(file.name()))
    throw Error(Element::file, 0,
                file.name() +
                    ": is text or compressed, and an edit is transferred to binary files; convert it to "
                    "binary PLY first");
  require_same_format(output, file, format);
  return *layout;
}

}  // namespace

void EditedBox::add(const OutputLayout& layout, std::span<const char> records, std::size_t count) {
  if (!layout.has_box()) return;
  PointArrays points;
  decode(layout.layout(), records.data(), count, {.normals = false, .channels = false}, points);
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points.positions[i]);
    high[i % 3] = std::max(high[i % 3], points.positions[i]);
  }
}

EditedScan::EditedScan(const TransferFiles& files, const TransferOptions& options)
    : files_(checked(files)),
      options_(checked(options)),
      workers_(options.threads),
      file_(files.large),
      before_(file_.state()),
      format_(format_of(files.large, "")),
      layout_(binary_layout(file_, format_, files.output)),
      memory_(options.memory, {files.from, files.to, files.temporary}, workers_),
      sampling_(read_sampling({files.from, files.to, files.temporary}, {memory_.sampling, options.memory}, workers_)),
      output_(file_, layout_, format_, sampling_.channels),
      editor_(sampling_, layout_, output_, {options_, memory_.batch}, workers_, files.output.string()) {}

std::string EditedScan::identity() const {
  const FileState from = SourceFile(files_.from).state(), to = SourceFile(files_.to).state();
  std::string identity = fmt::format("glark transfer 1\n{} {}\n", options_.neighbours, options_.singular);
  for (const FileState& state : {before_, from, to})
    identity += fmt::format("{} {} {}\n", state.size, state.seconds, state.nanoseconds);
  return identity;
}

EditedScan::Edited EditedScan::edit(std::uint64_t first, std::uint64_t end) {
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(editor_.batch_size(), end - first));
  records_.resize(count * layout_.record_size);
  edited_.resize(count * output_.layout().record_size);
  file_.read(layout_.begin + first * layout_.record_size, records_);
  editor_.edit(first, records_, edited_);
  return {edited_, count};
}

TransferReport EditedScan::report() const {
  TransferReport report{layout_.points(), sampling_.is_deformed, {}, editor_.points_away(), sampling_.store->cells()};
  for (const Channel& channel : sampling_.channels) report.channels.push_back(channel.name);
  return report;
}

}  // namespace glark::stream
