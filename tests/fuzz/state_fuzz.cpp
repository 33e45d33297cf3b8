// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any bytes as the state of a killed run, by which it is resumed: values within the file, or false. Without a checksum
// that fits, there is nothing to read. As no chance finds one, every other input gets its own.
#include <cstdlib>
#include <string>

#include "glark/clients/common/resume/state_file.h"

namespace {

using glark::common::OpenFile;

void read_all(std::FILE* file, std::size_t size) {
  glark::common::StateReader reader(file);
  std::uint8_t kind = 0;
  while (reader.get(kind)) {
    std::uint64_t number = 0;
    std::vector<std::uint8_t> bytes;
    std::vector<double> doubles;
    const bool is_good = kind % 3 == 0   ? reader.get(number)
                         : kind % 3 == 1 ? reader.get_all(bytes)
                                         : reader.get_all(doubles);
    if (bytes.size() + sizeof(double) * doubles.size() > size) std::abort();
    if (!is_good) return;
  }
  if (!reader.at_end()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] % 2 == 0) {
    std::string copy(data, data + size);
    const OpenFile file(fmemopen(copy.data(), copy.size(), "rb"));
    read_all(file.get(), size);
    return 0;
  }
  std::string with_sum(size + 64, '\0');
  {
    const OpenFile file(fmemopen(with_sum.data(), with_sum.size(), "wb"));
    glark::common::StateWriter writer(file.get());
    writer.put_all(std::span(data, size), false);
    if (!writer.finish()) std::abort();
  }
  const OpenFile file(fmemopen(with_sum.data(), size + sizeof(std::uint64_t), "rb"));
  read_all(file.get(), size);
  return 0;
}
