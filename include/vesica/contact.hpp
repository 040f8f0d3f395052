// SPDX-License-Identifier: Apache-2.0
/// How two shapes meet: the sign of the gap between them.
#pragma once

namespace vesica {

/// A contact of two shapes is -1 if their insides share a point, 0 if they only touch, and 1 if they are disjoint.
/// A question says which common points count: any, or only those inside both shapes. relation.hpp defines the inside
/// of every shape.
enum class Common : int { insides = -1, any = 0 };

constexpr bool counts(int contact, Common common) noexcept { return contact <= static_cast<int>(common); }

}  // namespace vesica
