// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "glark/clients/common/resume/checkpoints.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/transfer/edited_scan.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

// The output of a transfer, with the state that a later run continues from.
class Output {
 public:
  Output(const std::filesystem::path& file, WorkFolder& folder, const OutputLayout& layout)
      : folder_(folder), layout_(layout) {
    folder.require_same_disk(file);
    const bool is_begun = folder.load("done", [&](common::StateReader& state) { return state.get(state_); });
    if (!is_begun) state_ = {};
    away_before_ = state_.points_away;
    const std::uint64_t kept = is_begun ? layout.header().size() + state_.done * layout.layout().record_size : 0;
    writing([&] {
      file_ = folder.is_used() ? std::make_unique<geometry::OutputFile>(file, folder.path("output"), kept)
                               : std::make_unique<geometry::OutputFile>(file);
      if (file_->is_direct()) throw Error(Element::file, 0, file.string() + ": is a pipe or a device; write to a file");
      if (!is_begun) file_->write(layout.header());
    });
  }

  std::uint64_t done() const { return state_.done; }
  // Among all records that are done, in this run and before it.
  std::uint64_t points_away() const { return state_.points_away; }
  void count_points_away(std::uint64_t in_this_run) { state_.points_away = away_before_ + in_this_run; }
  void add(const EditedScan::Edited& edited) {
    state_.box.add(layout_, edited.records, edited.count);
    writing([&] { file_->write({edited.records.data(), edited.records.size()}); });
    state_.done += edited.count;
  }
  void save() {
    writing([&] { file_->flush(); });
    folder_.save("done", [&](common::StateWriter& state) { state.put(state_); });
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
      if (state_.done > 0) file_->overwrite(0, layout.final_header(state_.box.low, state_.box.high));
      file_->commit();
    });
    folder_.finish();
  }

 private:
  struct State {
    std::uint64_t done = 0;  // records
    std::uint64_t points_away = 0;
    EditedBox box;
  };

  WorkFolder& folder_;
  const OutputLayout& layout_;
  std::unique_ptr<geometry::OutputFile> file_;
  State state_;
  std::uint64_t away_before_ = 0;
};

}  // namespace

TransferReport transfer(const std::filesystem::path& large, const std::filesystem::path& from,
                        const std::filesystem::path& to, const std::filesystem::path& output,
                        const TransferOptions& options) {
  EditedScan scan({large, from, to, output}, options);
  WorkFolder folder(options.work, scan.identity(), options.resume);
  common::Checkpoints checkpoints(folder, scan.records());
  Output written(output, folder, scan.output());
  checkpoints.begin(written.done());
  while (written.done() < scan.records()) {
    written.add(scan.edit(written.done(), scan.records()));
    written.count_points_away(scan.points_away());
    if (checkpoints.is_due(written.done())) written.save();
    if (options.progress) options.progress(static_cast<double>(written.done()) / static_cast<double>(scan.records()));
  }
  scan.require_unchanged();
  written.finish(scan.file(), scan.rest(), scan.output());
  TransferReport report = scan.report();
  report.points_away = written.points_away();
  return report;
}

}  // namespace glark::stream
