// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glark/stream.h>

#include "glark/clients/edit/session/folder.h"
#include "glark/clients/edit/session/log.h"
#include "glark/clients/edit/session/refinement.h"

namespace glark::edit {
namespace {

namespace fs = std::filesystem;

// PLY files get the channels that they lack.
bool can_hold_colours(const fs::path& scan) {
  const std::string ending = scan.extension().string();
  return ending == ".ply" || ending == ".PLY" ||
         stream::channel_index(stream::open_points(scan)->schema(), "red") != stream::none;
}

// Fails now instead of after hours of work.
void check_scan(const fs::path& scan, const SessionOptions& options) {
  if (options.target == 0) throw Error(Element::option, 0, "glark-edit: target is 0; give the most samples");
  if (!stream::open_points(scan)->can_seek())
    throw Error(Element::file, 0,
                scan.string() +
                    ": is text or compressed, and an edit is transferred to binary files; convert it to "
                    "binary PLY first");
}

void sample_scan(const Folder& folder, const fs::path& scan, const SessionOptions& options) {
  if (fs::is_regular_file(folder.path(cells_file))) return;  // it is written after the sampling
  stream::SampleOptions how;
  how.target = options.target;
  how.memory = options.memory;
  how.threads = options.threads;
  how.progress = options.progress;
  how.work = folder.path("sample.partial");
  how.resume = true;
  stream::sample_file(scan, folder.path(sample_file), how);
  folder.keep(sample_file);
  folder.keep(cells_file);
}

}  // namespace

struct Session::State {
  fs::path scan;
  SessionOptions options;
  Folder folder;
  Log log;
  std::size_t line = 0;      // of the log, that is being replayed or applied
  std::size_t replayed = 0;  // lines
  Editor editor;

  State(const fs::path& from, const fs::path& in, const SessionOptions& wanted)
      : scan(from),
        options(wanted),
        folder(in, from),
        log(folder.path("log")),
        editor(read_sampling(sampled()), editor_options()) {
    folder.keep("log");
    replay();
  }

  void apply(const Operation& operation) {
    const auto* project = std::get_if<Project>(&operation);
    if ((project != nullptr || std::holds_alternative<Paint>(operation)) && !can_hold_colours(scan))
      throw Error(Element::operation, 0,
                  scan.string() + " cannot hold colours; convert it to binary PLY, and edit that");
    line = log.lines().size();
    const Operation kept = project == nullptr ? operation : with_kept_picture(*project);
    const std::string text = text_of(kept);
    const Symmetric before = editor.symmetric();
    editor.apply(found(kept));
    try {
      log.append(text);
    } catch (...) {
      take_back(operation, before);
      throw;
    }
  }

 private:
  // The picture is copied: a replay needs it, whatever becomes of the file.
  Operation with_kept_picture(Project project) const {
    const std::string name = fmt::format("picture-{}{}", line, fs::path(project.picture).extension().string());
    std::error_code error;
    fs::copy_file(project.picture, folder.path(name), fs::copy_options::overwrite_existing, error);
    if (error)
      throw Error(Element::file, 0, project.picture + ": cannot be copied into the session: " + error.message());
    folder.keep(name);
    project.picture = name;
    return project;
  }
  // The operation with the picture's place.
  Operation found(Operation operation) const {
    if (auto* project = std::get_if<Project>(&operation)) project->picture = folder.path(project->picture).string();
    return operation;
  }

  fs::path sampled() {
    sample_scan(folder, scan, options);
    return folder.path(sample_file);
  }

  EditorOptions editor_options() {
    EditorOptions how;
    how.temporary = folder.path("");
    how.threads = options.threads;
    how.refine = [this](std::span<const Refine> balls) {
      if (line >= log.lines().size()) folder.require_same_scan(scan);
      return line < log.lines().size() ? kept_samples(folder, line)
                                       : take_samples(folder, scan, balls, line, editor, options);
    };
    return how;
  }

  void replay() {
    for (line = 0; line < log.lines().size(); ++line) {
      try {
        editor.apply(found(parse(log.lines()[line])));
      } catch (const Error& error) {
        throw Error(Element::file, line,
                    fmt::format("{}: line {}: {}", folder.path("log").string(), Log::line_number(line), error.what()));
      }
    }
    replayed = log.lines().size();
  }

  // The log does not have the operation.
  void take_back(const Operation& operation, const Symmetric& before) {
    if (std::holds_alternative<Symmetric>(operation))
      editor.apply(before);
    else if (std::holds_alternative<Undo>(operation))
      editor.apply(Redo{});
    else
      editor.apply(Undo{});
  }
};

Session::Session(const fs::path& scan, const fs::path& folder, const SessionOptions& options) {
  check_scan(scan, options);
  state_ = std::make_unique<State>(scan, folder, options);
}
Session::~Session() = default;
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;

void Session::apply(const Operation& operation) { state_->apply(operation); }

const Editor& Session::editor() const { return state_->editor; }
std::size_t Session::operations() const { return state_->log.lines().size(); }
std::size_t Session::replayed() const { return state_->replayed; }
bool Session::has_dropped_line() const { return state_->log.has_dropped_line(); }

SaveReport Session::save(const fs::path& output, const Progress& progress) const {
  std::error_code ignored;
  if (fs::equivalent(state_->scan, output, ignored))
    throw Error(Element::file, 0,
                output.string() + ": is the scan itself, which the session needs; save to another file");
  state_->folder.require_outside(output);
  state_->folder.require_same_scan(state_->scan);
  const EditFiles edit(state_->folder, state_->editor);
  stream::TransferOptions how;
  how.threads = state_->options.threads;
  how.progress = progress;
  how.memory = state_->options.memory;
  const stream::TransferReport report = stream::transfer(state_->scan, edit.before(), edit.after(), output, how);
  return {report.points, report.is_deformed, !report.channels.empty()};
}

}  // namespace glark::edit
