// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cstring>

#include "glark/clients/common/vector.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

// Three points in sequence are a triangle. Its normal is that of its corners.
class StlWriter final : public PointWriter {
 public:
  explicit StlWriter(const Creation& creation) : file_(creation) {
    schema_.normals = true;
    file_.add(header(file_.expected() / 3));
  }

  const Schema& schema() const override { return schema_; }

  void write(const Points& points) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) corners_[3 * have_ + k] = static_cast<float>(points.positions[3 * i + k]);
      if (++have_ == 3) add_triangle();
    }
    file_.count(points.size());
  }

  void finish() override {
    if (have_ != 0)
      throw Error(Element::file, 0,
                  file_.name() +
                      ": STL has triangles only, and the number of points is no multiple of three; write "
                      "PLY instead");
    file_.finish(header(file_.points() / 3));
  }

 private:
  static std::string header(std::uint64_t triangles) {
    std::string bytes(84, '\0');
    bytes.replace(0, 16, "written by glark");
    const auto count = static_cast<std::uint32_t>(triangles);
    std::memcpy(&bytes[80], &count, sizeof(count));
    return bytes;
  }

  void add_triangle() {
    const std::span<const float> corners(corners_);
    const common::Vector3f a = common::vector_at(corners, 0);
    const common::Vector3f normal =
        common::unit(common::cross(common::vector_at(corners, 1) - a, common::vector_at(corners, 2) - a));
    std::array<char, 50> bytes{};
    const std::array<float, 3> n = common::to_array(normal);
    std::memcpy(bytes.data(), n.data(), sizeof(n));
    std::memcpy(&bytes[12], corners_.data(), sizeof(corners_));
    file_.add({bytes.data(), bytes.size()});
    have_ = 0;
  }

  Schema schema_;
  WriterFile file_;
  std::array<float, 9> corners_{};
  std::size_t have_ = 0;
};

}  // namespace

std::unique_ptr<PointWriter> stl_writer(const Creation& creation) { return std::make_unique<StlWriter>(creation); }

}  // namespace glark::stream
