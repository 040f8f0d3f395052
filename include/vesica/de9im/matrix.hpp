// SPDX-License-Identifier: Apache-2.0
/// The nine-intersection matrix, and patterns of it.
#pragma once

#include <cstdint>
#include <vesica/shapes.hpp>

namespace vesica {

/// Nine characters and a final NUL: of a's inside with b's inside, outline and outside, of a's outline with these, of
/// a's outside. F where nothing is shared, else the dimension 0, 1 or 2.
struct NineIntersections {
  char at[10];
};

namespace detail::de9im {

constexpr char dimension(int d) noexcept { return static_cast<char>('0' + d); }
constexpr char point_if(bool any) noexcept { return any ? '0' : 'F'; }
constexpr char line_if(bool any) noexcept { return any ? '1' : 'F'; }

constexpr NineIntersections transposed(const NineIntersections& m) noexcept {
  const auto& c = m.at;
  return {{c[0], c[3], c[6], c[1], c[4], c[7], c[2], c[5], c[8], 0}};
}

constexpr bool is_one_of(char c, const char* list) noexcept {
  for (; *list != 0; ++list) {
    if (c == *list) return true;
  }
  return false;
}

/// True if a text is nine such characters.
constexpr bool is_nine_of(const char* text, const char* list) noexcept {
  for (int i = 0; i < 9; ++i) {
    if (!is_one_of(text[i], list)) return false;
  }
  return text[9] == 0;
}

}  // namespace detail::de9im

/// Matches a matrix with a pattern of F, 0, 1, 2, T (any number) and * (anything): 1 or 0, or error_argument
/// for a text that is no matrix or no pattern.
constexpr std::int32_t de9im_match(const char* matrix, const char* pattern) noexcept {
  namespace nine = detail::de9im;
  if (!nine::is_nine_of(matrix, "F012") || !nine::is_nine_of(pattern, "F012T*")) return error_argument;
  for (int i = 0; i < 9; ++i) {
    const char asked = pattern[i];
    const bool fits = asked == '*' || (asked == 'T' ? matrix[i] != 'F' : matrix[i] == asked);
    if (!fits) return 0;
  }
  return 1;
}

}  // namespace vesica
