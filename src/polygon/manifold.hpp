// SPDX-License-Identifier: Apache-2.0
// The contacts of two shapes of any kinds. Not a Query, because a Query's results are numbers of one type.
#pragma once

#include <vesica/manifold.hpp>

#include "polygon/answers.hpp"

namespace vesica::polygon {

/// The count of contacts, or an error. The kinds have a core or vertices; T is the operands' scalar. On error `out` is
/// untouched.
template <class T>
std::int32_t manifold(const Operand& a, const Operand& b, Contacts<T>& out) noexcept;

}  // namespace vesica::polygon
