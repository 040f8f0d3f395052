// SPDX-License-Identifier: Apache-2.0
/// Calls a batch function and holds every byte of its output against the scalar function's answers.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "batch.hpp"
#include "batch/layout.hpp"
#include "batch/shapes.hpp"
#include "properties/random.hpp"

namespace batch_tests {

inline constexpr std::uint8_t untouched = 0xA5;

/// The values that a call must write and return.
struct Expected {
  std::vector<std::uint8_t> bytes;
  std::int64_t overlaps = 0;
  bool invalid = false;

  void add(std::int32_t answer) {
    bytes.push_back(answer == 1);
    overlaps += answer == 1;
    invalid = invalid || answer < 0;
  }
};

/// The scalar function's answers for a[i] and b[i], where an array of one shape repeats it.
template <class T>
Expected in_step(int kind_a, std::span<const Numbers<T>> a, bool one_a, int kind_b, std::span<const Numbers<T>> b,
                 bool one_b) {
  Expected expected;
  for (std::size_t i = 0; i < a.size(); ++i) {
    expected.add(scalar_answer(kind_a, a[one_a ? 0 : i], kind_b, b[one_b ? 0 : i]));
  }
  return expected;
}

/// A stretch of an endless repetition of pairs.
template <class T>
struct Stretch {
  std::vector<Numbers<T>> a, b;
  Expected expected;

  Stretch(const Pairs<T>& pairs, std::size_t begin, std::size_t length) {
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t at = (begin + i) % pairs.size();
      a.push_back(pairs.a[at]);
      b.push_back(pairs.b[at]);
      expected.add(pairs.answers[at]);
    }
  }
};

/// Output memory of `size` bytes at any alignment, with bytes about it that a call must leave alone.
class Output {
 public:
  explicit Output(std::size_t size, std::size_t offset = 0)
      : begin_(margin + offset), size_(size), bytes_(begin_ + size + margin, untouched) {}
  std::uint8_t* data() { return bytes_.data() + begin_; }
  std::uint8_t operator[](std::size_t i) const { return bytes_[begin_ + i]; }

  bool margins_untouched() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const bool inside = i >= begin_ && i < begin_ + size_;
      if (!inside && bytes_[i] != untouched) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t margin = 64;
  std::size_t begin_, size_;
  std::vector<std::uint8_t> bytes_;
};

inline void expect_tally(const vesica::batch::Tally& tally, const Expected& expected, const std::string& what) {
  EXPECT_EQ(tally.overlaps, expected.overlaps) << what;
  EXPECT_EQ(tally.invalid, expected.invalid) << what;
}

/// The place of the first wrong byte, or -1.
inline std::ptrdiff_t first_difference(const Output& out, const Expected& expected) {
  for (std::size_t i = 0; i < expected.bytes.size(); ++i) {
    if (out[i] != expected.bytes[i]) return static_cast<std::ptrdiff_t>(i);
  }
  return -1;
}

/// many() over n pairs. The arrays' shapes are given again for the message.
template <class T>
void expect_many(const vesica::KernelTable& kernels, const Stored<T>& a, const Stored<T>& b, const Expected& expected,
                 const std::string& what, std::size_t out_offset = 0) {
  const std::size_t n = expected.bytes.size();
  Output out(n, out_offset);
  const vesica::batch::Tally tally =
      vesica::batch::many(kernels, a.view(), b.view(), static_cast<std::int64_t>(n), out.data());
  expect_tally(tally, expected, what);
  EXPECT_TRUE(out.margins_untouched()) << what;
  const std::ptrdiff_t wrong = first_difference(out, expected);
  EXPECT_EQ(wrong, -1) << what << ": out[" << wrong << "] of " << n << " differs from the scalar function, seed "
                       << properties::seed();
}

}  // namespace batch_tests
