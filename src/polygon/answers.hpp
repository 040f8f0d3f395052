// SPDX-License-Identifier: Apache-2.0
// Queries with a polygon or a polyline: one function each, for either scalar and both orders. Descriptors name them.
#pragma once

#include <cstdint>

namespace vesica {

namespace detail::polygon {
class KeptBoxes;
struct PathShares;
}  // namespace detail::polygon

/// A shape of any kind: a pointer to its struct, of doubles or floats.
struct Operand {
  std::int32_t kind;
  bool is_float;
  const void* shape;
  /// Boxes made for a path, which is valid then; or null.
  const detail::polygon::KeptBoxes* boxes = nullptr;
};

/// Answers as PairFunction does; at least one operand is a path.
using PathFunction = std::int32_t (*)(const Operand& a, const Operand& b, void* out) noexcept;

/// The same for queries of areas, once these are known.
using SharesFunction = std::int32_t (*)(const detail::polygon::PathShares& shares, bool is_float, void* out) noexcept;

namespace polygon {

/// By the edges.
std::int32_t overlap(const Operand& a, const Operand& b, void* out) noexcept;
/// Decides pairs without their edges: 1, 0 or filter::undecided, for overlap and for overlap of insides.
std::int32_t convex_overlap(const Operand& a, const Operand& b) noexcept;
std::int32_t depth(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t nearest(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t boundary_distance(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t signed_distance(const Operand& a, const Operand& b, void* out) noexcept;
/// out: a detail::polygon::Room, whose count is the answer.
std::int32_t crossings(const Operand& a, const Operand& b, void* out) noexcept;
/// A Within as a number, or an error. A row must have a core.
std::int32_t within(const Operand& a, const Operand& b, double distance) noexcept;

}  // namespace polygon
}  // namespace vesica
