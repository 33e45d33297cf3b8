// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/resume/state_file.h"

#include <algorithm>
#include <array>

#include "glark/clients/common/fnv.h"

namespace glark::common {
void StateWriter::write(const void* bytes, std::size_t size) {
  if (size == 0 || !is_good_) return;
  sum_ = add_to_fnv(sum_, {static_cast<const char*>(bytes), size});
  is_good_ = std::fwrite(bytes, 1, size, file_) == size;
}

bool StateWriter::finish() {
  const std::uint64_t sum = sum_;
  write(&sum, sizeof(sum));
  return is_good_ && std::fflush(file_) == 0;
}

StateReader::StateReader(std::FILE* file) : file_(file) {
  if (file == nullptr || std::fseek(file, 0, SEEK_END) != 0) return;
  const long size = std::ftell(file);
  constexpr long sum_size = sizeof(std::uint64_t);
  if (size < sum_size) return;
  std::rewind(file);
  std::array<char, 1 << 14> block{};
  std::uint64_t sum = 0, wanted = 0;
  for (long left = size - sum_size; left > 0;) {
    const std::size_t part = std::min<std::size_t>(block.size(), static_cast<std::size_t>(left));
    if (std::fread(block.data(), 1, part, file) != part) return;
    sum = add_to_fnv(sum, {block.data(), part});
    left -= static_cast<long>(part);
  }
  if (std::fread(&wanted, 1, sizeof(wanted), file) != sizeof(wanted) || wanted != sum) return;
  std::rewind(file);
  left_ = static_cast<std::uint64_t>(size - sum_size);
}

bool StateReader::read(void* bytes, std::size_t size) {
  if (size > left_ || (size > 0 && std::fread(bytes, 1, size, file_) != size)) return false;
  left_ -= size;
  return true;
}

}  // namespace glark::common
