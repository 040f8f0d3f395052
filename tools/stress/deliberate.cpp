// SPDX-License-Identifier: Apache-2.0
#include "stress/deliberate.hpp"

#include <vesica.h>

#include <cmath>

namespace stress {
namespace {

DeliberateFault in_use = nullptr;

/// An ellipse whose half lengths differ by more than 2^20.
bool thin_ellipse(int kind, const Numbers& n) { return kind == VESICA_ELLIPSE && n[5] > 0 && n[4] > 0x1p20 * n[5]; }

/// Rectangles that touch thin ellipses are said to miss them.
void touching_missed(Query query, Scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::overlap && p.kind_a == VESICA_RECT && thin_ellipse(p.kind_b, p.b) && answer.code == 1 &&
      ask(Query::relation, Scalar::f64, p).code == VESICA_TOUCH) {
    answer.code = 0;
  }
}

/// A filter without its guard: circles of floats far from the origin.
void guard_left_out(Query query, Scalar scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::overlap && scalar == Scalar::f32 && p.kind_a == VESICA_CIRCLE && p.kind_b == VESICA_CIRCLE &&
      std::fabs(p.a[0]) > 0x1p60) {
    answer.code = 1 - answer.code;
  }
}

/// The converse of "inside" is forgotten where the container is an AABB.
void converse_forgotten(Query query, Scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::relation && p.kind_a == VESICA_AABB && answer.code == VESICA_CONTAINS_TOUCH) {
    answer.code = VESICA_CONTAINS;
  }
}

/// Thin ellipses: a distance with a relative error of 2^-49.
void distance_off(Query query, Scalar scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::nearest && scalar == Scalar::f64 && thin_ellipse(p.kind_a, p.a)) {
    answer.numbers[0] *= 1 + 0x1p-49;
  }
}

/// Depths of circles in boxes are 2^-48 too great.
void depth_off(Query query, Scalar scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::depth && scalar == Scalar::f64 && p.kind_a == VESICA_AABB && p.kind_b == VESICA_CIRCLE) {
    answer.numbers[0] *= 1 + 0x1p-48;
  }
}

/// Areas of ellipses in boxes are 2^-40 too small.
void area_off(Query query, Scalar scalar, const Pair& p, const Environment&, Answer& answer) {
  const bool kinds = p.kind_a == VESICA_RECT && p.kind_b == VESICA_CIRCLE;
  if (query == Query::area && scalar == Scalar::f64 && kinds) answer.numbers[0] *= 1 - 0x1p-40;
}

/// A point on the outline of a rectangle is said to be further away than any distance.
void reach_short(Query query, Scalar, const Pair& p, const Environment&, Answer& answer) {
  const bool kinds = p.kind_a == VESICA_RECT && p.kind_b == VESICA_POINT;
  if (query == Query::within && kinds && ask(Query::relation, Scalar::f64, p).code == VESICA_CONTAINS_TOUCH)
    answer.code = 0;
}

/// A shared end of two segments is forgotten.
void end_forgotten(Query query, Scalar, const Pair& p, const Environment&, Answer& answer) {
  if (query == Query::de9im && p.kind_a == VESICA_SEGMENT && p.kind_b == VESICA_SEGMENT) answer.numbers[4] = -1;
}

/// Regions have one vertex less.
void vertex_lost(Query query, Scalar, const Pair&, const Environment&, Answer& answer) {
  if (query == Query::intersection && answer.code == 6) answer.code = 5;
}

/// Under denormals-are-zero a circle of subnormal radius is a point.
void environment_minded(Query query, Scalar, const Pair& p, const Environment& environment, Answer& answer) {
  constexpr unsigned daz = 0x40;
  if (query == Query::overlap && (environment.bits & daz) != 0 && p.kind_a == VESICA_CIRCLE && p.a[2] > 0 &&
      p.a[2] < 0x1p-1022) {
    answer.code = 0;
  }
}

/// The scalar functions stay right: see flips_lane().
void lane_flipped(Query, Scalar, const Pair&, const Environment&, Answer&) {}

struct Named {
  const char* name;
  DeliberateFault fault;
};
constexpr Named all[] = {{"touching_missed", touching_missed},
                         {"guard_left_out", guard_left_out},
                         {"converse_forgotten", converse_forgotten},
                         {"distance_off", distance_off},
                         {"depth_off", depth_off},
                         {"area_off", area_off},
                         {"reach_short", reach_short},
                         {"end_forgotten", end_forgotten},
                         {"vertex_lost", vertex_lost},
                         {"environment_minded", environment_minded},
                         {"lane_flipped", lane_flipped}};

}  // namespace

DeliberateFault deliberate_fault() { return in_use; }

bool flips_lane(Query query, const Pair& p, std::size_t element) {
  return in_use == lane_flipped && query == Query::overlap && element > 7 && p.kind_a == VESICA_CIRCLE &&
         p.kind_b == VESICA_SEGMENT && ask(Query::relation, Scalar::f64, p).code == VESICA_TOUCH;
}

bool use_deliberate_fault(const std::string& name) {
  for (const Named& candidate : all) {
    if (name == candidate.name) in_use = candidate.fault;
  }
  return in_use != nullptr;
}

std::string deliberate_fault_names() {
  std::string names;
  for (const Named& candidate : all) names += std::string(names.empty() ? "" : " ") + candidate.name;
  return names;
}

}  // namespace stress
