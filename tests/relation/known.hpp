// SPDX-License-Identifier: Apache-2.0
/// Pairs whose relation is known without any program, asked at many scales and with single numbers a place off.
#pragma once

#include <vector>

#include "properties/pair.hpp"

namespace known {

using properties::Numbers;

/// The field-th number of a or of b, one place up or down, and what the relation becomes.
struct Nudge {
  char shape;
  int field;
  int places;
  int expected;
};

/// A relation of a to b, as a code of vesica.h. Numbers are small integers.
struct Case {
  int expected;
  Numbers a, b;
  std::vector<Nudge> nudges = {};
};

/// Each case and each of its nudges: lengths times powers of two over the whole range, sizes or axes scaled, in double
/// and float, in both orders, by vesica_relation and vesica_contains.
void expect_cases(int kind_a, int kind_b, const std::vector<Case>& cases);

}  // namespace known
