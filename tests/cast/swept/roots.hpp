// SPDX-License-Identifier: Apache-2.0
/// Has an integer polynomial a real root before some time?
#pragma once

#include <vector>

#include "cast/swept/plane.hpp"

namespace swept {

/// Coefficients, constant first.
using Polynomial = std::vector<Integer>;

/// Is there a root in the open interval from 0 to t? f is not 0 there, nor at infinity if t is infinite.
bool has_root_before(const Polynomial& f, const Time& t);

}  // namespace swept
