// SPDX-License-Identifier: Apache-2.0
/// The questions of the stress test, and the one-line notation in which it prints and replays a case.
#pragma once

#include <vesica.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cast/face.hpp"
#include "properties/pair.hpp"

namespace stress {

using cast_test::Motion;
using properties::has_area;
using properties::is_curved;
using properties::is_inflated;
using properties::is_moderate;
using properties::is_round;
using properties::Numbers;
using properties::Pair;
using properties::Scalar;

enum class Query {
  overlap,
  relation,
  contains,
  nearest,
  boundary_distance,
  depth,
  area,
  iou,
  crossings,
  shape_area,    ///< of the first shape
  bounds,        ///< of the first shape
  ratio,         ///< all ratios of shared area at once
  cast,          ///< of the second shape, moved
  sweep_bounds,  ///< of the first shape, moved
  within,        ///< of a distance
  signed_distance,
  de9im,
  intersection,
  invalid,  ///< every function on a pair of which a shape is invalid
  batch,    ///< every batch function on many copies of the pair, on every instruction set
};

inline constexpr std::array all_queries{
    Query::overlap,         Query::relation, Query::contains,     Query::nearest,      Query::boundary_distance,
    Query::depth,           Query::area,     Query::iou,          Query::crossings,    Query::shape_area,
    Query::bounds,          Query::ratio,    Query::cast,         Query::sweep_bounds, Query::within,
    Query::signed_distance, Query::de9im,    Query::intersection, Query::invalid,      Query::batch};

const char* name(Query query);
std::optional<Query> find_query(const std::string& name);

/// Does the query look at the first shape only?
constexpr bool of_one_shape(Query query) {
  return query == Query::shape_area || query == Query::bounds || query == Query::sweep_bounds;
}
/// Does a shape move?
constexpr bool of_motion(Query query) { return query == Query::cast || query == Query::sweep_bounds; }

/// Does the query refuse these kinds (properties/refused.hpp)?
bool is_refused(Query query, int kind_a, int kind_b);

/// One question. For Scalar::f32 each number is a float's value.
struct Case {
  Query query;
  Scalar scalar;
  Pair pair;
  Motion motion{0, 0, 0};  ///< where a shape moves
  double distance = 0;     ///< of within
};

/// As in "overlap_f64 circle 0x0p+0 0x0p+0 0x1p+0 | point 0x1p+0 0x0p+0"; a motion follows as in " | v 0x1p+0 0x0p+0
/// end inf", a distance as in " | distance 0x1p+0".
std::string notation(const Case& c);

/// The case of a notation; "_f64" may be left out, numbers may be decimal. Nothing where it cannot be read.
std::optional<Case> parse(const std::string& text);

/// Reads the cases of a file, one notation a line; # begins a comment. Throws std::runtime_error if it cannot.
std::vector<Case> read_cases(const std::string& file);

}  // namespace stress
