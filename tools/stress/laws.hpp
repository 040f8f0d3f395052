// SPDX-License-Identifier: Apache-2.0
/// The laws of every answer: the header's promises, each with a name of its own.
#pragma once

#include <string>
#include <vector>

#include "stress/call.hpp"

namespace stress {

/// A promise that was not kept.
struct Fault {
  std::string law;  ///< as in "nearest.zero"
  std::string expected, got;
};

/// quick: laws that need no reference, and the exact stage; slow: the references too.
enum class Effort { quick, slow };

struct Choice {
  Effort effort;
  bool environments;  ///< ask again in every floating-point environment
};

/// Collects what is broken.
class Judge {
 public:
  explicit Judge(Query query) : query_(query) {}

  void demand(bool holds, const char* law, const std::string& expected, const std::string& got) {
    if (!holds) faults_.push_back({std::string(name(query_)) + '.' + law, expected, got});
  }
  void demand(bool holds, const char* law, double expected, double got);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  Query query_;
  std::vector<Fault> faults_;
};

/// All broken promises of one case.
std::vector<Fault> judge(const Case& c, const Choice& choice);

// The laws of single queries, by file. Shapes are valid, except for judge_invalid.
void judge_code(Judge& j, const Case& c, Effort effort);             // laws_code.cpp
void judge_nearest(Judge& j, const Case& c, Effort effort);          // laws_distance.cpp
void judge_boundary(Judge& j, const Case& c, Effort effort);         // laws_distance.cpp
void judge_depth(Judge& j, const Case& c, Effort effort);            // laws_depth.cpp
void judge_area(Judge& j, const Case& c, Effort effort);             // laws_area.cpp
void judge_iou(Judge& j, const Case& c, Effort effort);              // laws_area.cpp
void judge_shape_area(Judge& j, const Case& c, Effort effort);       // laws_area.cpp
void judge_crossings(Judge& j, const Case& c, Effort effort);        // laws_crossings.cpp
void judge_bounds(Judge& j, const Case& c, Effort effort);           // laws_bounds.cpp
void judge_ratio(Judge& j, const Case& c, Effort effort);            // laws_ratio.cpp
void judge_cast(Judge& j, const Case& c, Effort effort);             // laws_motion.cpp
void judge_sweep_bounds(Judge& j, const Case& c, Effort effort);     // laws_motion.cpp
void judge_within(Judge& j, const Case& c, Effort effort);           // laws_within.cpp
void judge_signed_distance(Judge& j, const Case& c, Effort effort);  // laws_within.cpp
void judge_de9im(Judge& j, const Case& c, Effort effort);            // laws_topology.cpp
void judge_intersection(Judge& j, const Case& c, Effort effort);     // laws_topology.cpp
void judge_invalid(Judge& j, const Case& c, bool in_environments);   // laws_invalid.cpp
void judge_environments(Judge& j, const Case& c);                    // laws.cpp

// Shared by several laws.
bool valid(const Pair& p);
/// An upper bound of all coordinates and half lengths, up to a few roundings; infinite if it overflows.
double extent(const Pair& p);
/// Are all numbers, and the products of sizes and axes, so small that no result can overflow?
bool far_from_overflow(Scalar scalar, const Pair& p);
/// A shape with a core and a radius, and numbers beyond 2^200 or below 2^-200. Such pairs are known to break laws of
/// areas, ratios and depths: a radius that vanishes beside a core of 2^800 counts as none. Those laws leave them out.
bool has_wild_radius(const Pair& p);
/// Both shapes moved by (x, y), where that is exact in the scalar type.
bool move_exactly(Scalar scalar, const Pair& p, double x, double y, Pair& moved);
/// Both shapes times a power of two, where that is exact; the motion stays.
bool scale_exactly(const Case& c, int exponent, Case& scaled);
/// Some moves to try, of the size of the pair; the first takes a's place to the origin.
std::vector<std::array<double, 2>> moves(const Pair& p);
/// A float answer is the double's rounded once: numbers[first ... first + count - 1].
void demand_rounded(Judge& j, const Case& c, const Answer& narrow, std::size_t count);
/// Sets the precision of the references' numbers: enough for the magnitudes of a pair and of the places in an answer.
void set_reference_precision(const Pair& p, const Answer& answer);
std::string hex(double x);

}  // namespace stress
