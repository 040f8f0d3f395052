// SPDX-License-Identifier: Apache-2.0
/// How a line of calls.txt is written: the function, its arguments, its result and values.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "calls.hpp"

template <class T>
constexpr const char* scalar_name = std::is_same_v<T, double> ? "f64" : "f32";

inline const char* error_name(long long code) {
  static constexpr const char* names[] = {"E_NULL",          "E_SHAPE",     "E_KIND",     "E_ARGUMENT", "E_NOT_FINITE",
                                          "E_NEGATIVE_SIZE", "E_ZERO_AXIS", "E_INVERTED", "E_RANGE",    "E_INDEX"};
  return names[-code - 1];
}

inline void print_number(double number) {
  if (number == std::floor(number) && std::fabs(number) < 1e6 && !(number == 0 && std::signbit(number))) {
    std::printf(" %.0f", number);
  } else {
    std::printf(" %a", number);
  }
}

template <class T>
void begin(const char* function) {
  std::printf("%s %s", function, scalar_name<T>);
}

template <class T>
void argument(const Array<T>& shapes) {
  std::printf(" | %s", vesica_kind_name(shapes.kind));
  for (const T number : shapes.numbers) print_number(static_cast<double>(number));
}

template <class Number>
void numbers_argument(const std::vector<Number>& numbers) {
  std::printf(" |");
  for (const Number number : numbers) print_number(static_cast<double>(number));
}

inline void result(long long code) {
  if (code < 0) {
    std::printf(" = %s", error_name(code));
  } else {
    std::printf(" = %lld", code);
  }
}

template <class Number>
void values(const std::vector<Number>& numbers) {
  for (const Number number : numbers) print_number(static_cast<double>(number));
}

inline void end() { std::printf("\n"); }

inline void must(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s: the oracle is wrong, or the library is\n", what);
  std::exit(1);
}
