// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "glark/clients/common/resume/checkpoints.h"
#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t records_a_step = 1 << 14, bytes_a_step = 1 << 20;
constexpr std::uint64_t least_rest_to_save = std::uint64_t{1} << 28;  // bytes

// What a rank has done of its part: all before is in the output.
struct Done {
  std::uint64_t records = 0;
  std::uint64_t rest = 0;  // bytes of what follows the records
  std::uint64_t points_away = 0;
  EditedBox box;
};

// The output of all ranks: a file in the folder of the work, which rank 0 makes and puts in its place. Each rank writes
// to it at its own places, and saves what it has done.
class SharedOutput {
 public:
  SharedOutput(Ranks& ranks, const TransferFiles& files, const TransferOptions& options, EditedScan& scan)
      : ranks_(ranks),
        scan_(scan),
        identity_(scan.identity() + fmt::format("ranks {}\n", ranks.size())),
        path_(WorkFolder::path_in(options.work, name)) {
    together(ranks, [&] {
      if (options.work.empty())
        throw Error(Element::file, 0, files.output.string() + ": is a pipe or a device; write to a file");
      if (ranks.rank() == 0) create(files.output, options);
    });
    const std::uint64_t size = greatest(ranks, ranks.rank() == 0 ? size_of_file() : 0);
    together(ranks, [&] {
      if (size_of_file() != size)
        throw Error(Element::file, 0,
                    path_.string() + ": only some ranks see this file; write to a file system that all of them share");
      file_.emplace(KeptFile{path_});
      if (!folder_) folder_.emplace(options.work, identity_, true);
      load(size);
    });
  }
  ~SharedOutput() {
    for (std::size_t rank = 0; folder_ && folder_->is_used() && rank < ranks_.size(); ++rank)
      if (std::filesystem::exists(folder_->path(name_of(rank)))) folder_->keep();
  }
  SharedOutput(const SharedOutput&) = delete;
  SharedOutput& operator=(const SharedOutput&) = delete;

  WorkFolder& folder() { return *folder_; }
  std::uint64_t place_of(std::uint64_t record) const {
    return scan_.output().header().size() + record * scan_.output().layout().record_size;
  }
  void write(std::uint64_t record, std::span<const char> records) { file_->write(place_of(record), records); }

  // Copies a part of what follows the records. done() counts the bytes.
  void copy_rest(const RankRange& range) {
    common::Checkpoints checkpoints(*folder_, range.end - range.begin, least_rest_to_save);
    checkpoints.begin(done_.rest);
    std::vector<char> bytes;
    for (std::uint64_t at = range.begin + done_.rest; at < range.end; at += bytes.size()) {
      bytes.resize(static_cast<std::size_t>(std::min(bytes_a_step, range.end - at)));
      scan_.file().read(scan_.rest() + at, bytes);
      file_->write(place_of(scan_.records()) + at, bytes);
      done_.rest += bytes.size();
      if (checkpoints.is_due(done_.rest)) save();
    }
  }
  void flush() { file_->flush(); }

  // What this rank has done, now or in an earlier run.
  Done& done() { return done_; }
  // All that is done is in the file.
  void save() {
    flush();
    folder_->save(name_of(ranks_.rank()).c_str(), [&](common::StateWriter& state) { state.put(done_); });
  }

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
  static std::string name_of(std::size_t rank) { return fmt::format("done-{}", rank); }

  // A run that was killed after it put its output in place has no more of it here: this one begins again.
  void create(const std::filesystem::path& file, const TransferOptions& options) {
    const std::uint64_t before = size_of_file();
    const bool resumes = options.resume && before >= scan_.output().header().size();
    folder_.emplace(options.work, identity_, resumes);
    folder_->require_same_disk(file);
    const std::uint64_t kept = size_of_file() == before ? before : 0;  // another run's files are gone
    writing([&] {
      target_ = std::make_unique<geometry::OutputFile>(file, path_, kept);
      if (kept == 0) target_->write(scan_.output().header());
      target_->flush();
    });
  }
  std::uint64_t size_of_file() const {
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(path_, missing);
    return missing ? 0 : size;
  }
  void load(std::uint64_t size) {
    Done saved;
    const RankRange records = range_of(ranks_, scan_.records(), records_a_step);
    if (folder_->load(name_of(ranks_.rank()).c_str(), [&](common::StateReader& state) { return state.get(saved); }) &&
        saved.records <= records.end - records.begin && place_of(records.begin + saved.records) <= size)
      done_ = saved;
  }

  Ranks& ranks_;
  EditedScan& scan_;
  const std::string identity_;
  const std::filesystem::path path_;
  std::optional<WorkFolder> folder_;
  std::unique_ptr<geometry::OutputFile> target_;  // of rank 0
  std::optional<TemporaryFile> file_;
  Done done_;
};

}  // namespace

TransferReport transfer(Ranks& ranks, const TransferFiles& files, const TransferOptions& options) {
  std::unique_ptr<EditedScan> scan;
  together(ranks, [&] { scan = std::make_unique<EditedScan>(files, options); });
  require_same(ranks, scan->file().size(), scan->file().name());
  SharedOutput output(ranks, files, options, *scan);
  const RankRange range = range_of(ranks, scan->records(), records_a_step);
  Done& done = output.done();
  const std::uint64_t away_before = done.points_away;
  together(ranks, [&] {
    common::Checkpoints checkpoints(output.folder(), range.end - range.begin);
    checkpoints.begin(done.records);
    for (std::uint64_t record = range.begin + done.records; record < range.end; record = range.begin + done.records) {
      const EditedScan::Edited edited = scan->edit(record, range.end);
      done.box.add(scan->output(), edited.records, edited.count);
      output.write(record, edited.records);
      done.records += edited.count;
      done.points_away = away_before + scan->points_away();
      if (checkpoints.is_due(done.records)) output.save();
      if (options.progress)
        options.progress(static_cast<double>(done.records) / static_cast<double>(range.end - range.begin));
    }
    output.copy_rest(range_of(ranks, scan->file().size() - scan->rest(), bytes_a_step));
    output.flush();
    scan->require_unchanged();
  });
  EditedBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = least(ranks, done.box.low[k]);
    box.high[k] = greatest(ranks, done.box.high[k]);
  }
  TransferReport report = scan->report();
  report.points_away = sum(ranks, done.points_away);
  together(ranks, [&] {
    if (ranks.rank() == 0) output.commit(box);
  });
  return report;
}

}  // namespace glark::stream
