// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A frame allocates nothing.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/qas/meshes.h"

namespace {
std::atomic<int> allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace glark::qas::test {
namespace {

TEST(Allocation, NoneInAFrame) {
  const ControlMesh mesh = densified(blocks(), 3);
  for (const unsigned threads : {1U, 2U}) {
    for (const unsigned which : {0U, 1U, 2U, 3U}) {
      const unsigned splits = which % 2;
      const Scheme scheme = which < 2 ? Scheme::loop : Scheme::modified_butterfly;
      const int before_all = allocations;
      Surface surface(mesh.view(), {.scheme = scheme, .splits = splits, .threads = threads});
      EXPECT_GT(allocations, before_all) << "allocations are not counted";
      std::vector<Corner> corners(surface.corner_count());
      std::vector<QuarticCorner> quartic_corners(surface.quartic_corner_count());
      surface.update(mesh.positions);
      surface.write_corners(corners);
      const int before = allocations;
      surface.update(mesh.positions);
      surface.write_corners(corners);
      surface.write_quartic_corners(quartic_corners);
      EXPECT_EQ(allocations, before) << "threads " << threads << " splits " << splits;
    }
  }
}

}  // namespace
}  // namespace glark::qas::test
