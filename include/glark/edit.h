// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans of any size, edited by their sampling: brushes, bends, deformed regions, undo without limit, and a session on
// disk that survives a crash. Link to glark-edit.
//
//   glark::edit::Session session("scan.ply", "scan.edit");
//   session.apply(glark::edit::parse("inflate 0 0 1 0.2 0.05"));
//   session.save("edited.ply");
//
// Lengths are in the unit of the scan's positions, angles in degrees. Positions are those of the edited sampling.
//
// Source: Boubekeur 2007, ch. 4.5; docs/how-to/edit.md lists the operations.
#ifndef GLARK_EDIT_H
#define GLARK_EDIT_H

#include <glark/edit_operations.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace glark::edit {

// The caller owns the arrays; all but the positions may be empty.
struct Sampling {
  std::vector<double> positions;  // [3 * samples]
  std::vector<float> normals;     // [3 * samples], towards the outside; those that are missing or zero are estimated
  std::vector<std::uint8_t> colours;     // [3 * samples]
  std::vector<std::uint32_t> triangles;  // [3 * triangles]; without them, neighbours are the nearest samples
};

// New samples of a refinement, before the edit and after it. The arrays of both have the same number of samples.
struct Refined {
  Sampling before, after;  // `after` has no normals; without colours, the colours are those of `before`
};

struct EditorOptions {
  // Returns the new samples for Refine: of one ball, or of two with a mirror, where no sample may come twice. Empty:
  // Refine is an Error.
  std::function<Refined(std::span<const Refine> balls)> refine = {};
  std::filesystem::path temporary = {};  // the folder for the file with the steps to undo; empty: that of the system
  unsigned threads = 0;                  // 0: as many as the machine has; the result does not depend on it
};

// An edited sampling in memory.
class GLARK_EXPORT Editor {
 public:
  // Errors: Error for an array of the wrong size, a number that is not finite, an index that is no sample.
  explicit Editor(Sampling sampling, EditorOptions options = {});
  ~Editor();
  Editor(Editor&& other) noexcept;
  Editor& operator=(Editor&& other) noexcept;

  // Errors: Error for numbers out of range, a ball without samples, nothing to undo. Nothing is changed then.
  void apply(const Operation& operation);

  std::size_t size() const;        // of samples
  std::size_t undo_count() const;  // the number of operations that can be undone
  std::size_t redo_count() const;
  const Symmetric& symmetric() const;

  // The editor owns the arrays, until the next apply(). Refined samples follow the others.
  std::span<const double> positions() const;         // [3 * samples]
  std::span<const float> normals() const;            // [3 * samples], of unit length, or zero
  std::span<const std::uint8_t> colours() const;     // [3 * samples], or empty if there are none and nothing is painted
  std::span<const double> positions_before() const;  // before the edit
  std::span<const float> normals_before() const;
  std::span<const std::uint8_t> colours_before() const;  // empty if the sampling has no colours

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

// Receives the finished fraction of the work, 0 to 1.
using Progress = std::function<void(double fraction)>;

struct SessionOptions {
  // For a new session only. A session that is continued keeps its sampling.
  std::size_t target = 200000;                  // the most samples, above 0
  std::size_t memory = std::size_t{256} << 20;  // bytes, for the sampling of the scan; 40 MiB or more
  unsigned threads = 0;                         // 0: as many as the machine has; the result does not depend on it
  Progress progress = {};                       // of the sampling
};

struct SaveReport {
  std::uint64_t points = 0;  // of the scan
  bool is_deformed = false;  // some sample has moved
  bool is_painted = false;   // some sample has another colour
};

// An editor whose operations are kept in a folder. apply() returns when its line is on the disk. So a killed program, or
// a machine that lost power, loses at most the operation that was under way. A session is continued by the same folder.
class GLARK_EXPORT Session {
 public:
  // Samples the scan, or replays what is in the folder. Only one session at a time may use the folder.
  // Errors: Error for a folder with other files, a scan that has changed since, or a log that is damaged before its last
  // line. The Error names the file and the line. Nothing in the folder is changed then. stream::Error for a scan that
  // cannot be read, or to which no edit can be transferred.
  Session(const std::filesystem::path& scan, const std::filesystem::path& folder, const SessionOptions& options = {});
  ~Session();
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;

  // Errors: as Editor::apply(), Paint for a scan whose format has no colours, or if the log cannot be written. Then the
  // operation is not applied.
  void apply(const Operation& operation);

  const Editor& editor() const;
  std::size_t operations() const;  // the number of lines of the log
  std::size_t replayed() const;    // how many of them were there at the begin
  bool has_dropped_line() const;   // the last line was not complete: the operation that was under way at a crash

  // Transfers the edit to the scan. The output has the scan's format, and appears at the end, complete. The session goes
  // on. Errors: as stream::transfer().
  SaveReport save(const std::filesystem::path& output, const Progress& progress = {}) const;

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

}  // namespace glark::edit

#endif  // GLARK_EDIT_H
