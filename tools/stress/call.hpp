// SPDX-License-Identifier: Apache-2.0
/// One way to call every scalar query of vesica.h.
#pragma once

#include <array>
#include <cstdint>

#include "properties/random.hpp"
#include "stress/environment.hpp"
#include "stress/query.hpp"

namespace stress {

/// The most numbers of a result: crossings' `shared` and 12 places.
inline constexpr std::size_t most_numbers = 25;

/// vesica_ratio's ratios, as many as its constants.
inline constexpr std::size_t ratio_count = VESICA_RATIO_COMPLETE + 1;

/// A function's result and output, as doubles in the order of its struct; crossings: shared, x[12], y[12], and the
/// count as the code; ratios: the seven numbers, then their seven codes, the first of them as code; de9im: -1 for F.
/// Numbers that the function does not write are 0.
struct Answer {
  std::int32_t code = 0;
  bool wrote = false;                ///< did it write to its output?
  bool environment_changed = false;  ///< did it leave another floating-point environment than it met?
  std::array<double, most_numbers> numbers{};
};

/// Same code and numbers, to the bit.
bool same_bits(const Answer& a, const Answer& b);

/// The code, then the numbers that are not 0, for a message.
std::string text(const Answer& answer);

/// The queries from overlap to intersection.
Answer ask(const Case& c, const Environment& environment = default_environment);
/// For shapes at rest.
Answer ask(Query query, Scalar scalar, const Pair& pair, const Environment& environment = default_environment);

/// About as far as two shapes are apart, to the last place; where they overlap, anything up to their size; sometimes 0.
double draw_distance(Scalar scalar, const Pair& pair, properties::Random& random);

/// vesica_check of one shape.
std::int32_t check(Scalar scalar, int kind, const Numbers& numbers);

/// The numbers as floats; unlike properties::narrow, for those of invalid shapes too.
properties::NumbersOf<float> as_floats(const Numbers& numbers);

}  // namespace stress
