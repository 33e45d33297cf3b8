// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/transfer.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t records_a_step = 1 << 14, bytes_a_step = 1 << 20;

// The output of all ranks: a file in the folder of the work, which rank 0 makes and puts in its place. Each rank writes
// to it at its own places.
class SharedOutput {
 public:
  SharedOutput(Ranks& ranks, const std::filesystem::path& file, const std::filesystem::path& work, EditedScan& scan)
      : scan_(scan) {
    together(ranks, [&] {
      if (work.empty()) throw Error(Element::file, 0, file.string() + ": is a pipe or a device; write to a file");
      if (ranks.rank() == 0) create(file, work);
    });
    together(ranks, [&] { open(WorkFolder::path_in(work, name)); });
  }

  std::uint64_t place_of(std::uint64_t record) const {
    return scan_.output().header().size() + record * scan_.output().layout().record_size;
  }
  void write(std::uint64_t record, std::span<const char> records) { file_->write(place_of(record), records); }

  // Copies a part of what follows the records.
  void copy_rest(const RankRange& range) {
    std::vector<char> bytes;
    for (std::uint64_t at = range.begin; at < range.end; at += bytes.size()) {
      bytes.resize(static_cast<std::size_t>(std::min(bytes_a_step, range.end - at)));
      scan_.file().read(scan_.rest() + at, bytes);
      file_->write(place_of(scan_.records()) + at, bytes);
    }
  }
  void flush() { file_->flush(); }

  // When all ranks have written: puts the file in its place. On rank 0.
  void commit(const EditedBox& box) {
    writing([&] {
      if (scan_.records() > 0) target_->overwrite(0, scan_.output().final_header(box.low, box.high));
      target_->commit();
    });
    folder_->finish();
  }

 private:
  static constexpr const char* name = "output";

  void create(const std::filesystem::path& file, const std::filesystem::path& work) {
    folder_.emplace(work, scan_.identity(), false);
    folder_->require_same_disk(file);
    writing([&] {
      target_ = std::make_unique<geometry::OutputFile>(file, folder_->path(name), 0);
      target_->write(scan_.output().header());
      target_->flush();
    });
  }
  void open(const std::filesystem::path& path) {
    std::error_code missing;
    if (std::filesystem::file_size(path, missing) != scan_.output().header().size() || missing)
      throw Error(Element::file, 0,
                  path.string() + ": only some ranks see this file; write to a file system that all of them share");
    file_.emplace(KeptFile{path});
  }

  EditedScan& scan_;
  std::optional<WorkFolder> folder_;              // of rank 0
  std::unique_ptr<geometry::OutputFile> target_;  // of rank 0
  std::optional<TemporaryFile> file_;
};

}  // namespace

TransferReport transfer(Ranks& ranks, const TransferFiles& files, const TransferOptions& options) {
  std::unique_ptr<EditedScan> scan;
  together(ranks, [&] { scan = std::make_unique<EditedScan>(files, options); });
  require_same(ranks, scan->file().size(), scan->file().name());
  SharedOutput output(ranks, files.output, options.work, *scan);
  const RankRange range = range_of(ranks, scan->records(), records_a_step);
  EditedBox box;
  together(ranks, [&] {
    for (std::uint64_t record = range.begin; record < range.end;) {
      const EditedScan::Edited edited = scan->edit(record, range.end);
      box.add(scan->output(), edited.records, edited.count);
      output.write(record, edited.records);
      record += edited.count;
      if (options.progress)
        options.progress(static_cast<double>(record - range.begin) / static_cast<double>(range.end - range.begin));
    }
    output.copy_rest(range_of(ranks, scan->file().size() - scan->rest(), bytes_a_step));
    output.flush();
    scan->require_unchanged();
  });
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = least(ranks, box.low[k]);
    box.high[k] = greatest(ranks, box.high[k]);
  }
  TransferReport report = scan->report();
  report.points_away = sum(ranks, report.points_away);
  together(ranks, [&] {
    if (ranks.rank() == 0) output.commit(box);
  });
  return report;
}

}  // namespace glark::stream
