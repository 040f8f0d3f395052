// SPDX-License-Identifier: Apache-2.0
/// Shapes as flat numbers of either scalar type, and the scalar function's answer that batches are held against.
#pragma once

#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "properties/pair.hpp"

namespace batch_tests {

template <class T>
using Numbers = properties::NumbersOf<T>;

template <class T>
inline constexpr properties::Scalar scalar_of = sizeof(T) == sizeof(float) ? properties::Scalar::f32
                                                                           : properties::Scalar::f64;

inline std::int32_t scalar_answer(int kind_a, const Numbers<float>& a, int kind_b, const Numbers<float>& b) {
  return vesica_overlap_f32(kind_a, a.data(), kind_b, b.data());
}
inline std::int32_t scalar_answer(int kind_a, const Numbers<double>& a, int kind_b, const Numbers<double>& b) {
  return vesica_overlap_f64(kind_a, a.data(), kind_b, b.data());
}

/// Pairs of two kinds, one array a side, with the scalar function's answers.
template <class T>
struct Pairs {
  int kind_a, kind_b;
  std::vector<Numbers<T>> a, b;
  std::vector<std::int32_t> answers;

  std::size_t size() const { return answers.size(); }
  void add(const Numbers<T>& shape_a, const Numbers<T>& shape_b) {
    a.push_back(shape_a);
    b.push_back(shape_b);
    answers.push_back(scalar_answer(kind_a, shape_a, kind_b, shape_b));
  }
};

template <class T>
Numbers<T> to_scalar(const properties::Numbers& numbers) {
  Numbers<T> result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    const volatile T stored = static_cast<T>(numbers[k]);  // as in properties/pair.cpp
    result[k] = stored;
  }
  return result;
}

/// Both shapes with hexadecimal numbers.
template <class T>
std::string describe(int kind_a, const Numbers<T>& a, int kind_b, const Numbers<T>& b) {
  properties::Pair pair{kind_a, kind_b, {}, {}};
  for (std::size_t k = 0; k < a.size(); ++k) {
    pair.a[k] = static_cast<double>(a[k]);
    pair.b[k] = static_cast<double>(b[k]);
  }
  return properties::describe(pair);
}

}  // namespace batch_tests
