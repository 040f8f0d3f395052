// SPDX-License-Identifier: Apache-2.0
/// The direction of the shortest connection in twice the precision, for where direction.hpp and double leave too much:
/// nearly all of a needle's outline is between two directions that a vector with rounded coordinates may not
/// distinguish.
#pragma once

#include <vesica/nearest/box_ellipse.hpp>

namespace vesica::detail::nearest {

/// As FoundDirection, a vector of any length.
struct FoundNormal {
  Vector<double> n;
  bool found;
  int steps;
};

/// A search that is not at rest by then is mostly led by rounding, and bracketed_normal() ends sooner.
inline constexpr int most_farthest_steps = 40;

/// farthest_direction(), support() and separation() as calls, which are shorter.
template <class Shapes>
VESICA_CALLED FoundNormal farthest_normal(const Shapes& shapes, const Vector<double>& d, double size) noexcept {
  const FoundDirection<double> best =
      farthest_direction(shapes, Direction<double>{d.x.high, d.y.high}, size, most_farthest_steps);
  return {twofold(best.n), best.found, best.steps};
}
VESICA_CALLED inline Support<double> called_support(const Axes<double>& e, const NormalOf<double>& n) noexcept {
  return support(e, n);
}
VESICA_CALLED inline ClosestOffsets<double> called_separation(const Vector<double>& d, const NormalOf<double>& n,
                                                              const Support<double>& of_a, const Support<double>& of_b,
                                                              double flatness, double size, double smooth) noexcept {
  return separation(d, n, of_a, of_b, flatness, size, smooth);
}

inline ClosestOffsets<double> offsets_along(const OneEllipse<double>& s, const Vector<double>& d,
                                            const NormalOf<double>& n, double size, double smooth = 1) noexcept {
  const Support<double> of_a = called_support(s.a, n);
  return called_separation(d, n, no_support<double>(), of_a, flatness(s.sa, of_a), size, smooth);
}
inline ClosestOffsets<double> offsets_along(const TwoEllipses<double>& s, const Vector<double>& d,
                                            const NormalOf<double>& n, double size) noexcept {
  const Support<double> of_a = called_support(s.a, n), of_b = called_support(s.b, n);
  return called_separation(d, n, of_a, of_b, max(flatness(s.sa, of_a), flatness(s.sb, of_b)), size, 1);
}
template <class Shapes>
VESICA_CALLED ClosestOffsets<double> offsets_along(const Shapes& shapes, const Vector<double>& d,
                                                   const FoundNormal& along, double size) noexcept {
  ClosestOffsets<double> result = offsets_along(shapes, d, normal(factor(along.n)), size);
  result.settled = result.settled && along.found;
  return result;
}

inline Vector<double> turned(const Vector<double>& n, double tangent) noexcept {
  const auto t = factor(tangent);
  return renormalised(Vector<double>{n.x - t * factor(n.y), n.y + t * factor(n.x)});
}

/// Each turn of Newton's method doubles the digits, if it is short.
inline constexpr int most_refining_turns = 3;
inline constexpr double longest_refining_turn = 0.25;

/// A direction and what is along it.
struct Refined {
  FoundNormal along;
  ClosestOffsets<double> at;
};

/// From farthest_normal() a few steps of Newton's method.
template <class Shapes>
VESICA_COLD Refined refined(const Shapes& shapes, const Vector<double>& d, double size, Refined found) noexcept {
  for (int k = 0; k < most_refining_turns; ++k) {
    if (found.at.settled || abs(found.at.turn) > longest_refining_turn) break;
    found.along.n = turned(found.along.n, found.at.turn);
    found.at = offsets_along(shapes, d, found.along, size);
  }
  return found;
}

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

/// The frame of the ellipse that is flatter where the two are closest, given farthest_normal().
inline Frame frame_of_flatter(const TwoEllipses<double>& s, const FoundNormal& best) noexcept {
  const Direction<double> n{best.n.x.high, best.n.y.high};
  const double a = s.sa.longer_squared * image(s.sb, n).square, b = s.sb.longer_squared * image(s.sa, n).square;
  return Frame(a > b || (a == b && in_order(n.x, n.y)) ? s.a : s.b);
}

/// A step within a bracket goes to where the slope is likely to be 0 and a little beyond, so that the bracket closes
/// from both sides. It is taken if it is at most half as long as the one taken just before; else the bracket is halved.
inline constexpr double beyond_guess = 1 + 0x1p-10;
/// For certainty: one halving in three at least is of the angle or its logarithm, and 62 of them close any bracket.
inline constexpr int most_bracket_steps = 400;

/// A slope below this share of its terms is of rounding alone.
inline constexpr double lost_slope = 0x1p-52;

/// For ellipses not thinner than 2^-52 a normal turned by this belongs to the same point.
inline constexpr double least_turn = 0x1p-200;

/// True if rounding leaves nothing between its ends, which are about 1 long, or nothing that matters.
inline bool is_closed(const Bracket<double>& b) noexcept {
  const double p = b.low.x * b.high.y, q = b.low.y * b.high.x;
  return p - q <= 0x1p-52 * (abs(p) + abs(q)) + least_turn;
}

/// The axis of the frame that is between the ends; or, where one end is far nearer to an axis than the other, what is
/// halfway between them by powers of two; else false. Halving the angle, each power would take a step.
VESICA_CALLED inline bool halves_powers(const Bracket<double>& b, Direction<double>& n) noexcept {
  const auto is_far = [](double p, double q) { return max(p, q) > 16 * min(p, q); };
  const auto differ = [](double p, double q) { return max(p, q) > 0 && min(p, q) < 0; };
  const Direction<double> signs{std::copysign(1.0, b.low.x + b.high.x), std::copysign(1.0, b.low.y + b.high.y)};
  if (differ(b.low.x, b.high.x) || differ(b.low.y, b.high.y)) {
    n = differ(b.low.x, b.high.x) ? Direction<double>{0, signs.y} : Direction<double>{signs.x, 0};
    return true;
  }
  const auto slope = [](const Direction<double>& v) {
    return max(least_turn, min(1 / least_turn, abs(v.y) / abs(v.x)));
  };
  const double p = slope(b.low), q = slope(b.high);
  n = about_unit(signs.x, signs.y * (std::sqrt(p) * std::sqrt(q)));
  return is_far(p, q);
}
/// As middle(), or by powers of two in every other step.
template <class Shapes>
Direction<double> halfway(const Shapes& shapes, const Direction<double>& d, const Bracket<double>& bracket,
                          int step) noexcept {
  Direction<double> n;
  return step % 2 == 1 && halves_powers(bracket, n) ? n : middle(shapes, d, bracket, step);
}
/// Between the ends and, up to rounding, at neither.
inline bool is_inside(const Direction<double>& n, const Bracket<double>& b) noexcept {
  return cross(b.low, n) > 0 && cross(n, b.high) > 0;
}

/// farthest_normal() by the signs of slopes alone, to the last place of the direction in a frame.
template <class Shapes>
VESICA_COLD FoundNormal bracketed_normal(const Shapes& shapes, const Vector<double>& d, double size,
                                         const Frame& frame) noexcept {
  const Shapes seen = frame.of(shapes);
  const Direction<double> towards = frame.of(d);
  Direction<double> n = first_direction(seen, towards);
  Bracket<double> bracket = first_bracket(about_unit(towards.x, towards.y), n);
  double tangent_before = 0x1p1000;
  int step = 0, halvings = 0;
  for (; step < most_bracket_steps && !is_closed(bracket); ++step) {
    const Turn<double> turn = turn_at(seen, towards, size, n);
    if (abs(turn.slope) <= lost_slope * turn.terms) break;
    (turn.slope > 0 ? bracket.low : bracket.high) = n;
    const Direction<double> guess = turned(n, beyond_guess * turn.tangent);
    n = about_unit(guess.x, guess.y);
    const bool guessed = turn.sane && abs(turn.tangent) <= 0.5 * tangent_before && is_inside(n, bracket);
    tangent_before = guessed ? abs(turn.tangent) : 0x1p1000;
    if (!guessed) n = halfway(seen, towards, bracket, halvings++);
    // Rounding may lead to an end, or beyond.
    if (!is_inside(n, bracket)) n = middle(bracket);
    if (!is_inside(n, bracket)) break;
  }
  return {frame.back(n), true, step};
}

/// The distance of an ellipse from a feature of a box, of a vertex along a direction that was found from it.
VESICA_CALLED inline BoxEllipse<double> at_feature(const Box<double>& box, const OneEllipse<double>& e,
                                                   const Vector<double>& d, double size, const Feature<double>& f,
                                                   const Vector<double>& from_vertex,
                                                   const FoundNormal& along) noexcept {
  const NormalOf<double> n = feature_normal(box, f, along.n);
  const ClosestOffsets<double> found = offsets_along(e, from_vertex, n, size, f.face_x || f.face_y ? 0 : 1);
  return on_feature(box, d, size, f, n.unit, along.found, found);
}

/// The same with a search: farthest_normal(), or another with its arguments.
template <class Search>
BoxEllipse<double> searched_feature(const Box<double>& box, const Axes<double>& e, const Vector<double>& d, double size,
                                    const Feature<double>& f, const Search& search, int& steps) noexcept {
  const Vector<double> from_vertex = renormalised(d - vertex(box, f.i, f.j));
  const OneEllipse<double> shape = one_ellipse(e);
  FoundNormal along{};
  if (!f.face_x && !f.face_y) along = search(shape, from_vertex, size);
  steps = along.steps;
  return at_feature(box, shape, d, size, f, from_vertex, along);
}

}  // namespace vesica::detail::nearest
