// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstddef>

#include "cast/swept/contact.hpp"
#include "cast/swept/roots.hpp"

// An ellipse is X'AX <= 0 for a symmetric matrix A and X = (x, y, 1). Of two that are apart det(s A + B), a cubic in s,
// has two distinct positive roots; they are one where the two touch from outside, and else there is none (W. Wang, J.
// Wang, M.-S. Kim, 2001). So the times at which they begin or cease to touch are roots of the cubic's discriminant, a
// polynomial of degree 8 in t, and while they are apart it has none.

namespace swept {
namespace {

using Matrix = std::array<std::array<Integer, 3>, 3>;

Matrix sum(const Matrix& a, const Matrix& b, int sign) {
  Matrix c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[i][j] + sign * b[i][j];
  }
  return c;
}

Integer determinant(const Matrix& m) {
  const auto minor = [&](std::size_t j, std::size_t k) { return Integer(m[1][j] * m[2][k] - m[1][k] * m[2][j]); };
  return m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1);
}

/// (d x q)^2 + (p x d)^2 <= (p x q)^2 for d = (x, y) - c.
Matrix conic(const Figure& e, const Vector& c) {
  const Vector &p = e.p, &q = e.q;
  const Integer xx = q.y * q.y + p.y * p.y, xy = -q.x * q.y - p.x * p.y, yy = q.x * q.x + p.x * p.x;
  const Integer x = -xx * c.x - xy * c.y, y = -xy * c.x - yy * c.y, r = cross(p, q);
  return {{{xx, xy, x}, {xy, yy, y}, {x, y, -x * c.x - y * c.y - r * r}}};
}

Polynomial operator+(Polynomial f, const Polynomial& g) {
  if (f.size() < g.size()) f.resize(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) f[i] += g[i];
  return f;
}
Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial product(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) product[i + j] += f[i] * g[j];
  }
  return product;
}
Polynomial operator*(int k, Polynomial f) {
  for (Integer& c : f) c *= k;
  return f;
}
/// The same formula, of numbers and of polynomials.
template <class X>
X discriminant_of(const X& c0, const X& c1, const X& c2, const X& c3) {
  const X outer = c0 * c3, inner = c1 * c2;
  return inner * inner + 18 * (outer * inner) + -27 * (outer * outer) + -4 * (c1 * c1 * (c1 * c3)) +
         -4 * (c2 * c2 * (c2 * c0));
}

enum class State { apart, touching, overlapping };

class Ellipses : public Contact {
 public:
  explicit Ellipses(const Scene& s) {
    const Matrix a = conic(s.a, s.a.centre);
    std::array<Integer, 3> first, second;
    for (int t = -1; t <= 1; ++t) {
      const Vector moved{s.b.centre.x + t * s.velocity.x, s.b.centre.y + t * s.velocity.y};
      const Matrix b = conic(s.b, moved);
      if (t == -1) {
        c0_ = determinant(b);
        c3_ = determinant(a);
      }
      const Integer more = determinant(sum(b, a, 1)), less = determinant(sum(b, a, -1));
      first[static_cast<std::size_t>(t + 1)] = (more - less) / 2 - c3_;
      second[static_cast<std::size_t>(t + 1)] = (more + less) / 2 - c0_;
    }
    const auto through = [](const std::array<Integer, 3>& y) {
      return Polynomial{y[1], (y[2] - y[0]) / 2, (y[2] + y[0]) / 2 - y[1]};
    };
    c1_ = through(first);
    c2_ = through(second);
    at_start_ = state({0, 1});
  }

  bool by(const Time& t) const override {
    if (at_start_ != State::apart) return true;
    if (t.n == 0) return false;
    return (t.d != 0 && state(t) != State::apart) || touch_before(t);
  }
  bool begins_between(const Time& t, const Time& next) const override {
    const State now = state(t), soon = state(next);
    // The times of contact have no gap.
    if (soon == State::overlapping) return now != State::overlapping;
    return now != State::overlapping && !touch_before(t) && (now == State::touching || touch_before(next));
  }

 private:
  /// f(t) d^2.
  static Integer value(const Polynomial& f, const Time& t) {
    return (f[2] * t.n + f[1] * t.d) * t.n + f[0] * t.d * t.d;
  }

  State state(const Time& t) const {
    const Integer square = t.d * t.d, c1 = value(c1_, t), c2 = value(c2_, t), c0 = c0_ * square, c3 = c3_ * square;
    // c0 and c3 are negative: if all roots are real, two are positive where another coefficient is.
    if (c1 <= 0 && c2 <= 0) return State::overlapping;
    const int sign = sgn(discriminant_of<Integer>(c0, c1, c2, c3));
    return sign > 0 ? State::apart : sign == 0 ? State::touching : State::overlapping;
  }

  /// Of ellipses apart at 0.
  bool touch_before(const Time& t) const {
    return has_root_before(discriminant_of<Polynomial>({c0_}, c1_, c2_, {c3_}), t);
  }

  /// Coefficients of the cubic, constant first; two are polynomials in t.
  Integer c0_, c3_;
  Polynomial c1_, c2_;
  State at_start_;
};

}  // namespace

std::unique_ptr<Contact> ellipses(const Scene& scene) { return std::make_unique<Ellipses>(scene); }

}  // namespace swept
