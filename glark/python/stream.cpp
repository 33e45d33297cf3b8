// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <mutex>

#include "glark/python/convert/bound_class.h"
#include "glark/python/convert/scan_files.h"
#include "glark/python/convert/text.h"

namespace glark::python {

namespace fs = std::filesystem;

namespace {

using stream::SampledCell;
using stream::SampleReport;

// A format such as raw has no normals. The C++ library says so by the schema of its writer.
void warn_without_normals(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || stream::open_points(file)->schema().normals) return;
  const std::string text = file.string() + ": the format has no normals, so those of the samples are left out";
  if (PyErr_WarnFormat(PyExc_UserWarning, 1, "%U", text_of(text).ptr()) != 0) throw py::error_already_set();
}

// A part of a scan. It owns its arrays, unlike stream::Points.
struct Part {
  std::uint64_t first = 0;
  py::array positions;
  py::object normals, channels;
};

class Reader {
 public:
  Reader(const fs::path& file, const std::string& format, bool keep_invalid) {
    stream::ReadOptions options;
    options.format = format;
    options.keep_invalid = keep_invalid;
    reader_ = stream::open_points(file, options);
  }
  const stream::PointReader& fixed() const { return *reader_; }

  // Several Python threads may call it; each part goes to one of them.
  std::optional<Part> read(const Whole<std::size_t>& wanted) { return read(wanted.checked("most")); }
  std::optional<Part> read(std::size_t most) {
    std::vector<double> positions, channels;
    std::vector<float> normals;
    std::uint64_t first = 0;
    with_files([&] {
      const std::lock_guard lock(mutex_);
      const stream::Points points = reader_->read(most);
      first = points.first;
      positions.assign(points.positions.begin(), points.positions.end());
      normals.assign(points.normals.begin(), points.normals.end());
      channels.assign(points.channels.begin(), points.channels.end());
    });
    if (positions.empty()) return std::nullopt;
    Part part{first, owned(std::move(positions), 3), py::none(), py::none()};
    if (!normals.empty()) part.normals = owned(std::move(normals), 3);
    if (!channels.empty()) {
      const auto columns = static_cast<py::ssize_t>(reader_->schema().channels.size());
      part.channels = columns == 1 ? owned(std::move(channels), 1).attr("reshape")(-1, 1)
                                   : py::object(owned(std::move(channels), columns));
    }
    return part;
  }

 private:
  std::unique_ptr<stream::PointReader> reader_;
  std::mutex mutex_;
};

std::vector<std::string> channel_names(const Reader& reader) {
  std::vector<std::string> names;
  for (const stream::Channel& channel : reader.fixed().schema().channels) names.push_back(channel.name);
  return names;
}

}  // namespace

