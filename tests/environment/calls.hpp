// SPDX-License-Identifier: Apache-2.0
/// Every function of vesica.h that computes, by scalar type, as calls whose results are bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "properties/pair.hpp"

namespace environment {

using Bytes = std::vector<unsigned char>;

/// A pair of shapes with its numbers in both scalar types, converted in the default environment.
struct Input {
  int kind_a, kind_b;
  properties::NumbersOf<double> a_f64, b_f64;
  properties::NumbersOf<float> a_f32, b_f32;

  explicit Input(const properties::Pair& pair);
};

/// The output and the result of a call, to be compared bit for bit.
struct Call {
  const char* name;
  Bytes (*ask)(const Input& input);
};

/// Calls about one pair of shapes; constructors take their numbers from the first.
const std::vector<Call>& scalar_calls(properties::Scalar scalar);

/// The place of an array's numbers.
enum class Place { records, odd_records, odd_columns };

/// Pairs, all of the same two kinds, whose shapes make two arrays.
struct Inputs {
  std::vector<Input> pairs;
  Place place = Place::records;
};

struct BatchCall {
  const char* name;
  Bytes (*ask)(const Inputs& inputs);
};
const std::vector<BatchCall>& batch_calls(properties::Scalar scalar);

}  // namespace environment
