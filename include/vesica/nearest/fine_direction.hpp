// SPDX-License-Identifier: Apache-2.0
/// The direction of the shortest connection in twice the precision, for where direction.hpp and double leave too much:
/// nearly all of a needle's outline is between two directions that a vector with rounded coordinates may not tell
/// apart.
#pragma once

#include <vesica/nearest/closest_offsets.hpp>

namespace vesica::detail::nearest {

/// As FoundDirection, a vector of any length.
struct FoundNormal {
  Vector<double> n;
  bool found;
  int steps;
};

inline Vector<double> turned(const Vector<double>& n, double tangent) noexcept {
  const auto t = factor(tangent);
  return renormalised(Vector<double>{n.x - t * factor(n.y), n.y + t * factor(n.x)});
}

/// farthest_direction(), and from there a few steps of Newton's method.
struct Refining {
  /// Each doubles the digits, if it is short.
  static constexpr int most_turns = 3;
  static constexpr double longest_turn = 0.25;

  template <class Shapes>
  FoundNormal operator()(const Shapes& shapes, const Vector<double>& d, double size) const noexcept {
    const FoundDirection<double> rough = Farthest{}(shapes, d, size);
    FoundNormal best{twofold(rough.n), rough.found, rough.steps};
    for (int k = 0; k < most_turns; ++k) {
      const ClosestOffsets<double> at = separation(shapes, d, normal(factor(best.n)), size);
      if (at.settled || abs(at.turn) > longest_turn) break;
      best.n = turned(best.n, at.turn);
    }
    return best;
  }
};

/// The axis of an ellipse as a frame to search in, where directions near the ellipse's own normals have all their
/// digits.
class Frame {
 public:
  explicit Frame(const Axes<double>& e) noexcept : u_(factor(e.ux, e.uy)) {}

  Direction<double> of(const Vector<double>& v) const noexcept {
    const auto f = factor(renormalised(v));
    return {rounded(dot(u_, f)), rounded(cross(u_, f))};
  }
  Axes<double> of(const Axes<double>& e) const noexcept {
    const Direction<double> axis = of(twofold(Direction<double>{e.ux, e.uy}));
    return {axis.x, axis.y, e.a, e.b};
  }
  OneEllipse<double> of(const OneEllipse<double>& s) const noexcept { return one_ellipse(of(s.a)); }
  TwoEllipses<double> of(const TwoEllipses<double>& s) const noexcept { return two_ellipses(of(s.a), of(s.b)); }

  Vector<double> back(const Direction<double>& n) const noexcept {
    const auto x = factor(n.x), y = factor(n.y);
    return renormalised(Vector<double>{u_.x * x - u_.y * y, u_.y * x + u_.x * y});
  }

 private:
  VectorFactor<Factor<double>> u_;
};

inline Frame frame_for(const OneEllipse<double>& s, const Vector<double>&, double) noexcept { return Frame(s.a); }
/// Of two ellipses that of the one that is the flatter where they are closest, to rounding.
inline Frame frame_for(const TwoEllipses<double>& s, const Vector<double>& d, double size) noexcept {
  const Direction<double> n = Farthest{}(s, d, size).n;
  const double a = s.sa.longer_squared * image(s.sb, n).square, b = s.sb.longer_squared * image(s.sa, n).square;
  return Frame(a > b || (a == b && in_order(n.x, n.y)) ? s.a : s.b);
}

/// farthest_direction() by halving alone, to the last place of the direction in a frame.
struct Halving {
  /// Two brackets are halved by turns, that of angles and that which the ellipse sees: more than the digits of both.
  static constexpr int most_steps = 128;

  template <class Shapes>
  FoundNormal operator()(const Shapes& shapes, const Vector<double>& d, double size) const noexcept {
    const Frame frame = frame_for(shapes, d, size);
    const Shapes seen = frame.of(shapes);
    const Direction<double> towards = frame.of(d);
    Direction<double> n = first_direction(seen, towards);
    Bracket<double> bracket = first_bracket(towards, n);
    int step = 0;
    for (; step < most_steps && !is_closed(bracket); ++step) {
      (turn_at(seen, towards, size, n).slope > 0 ? bracket.low : bracket.high) = n;
      n = middle(seen, towards, bracket, step);
    }
    return {frame.back(n), true, step};
  }

 private:
  /// Whether rounding leaves nothing between its ends.
  static bool is_closed(const Bracket<double>& b) noexcept {
    const double p = b.low.x * b.high.y, q = b.low.y * b.high.x;
    return p - q <= 0x1p-52 * (abs(p) + abs(q));
  }
};

}  // namespace vesica::detail::nearest
