// SPDX-License-Identifier: Apache-2.0
/// FCL's two GJK solvers on solids whose section with the plane is the shape: an ellipsoid about the ellipse's axis, a
/// box as thick as its shorter side, a sphere. Mirrored in the plane each solid is itself, so the closest points can be
/// taken in the plane, and the distance in space is the one asked for. The solver is called directly: the leanest way
/// in.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <algorithm>

#include "nearest/contestant.hpp"

namespace vesica::bench {
namespace {

template <std::int32_t kind>
struct Solid;

template <>
struct Solid<VESICA_RECT> {
  using Type = fcl::Boxd;
  static Type make(const Numbers& s) { return {2 * s[4], 2 * s[5], 2 * std::min(s[4], s[5])}; }
};
template <>
struct Solid<VESICA_CIRCLE> {
  using Type = fcl::Sphered;
  static Type make(const Numbers& s) { return Type(s[2]); }
};
template <>
struct Solid<VESICA_ELLIPSE> {
  using Type = fcl::Ellipsoidd;
  static Type make(const Numbers& s) { return {s[4], s[5], std::min(s[4], s[5])}; }
};

fcl::Transform3d place(std::int32_t kind, const Numbers& s) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.translation() = fcl::Vector3d(s[0], s[1], 0);
  if (kind == VESICA_CIRCLE) return result;
  fcl::Matrix3d turn;  // the axes here are of length 1
  turn << s[2], -s[3], 0, s[3], s[2], 0, 0, 0, 1;
  result.linear() = turn;
  return result;
}

template <class Solver, std::int32_t kind_a, std::int32_t kind_b>
class Solids final : public DistancePairs {
 public:
  explicit Solids(std::span<const OutlinePair> pairs) {
    for (const OutlinePair& p : pairs) {
      pairs_.push_back({Solid<kind_a>::make(p.a), Solid<kind_b>::make(p.b), place(kind_a, p.a), place(kind_b, p.b)});
    }
  }
  double distance(std::size_t pair) override {
    const Native& p = pairs_[pair];
    double result = 0;
    fcl::Vector3d on_a, on_b;
    solver_.shapeDistance(p.a, p.place_a, p.b, p.place_b, &result, &on_a, &on_b);
    return result;
  }

 private:
  struct Native {
    typename Solid<kind_a>::Type a;
    typename Solid<kind_b>::Type b;
    fcl::Transform3d place_a, place_b;
  };

  Solver solver_;
  std::vector<Native> pairs_;
};

template <class Solver>
std::unique_ptr<DistancePairs> make(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
  if (kind_b == VESICA_RECT) return std::make_unique<Solids<Solver, VESICA_RECT, VESICA_RECT>>(pairs);
  if (kind_a == VESICA_RECT) return std::make_unique<Solids<Solver, VESICA_RECT, VESICA_ELLIPSE>>(pairs);
  if (kind_a == VESICA_CIRCLE) return std::make_unique<Solids<Solver, VESICA_CIRCLE, VESICA_ELLIPSE>>(pairs);
  return std::make_unique<Solids<Solver, VESICA_ELLIPSE, VESICA_ELLIPSE>>(pairs);
}

const bool added = add_contestant({"FCL, GJK of its own", any_kinds, make<fcl::detail::GJKSolver_indepd>, 16}) &&
                   add_contestant({"FCL, GJK of libccd", any_kinds, make<fcl::detail::GJKSolver_libccdd>, 16});

}  // namespace
}  // namespace vesica::bench
