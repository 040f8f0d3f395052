// SPDX-License-Identifier: Apache-2.0
/// Pairs of kinds that a question refuses with VESICA_E_KIND. Tests that loop over kinds leave them out;
/// refused_test.cpp pins which they are.
#pragma once

#include <array>

namespace properties {

/// The questions that refuse some pairs. Containment is answered by the relation.
enum class Question { relation, boundary_distance, crossings, de9im, intersection };
inline constexpr std::array all_questions{Question::relation, Question::boundary_distance, Question::crossings,
                                          Question::de9im, Question::intersection};
const char* name(Question question);

/// Asks the library about two valid shapes of these kinds.
bool refuses(Question question, int kind_a, int kind_b);

}  // namespace properties
