// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Random values of a step: usual ones, and those at which formulas and conversions go wrong.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <type_traits>

namespace glark::conformance {

class Values {
 public:
  explicit Values(std::uint32_t seed) : random_(seed) {}

  // Not a distribution of the library: these differ from implementation to implementation.
  std::size_t below(std::size_t bound) { return random_() % bound; }
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<unsigned>(high - low + 1))); }
  bool coin() { return (random_() & 16U) != 0; }
  std::uint32_t seed() { return static_cast<std::uint32_t>(random_()); }

  template <typename T>
  T pick(std::initializer_list<T> of) {
    return of.begin()[below(of.size())];
  }

  // From 0 to 1, the ends included.
  float fraction() { return static_cast<float>(below(65)) / 64; }

  // Mostly from -1 to 1. Often 0, 1, a negative value, or one beyond 1.
  float number() {
    if (below(3) == 0) return pick({0.0F, 1.0F, -1.0F, 2.0F, 0.5F, -0.5F, 0.001F, 3.0F, -2.0F});
    return 2 * fraction() - 1;
  }

  // A number as a value of a command. Integers are from -3 to 4.
  template <typename T>
  T plain() {
    if constexpr (std::is_floating_point_v<T>)
      return static_cast<T>(number());
    else if constexpr (std::is_signed_v<T>)
      return static_cast<T>(between(-3, 4));
    else
      return static_cast<T>(below(5));
  }

  // A value that the command divides by the greatest of its type.
  template <typename T>
  T normalized() {
    if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(number());
    } else {
      constexpr auto least = std::numeric_limits<T>::min();
      constexpr auto greatest = std::numeric_limits<T>::max();
      if (below(4) == 0) return pick<T>({T{0}, greatest, least, static_cast<T>(greatest / 2)});
      return static_cast<T>(static_cast<double>(least) + (static_cast<double>(greatest) - static_cast<double>(least)) *
                                                             static_cast<double>(fraction()));
    }
  }

 private:
  std::mt19937 random_;
};

}  // namespace glark::conformance
