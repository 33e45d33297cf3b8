// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/files/checkpoints.h"
#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/transfer/output_layout.h"
#include "glark/clients/stream/transfer/record_editor.h"
#include "glark/clients/stream/transfer/sampling.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

void check(const TransferOptions& options) {
  if (options.neighbours < 3 || options.neighbours > 64)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: neighbours is {}; 3 to 64 are possible", options.neighbours));
}

// The output of a transfer, with the state that a later run continues from.
class Output {
 public:
  Output(const std::filesystem::path& file, WorkFolder& folder, const OutputLayout& layout)
      : folder_(folder), layout_(layout) {
    folder.require_same_disk(file);
    const bool is_begun = folder.load("done", [&](StateReader& state) { return state.get(state_); });
    if (!is_begun) state_ = {};
    const std::uint64_t kept = is_begun ? layout.header().size() + state_.done * layout.layout().record_size : 0;
    writing([&] {
      file_ = folder.is_used() ? std::make_unique<geometry::OutputFile>(file, folder.path("output"), kept)
                               : std::make_unique<geometry::OutputFile>(file);
      if (file_->is_direct()) throw Error(Element::file, 0, file.string() + ": is a pipe or a device; write to a file");
      if (!is_begun) file_->write(layout.header());
    });
  }

  std::uint64_t done() const { return state_.done; }
  void add(std::span<const char> records, std::size_t count) {
    add_to_box(records, count);
    writing([&] { file_->write({records.data(), records.size()}); });
    state_.done += count;
  }
  void save() {
    writing([&] { file_->flush(); });
    folder_.save("done", [&](StateWriter& state) { state.put(state_); });
  }
  // Copies what follows the records, and puts the file in its place.
  void finish(const SourceFile& from, std::uint64_t begin, OutputLayout& layout) {
    std::string bytes;
    writing([&] {
      for (; begin < from.size(); begin += bytes.size()) {
        bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(1 << 20, from.size() - begin)));
        from.read(begin, bytes);
        file_->write(bytes);
      }
      if (state_.done > 0) file_->overwrite(0, layout.final_header(state_.low, state_.high));
      file_->commit();
    });
    folder_.finish();
  }

 private:
  struct State {
    std::uint64_t done = 0;  // records
    std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  };

  // A LAS header stores the bounding box.
  void add_to_box(std::span<const char> records, std::size_t count) {
    if (!layout_.has_box()) return;
    PointArrays points;
    decode(layout_.layout(), records.data(), count, {.normals = false, .channels = false}, points);
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      state_.low[i % 3] = std::min(state_.low[i % 3], points.positions[i]);
      state_.high[i % 3] = std::max(state_.high[i % 3], points.positions[i]);
    }
  }

  WorkFolder& folder_;
  const OutputLayout& layout_;
  std::unique_ptr<geometry::OutputFile> file_;
  State state_;
};

// All that the saved state depends on.
std::string identity_of(const FileState& large, const std::filesystem::path& from, const std::filesystem::path& to,
                        const TransferOptions& options) {
  const FileState before = SourceFile(from).state(), after = SourceFile(to).state();
  std::string identity = fmt::format("glark transfer 1\n{} {}\n", options.neighbours, options.singular);
  for (const FileState& state : {large, before, after})
    identity += fmt::format("{} {} {}\n", state.size, state.seconds, state.nanoseconds);
  return identity;
}

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
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

TransferReport transfer(const std::filesystem::path& large, const std::filesystem::path& from,
                        const std::filesystem::path& to, const std::filesystem::path& output,
                        const TransferOptions& options) {
  check(options);
  require_work(options.work, options.resume);
  require_name(output, "the output");
  require_other_file(output, {large, from, to});
  const SourceFile file(large);
  const FileState before = file.state();
  const std::string format = format_of(large, "");
  const Layout layout = binary_layout(file, format, output);
  const common::Workers workers(options.threads);
  const Sampling sampling = read_sampling(from, to, workers);
  const SampleIndex index(sampling.samples.before);
  OutputLayout out(file, layout, format, sampling.channels);
  RecordEditor editor(sampling, index, layout, out, options, workers, output.string());
  WorkFolder folder(options.work, identity_of(before, from, to, options), options.resume);
  Checkpoints checkpoints(folder, layout.records);
  Output written(output, folder, out);
  checkpoints.begin(written.done());
  const std::size_t size = layout.record_size, size_out = out.layout().record_size;
  std::vector<char> records, edited;
  while (written.done() < layout.records) {
    const std::uint64_t done = written.done();
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(editor.batch_size(), layout.records - done));
    records.resize(count * size);
    edited.resize(count * size_out);
    file.read(layout.begin + done * size, records);
    editor.edit(done, records, edited);
    written.add(edited, count);
    if (checkpoints.is_due(written.done())) written.save();
    if (options.progress) options.progress(static_cast<double>(written.done()) / static_cast<double>(layout.records));
  }
  file.require_unchanged(before);
  written.finish(file, layout.begin + layout.size(), out);
  return {layout.points(), sampling.is_deformed, names_of(sampling.channels), editor.points_away()};
}

}  // namespace glark::stream
