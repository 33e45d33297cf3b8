// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Two rules for all readers of open_points(): after an error, every read fails until seek(), and a read of 0 points is
// an error.
#pragma once

#include <glark/point_stream.h>

#include <memory>
#include <optional>

namespace glark::stream {

// A reader has passed the bad points when it finds them. Without the error, the next read would go on behind them, and
// the caller would miss points without knowing it.
class CheckedReader final : public PointReader {
 public:
  explicit CheckedReader(std::unique_ptr<PointReader> reader) : reader_(std::move(reader)) {}

  const std::string& name() const override { return reader_->name(); }
  const Schema& schema() const override { return reader_->schema(); }
  std::optional<std::uint64_t> count() const override { return reader_->count(); }
  bool can_seek() const override { return reader_->can_seek(); }

  Points read(std::size_t most) override {
    if (most == 0) throw Error(Element::option, 0, "glark-stream: most is 0; read at least 1 point");
    if (failure_) throw Error(*failure_);
    try {
      return reader_->read(most);
    } catch (const Error& error) {
      failure_ = error;
      throw;
    }
  }
  // Moves to another point, and clears the error.
  void seek(std::uint64_t point) override {
    reader_->seek(point);
    failure_.reset();
  }

 private:
  std::unique_ptr<PointReader> reader_;
  std::optional<Error> failure_;
};

}  // namespace glark::stream