template <>
inline constexpr bool is_bound<Reader> = true;
template <>
inline constexpr bool is_bound<Part> = true;
template <>
inline constexpr bool is_bound<stream::SampleReport> = true;
template <>
inline constexpr bool is_bound<stream::TransferReport> = true;
template <>
inline constexpr bool is_bound<stream::RefineReport> = true;
namespace {

void bind_reader(py::module_& module) {
  py::class_<Part>(module, "Part", "Points that follow one another in a file.")
      .def_readonly("first", &Part::first, "the index of the first point in the file")
      .def_readonly("positions", &Part::positions, "(points, 3) float64, in the file's unit")
      .def_readonly("normals", &Part::normals, "(points, 3) float32, or None")
      .def_readonly("channels", &Part::channels, "(points, channels) float64, or None; the reader has the names");
  py::class_<Reader>(module, "Reader",
                     "Reads a file of any size a part at a time: for part in Reader('scan.las'): ...\n\n"
                     "PLY, LAS, STL (three points a triangle), XYZ, PTS, and triples of floats (.raw).")
      .def(py::init([](const fs::path& file, const std::string& format, bool keep_invalid) {
             return with_files([&] { return std::make_unique<Reader>(file, format, keep_invalid); });
           }),
           py::arg("file"), py::kw_only(), py::arg("format") = "", py::arg("keep_invalid") = false,
           "format: 'ply' or '.ply', for example; by default that of the name. keep_invalid: give points with NaN or "
           "infinite\n"
           "coordinates, too, instead of raising ArgumentError.")
      .def_property_readonly(
          "count", [](const Reader& reader) { return reader.fixed().count(); },
          "the number of points, or None if it is known at the end only")
      .def_property_readonly("channel_names", &channel_names, "the names of the columns of channels")
      .def("read", py::overload_cast<const Whole<std::size_t>&>(&Reader::read), py::arg("most") = 65536,
           "The next points, at most `most`, which is 1 or more; None at the end. An error is raised again by each "
           "further call.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", [](Reader& reader) {
        std::optional<Part> part = reader.read(65536);
        if (!part) throw py::stop_iteration();
        return *part;
      });
}

void bind_reports(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(SampledCell, corner, side, points, first, last, first_sample, samples, error);
  py::class_<SampleReport>(module, "SampleReport", "What sample() did.")
      .def_readonly("points", &SampleReport::points, "the number of points of the scan")
      .def_readonly("left_out", &SampleReport::left_out, "the number of points that are not finite")
      .def_readonly("samples", &SampleReport::samples, "the number of samples")
      .def_readonly("in_core", &SampleReport::in_core, "whether all points fitted into the memory")
      .def_readonly("is_shuffled", &SampleReport::is_shuffled, "whether the points went through a file of cells")
      .def_property_readonly(
          "cells", [](const py::object& self) { return view(self.cast<SampleReport&>().cells, 1, self); },
          "(cells,) records: corner, side, points, first, last, first_sample, samples, error");
  using stream::TransferReport;
  py::class_<TransferReport>(module, "TransferReport", "What transfer() did.")
      .def_readonly("points", &TransferReport::points, "the number of points that were written")
      .def_readonly("is_deformed", &TransferReport::is_deformed, "whether a sample has moved")
      .def_readonly("channels", &TransferReport::channels, "the names of the channels that were written")
      .def_readonly("points_away", &TransferReport::points_away, "the number of points without samples around them")
      .def_readonly("cells_on_disk", &TransferReport::cells_on_disk,
                    "the cells of a sampling that did not fit into memory");
  using stream::RefineReport;
  py::class_<RefineReport>(module, "RefineReport", "What refine() did.")
      .def_readonly("points_read", &RefineReport::points_read, "the number of points of the scan that were read")
      .def_readonly("points", &RefineReport::points, "the number of points in the region")
      .def_readonly("samples", &RefineReport::samples, "the number of new samples, which follow the others");
}

void bind_sample(py::module_& module) {
  const stream::SampleOptions defaults;
  module.def(
      "sample",
      [](const fs::path& large, const fs::path& small, const Whole<std::size_t>& target, double error,
         const Whole<std::size_t>& memory, const Whole<unsigned>& threads, bool skip_invalid, const fs::path& work,
         bool resume) {
        stream::SampleOptions options;
        options.target = target.checked("target");
        options.error = error;
        options.memory = memory.checked("memory");
        options.threads = threads.checked("threads");
        options.progress = &stop_for_signals;
        options.skip_invalid = skip_invalid;
        options.work = work;
        options.resume = resume;
        SampleReport report = with_files([&] { return stream::sample_file(large, small, options); });
        warn_without_normals(small);
        return report;
      },
      py::arg("large"), py::arg("small"), py::kw_only(), py::arg("target") = defaults.target,
      py::arg("error") = defaults.error, py::arg("memory") = defaults.memory, py::arg("threads") = 0,
      py::arg("skip_invalid") = false, py::arg("work") = "", py::arg("resume") = false,
      "Sample the scan `large` of any size into the file `small`, and write the index small.cells.\n\n"
      "target: the number of samples; there are at most 1 % less, or as many as the scan has positions. \n"
      "error: without a target, the root mean square distance of a sample's points from their tangent planes, relative "
      "to the diagonal. memory: bytes, without the sampling.\n"
      "work: a folder for the state of the work, from which a killed run continues with resume=True.");
}

void bind_transfer(py::module_& module) {
  module.def(
      "transfer",
      [](const fs::path& large, const fs::path& small, const fs::path& edited, const fs::path& output,
         const Whole<unsigned>& neighbours, bool singular, const Whole<unsigned>& threads, const fs::path& work,
         bool resume, const Whole<std::size_t>& memory) {
        const stream::TransferOptions options{
            neighbours.checked("neighbours"), singular, threads.checked("threads"), work, resume, &stop_for_signals,
            memory.checked("memory")};
        return with_files([&] { return stream::transfer(large, small, edited, output, options); });
      },
      py::arg("large"), py::arg("small"), py::arg("edited"), py::arg("output"), py::kw_only(),
      py::arg("neighbours") = stream::TransferOptions().neighbours, py::arg("singular") = false, py::arg("threads") = 0,
      py::arg("work") = "", py::arg("resume") = false, py::arg("memory") = stream::TransferOptions().memory,
      "Transfer the edit of a sampling to its scan: `small` became `edited`. `output` has the format of `large`, and "
      "the\nending of its name.\n\n"
      "neighbours: the samples that a point follows, 3 to 64. singular: keep sharp borders of colours. \n"
      "memory: bytes for all; a sampling that does not fit lies in cells on the disk.");
}

// Exactly one of the three describes the region.
stream::Region region_of(const std::optional<std::array<std::array<double, 3>, 2>>& box,
                         const std::optional<std::pair<std::array<double, 3>, double>>& sphere,
                         const std::string& channel) {
  if ((box ? 1 : 0) + (sphere ? 1 : 0) + (channel.empty() ? 0 : 1) != 1)
    throw ArgumentError("glark: a region is one of box, sphere and channel; give one of them");
  stream::Region region;
  if (box) {
    region.low = (*box)[0];
    region.high = (*box)[1];
  } else if (sphere) {
    region.kind = stream::Region::Kind::sphere;
    region.centre = sphere->first;
    region.radius = sphere->second;
  } else {
    region.kind = stream::Region::Kind::channel;
    region.channel = channel;
  }
  return region;
}

void bind_refine(py::module_& module) {
  const stream::RefineOptions defaults;
  module.def(
      "refine",
      [](const fs::path& large, const fs::path& small, const fs::path& output, const fs::path& edited,
         const fs::path& edited_output, const std::optional<std::array<std::array<double, 3>, 2>>& box,
         const std::optional<std::pair<std::array<double, 3>, double>>& sphere, const std::string& channel,
         const Whole<std::size_t>& target, double error, const Whole<std::size_t>& memory,
         const Whole<unsigned>& neighbours, const Whole<unsigned>& threads) {
        fs::path cells = small;
        cells += ".cells";
        const stream::RefineFiles files{large, cells, small, edited.empty() ? small : edited, output, edited_output};
        const stream::RefineOptions options{target.checked("target"), error, memory.checked("memory"),
                                            neighbours.checked("neighbours"), threads.checked("threads")};
        const stream::Region region = region_of(box, sphere, channel);
        const stream::RefineReport report = with_files([&] { return stream::refine(files, region, options); });
        warn_without_normals(output);
        return report;
      },
      py::arg("large"), py::arg("small"), py::arg("output"), py::kw_only(), py::arg("edited") = "",
      py::arg("edited_output") = "", py::arg("box") = py::none(), py::arg("sphere") = py::none(),
      py::arg("channel") = "", py::arg("target") = defaults.target, py::arg("error") = defaults.error,
      py::arg("memory") = defaults.memory, py::arg("neighbours") = defaults.neighbours, py::arg("threads") = 0,
      "Take more samples of a region of the scan `large`, whose sampling is `small` (with small.cells).\n\n"
      "output: `small` and the new samples. edited: the edited sampling, in which the region lies.\n"
      "edited_output: `edited` and the new samples, deformed and coloured as those around them.\n"
      "box: (low, high). sphere: (centre, radius). channel: the samples in which this channel is not zero.");
}

}  // namespace

void bind_stream(py::module_& module) {
  py::module_ stream_module =
      module.def_submodule("stream", "Scans of any size: sampled, edited by their sampling, refined.");
  bind_reader(stream_module);
  bind_reports(stream_module);
  bind_sample(stream_module);
  bind_transfer(stream_module);
  bind_refine(stream_module);
}

}  // namespace glark::python
