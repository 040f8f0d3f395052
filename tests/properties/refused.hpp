// SPDX-License-Identifier: Apache-2.0
/// Pairs of kinds that a question refuses with VESICA_E_KIND. Tests that loop over kinds leave them out;
/// refused_test.cpp pins which they are.
#pragma once

#include <array>

namespace properties {

/// The questions that refuse some pairs.
enum class Question { boundary_distance, crossings, de9im, intersection };
inline constexpr std::array all_questions{Question::boundary_distance, Question::crossings, Question::de9im,
                                          Question::intersection};
const char* name(Question question);

/// Asks the library about two valid shapes of these kinds.
bool refuses(Question question, int kind_a, int kind_b);

}  // namespace properties
