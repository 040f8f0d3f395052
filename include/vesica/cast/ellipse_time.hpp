// SPDX-License-Identifier: Apache-2.0
/// The time of first contact of two ellipses where exponents are unlike: to about 100 bits, without trials.
///
/// It is the greatest T(n) (bound.hpp), n = -v + s perp(v). The axes of both ellipses, what is across them, and perp(v)
/// cut the directions into sectors. In the one from e to f, n = e + l f with l > 0: there u.n, u x n and n.v are sums
/// of terms of one sign, so that nothing cancels in them. And half of an ellipse along an axis is a vector without a
/// root. With p = hx |u.n| and q = hy |u x n|,
///
///     h = sqrt(p^2 + q^2) = p + q^2 / (h + p) = q + p^2 / (h + q)
///
/// so the terms that may cancel in n.D - h_a - h_b where exponents are unlike are those of n.D', where D' leads from
/// the end of an axis to that of another, and is exact. The same holds for the slope of T, w - perp(v).x (bound.hpp),
/// the point x of M being near such ends.
///
/// The l at which the slope is 0 is found in doubles of any exponent. Then T is evaluated there to 100 bits or from
/// leading digits. What a better l would gain is added, with a bound on its error; Newton's method gives a better one,
/// from the same digits. So a bad l costs time, and never a wrong answer.
#pragma once

#include <vesica/cast/ellipse_contact.hpp>
#include <vesica/cast/share_search.hpp>

namespace vesica::detail::cast {

inline Wide wide(const Rough& x) noexcept { return Wide(x.scaled()); }
inline Wide magnitude(const Wide& x) noexcept { return arithmetic::abs(x); }
inline Rough magnitude(const Rough& x) noexcept { return x.sign() < 0 ? -x : x; }
inline Digits magnitude(const Digits& x) noexcept { return exact::abs(x); }
template <class Real>
Real turned(const Real& x, int sign) noexcept {
  return sign < 0 ? -x : x;
}

/// What bounds a sector: an axis of an ellipse or what is across that, turned against v; or what is across v.
struct SectorEdge {
  static constexpr int across_v = -1;
  int ellipse, sign;
  bool turned;
};

/// A direction e as seen from both ellipses, by u.e and u x e, and -e.v.
template <class Real>
struct SeenDirection {
  Real along[2], across[2], against;
};

/// A pair of ellipses whose line enters M after the start and does not graze it.
class SeenEllipses {
  using Few = Leading<exact::few_limbs>;

 public:
  explicit SeenEllipses(const ExactPair& pair) noexcept
      : pair_(pair), body_{&pair.a_, &pair.b_}, squared_{&pair.reach_a_.squared, &pair.reach_b_.squared} {
    const exact::Box &a = body_[0]->box, &b = body_[1]->box;
    dot_ = exact::dot(a.ux, a.uy, b.ux, b.uy);
    cross_ = exact::cross(a.ux, a.uy, b.ux, b.uy);
    for (int i = 0; i < 2; ++i) {
      const exact::Box& e = body_[i]->box;
      uu_[i] = exact::dot(e.ux, e.uy, e.ux, e.uy);
      c_[i] = exact::dot(e.ux, e.uy, pair.vx_, pair.vy_);
      k_[i] = exact::cross(e.ux, e.uy, pair.vx_, pair.vy_);
      beside_x_[i] = e.hx * k_[i];
      beside_y_[i] = e.hy * c_[i];
      if (c_[i].sign != 0) insert({i, -c_[i].sign, false});
      if (k_[i].sign != 0) insert({i, -k_[i].sign, true});
    }
    sizes_ = sizes<Wide>();
    vv_ = from_exact<Wide>(pair.vv_);
  }

  /// The greatest T(n).
  WideTime time() noexcept {
    find_sector();
    Digits share = digits(find_share(), most_limbs);
    Terms<Rough> few = terms<Rough>();
    ShareSearch search;
    const int limit = pair_.is_long() ? most_limbs : exact::few_limbs;  // of short numbers trials are as quick
    for (int i = 0;; ++i) {
      const Evaluated at = limbs_ == 0 ? evaluate(rough(share), few) : evaluate(share.with_limbs(limbs_));
      const WideTime found{at.time, at.is_near};
      if (at.is_near && at.is_below_all_doubles()) return {Rough(crossings::Real(1.0), 0, least_exponent), true};
      if (found.tells() || i == most_steps || (limbs_ == limit && at.more_digits)) return found;
      // A step of 100 bits gains some 200. Of a direction that is not near only its side is asked.
      if (at.more_digits && (at.is_near || at.step.sign() == 0)) limbs_ += exact::few_limbs;
      const Wide l = wide(share), step = wide(at.step);
      if (at.is_near || step.sign() == 0 || step.exponent < l.exponent - 2) {
        // This is the direction now.
        share = (share + digits(at.step, most_limbs)).with_limbs(most_limbs);
      } else {
        share = digits(search.next(l, step), most_limbs);
      }
      if (share.sign <= 0 || std::abs(wide(share).exponent) > ShareSearch::far) return found;
    }
  }

 private:
  static constexpr int least_exponent = -1100;  ///< below those of doubles
  static constexpr int most_steps = 20;         ///< of Newton's method, each of some 100 bits
  static constexpr int most_trials = 60;        ///< before them, of l
  static constexpr int most_limbs = exact::more_limbs;
  static_assert(most_limbs % exact::few_limbs == 0);

  /// Numbers of some type from exact ones.
  template <class Real, int Degree>
  Real from_exact(const Number<Degree>& x) const noexcept {
    if constexpr (std::is_same_v<Real, Wide>) {
      return Wide(exact::rounded(x));
    } else if constexpr (std::is_same_v<Real, Digits>) {
      return Digits(x, limbs_);
    } else {
      return Real(x);
    }
  }

  /// By s. Of two directions against v, e is before f iff e x f < 0. Those of the first ellipse are there first.
  void insert(const SectorEdge& e) noexcept {
    int at = edges_++;
    for (; at > 0 && is_before(e, edge_[at - 1]); --at) edge_[at] = edge_[at - 1];
    edge_[at] = e;
  }
  bool is_before(const SectorEdge& e, const SectorEdge& f) const noexcept {
    const int dot = e.ellipse == f.ellipse ? 1 : dot_.sign;
    const int cross = e.ellipse == f.ellipse ? 0 : -cross_.sign;
    return e.sign * f.sign * (e.turned == f.turned ? cross : e.turned ? -dot : dot) < 0;
  }

  /// Of ellipses; area: hx hy u.u.
  template <class Real>
  struct Sizes {
    Real hx[2], hy[2], area[2], by_k[2], by_c[2];
  };
  template <class Real>
  Sizes<Real> sizes() const noexcept {
    Sizes<Real> s;
    for (int i = 0; i < 2; ++i) {
      const exact::Box& e = body_[i]->box;
      s.hx[i] = from_exact<Real>(e.hx);
      s.hy[i] = from_exact<Real>(e.hy);
      s.area[i] = s.hx[i] * s.hy[i] * from_exact<Real>(uu_[i]);
      s.by_k[i] = from_exact<Real>(beside_x_[i]);
      s.by_c[i] = from_exact<Real>(beside_y_[i]);
    }
    return s;
  }

  template <class Real>
  VESICA_COLD SeenDirection<Real> seen(const SectorEdge& e) const noexcept {
    SeenDirection<Real> out;
    const auto set = [&out, &e](int i, const Real& along, const Real& across) {
      out.along[i] = turned(along, e.sign);
      out.across[i] = turned(across, e.sign);
    };
    if (e.ellipse == SectorEdge::across_v) {
      for (int i = 0; i < 2; ++i) set(i, -from_exact<Real>(k_[i]), from_exact<Real>(c_[i]));
      return out;
    }
    const int own = e.ellipse, other = 1 - own;
    const Real uu = from_exact<Real>(uu_[own]), dot = from_exact<Real>(dot_),
               cross = turned(from_exact<Real>(cross_), own == 0 ? 1 : -1);
    e.turned ? set(own, {}, uu) : set(own, uu, {});
    e.turned ? set(other, cross, dot) : set(other, dot, -cross);
    out.against = magnitude(from_exact<Real>(e.turned ? k_[own] : c_[own]));
    return out;
  }

  /// n = e + l f, signs left out.
  template <class Real>
  static SeenDirection<Real> between(const SeenDirection<Real>& e, const SeenDirection<Real>& f,
                                     const Real& l) noexcept {
    SeenDirection<Real> n;
    for (int i = 0; i < 2; ++i) {
      n.along[i] = magnitude(e.along[i] + l * f.along[i]);
      n.across[i] = magnitude(e.across[i] + l * f.across[i]);
    }
    n.against = e.against + l * f.against;
    return n;
  }

  /// How far an ellipse reaches along n, h; beyond the end of its axis hx u, or of hy perp(u), by rest / sum. How far
  /// beside that its point farthest along n lies: beside / (h sum).
  template <class Real>
  struct Reach {
    Real p, q, h, sum, rest, beside;
  };
  template <class Real>
  Reach<Real> reach(const Sizes<Real>& s, const SeenDirection<Real>& n, int i, bool by_x) const noexcept {
    Reach<Real> r;
    r.p = s.hx[i] * n.along[i];
    r.q = s.hy[i] * n.across[i];
    r.h = root(square(r.p) + square(r.q));
    r.sum = r.h + (by_x ? r.p : r.q);
    r.rest = square(by_x ? r.q : r.p);
    const Real along = turned(s.by_k[i] * (by_x ? r.rest : r.p * r.sum), sign_x_[i]);
    const Real across = turned(s.by_c[i] * (by_x ? r.q * r.sum : r.rest), sign_y_[i]);
    r.beside = turned(along + across, by_x ? 1 : -1);
    return r;
  }
  /// The nearer end.
  bool is_by_x(const SeenDirection<Wide>& n, int i) const noexcept {
    return !(sizes_.hx[i] * n.along[i] < sizes_.hy[i] * n.across[i]);
  }

  /// v x D'.
  Number<3> straight(bool a_by_x, bool b_by_x) const noexcept {
    Number<3> w = pair_.w_;
    for (int i = 0; i < 2; ++i) {
      const bool by_x = i == 0 ? a_by_x : b_by_x;
      Number<3> end = by_x ? beside_x_[i] : beside_y_[i];
      end.sign *= by_x ? sign_x_[i] : -sign_y_[i];
      w = w + end;
    }
    return w;
  }

  void set_sector(const SectorEdge& e, const SectorEdge& f) noexcept {
    from_ = e, to_ = f;
    wide_from_ = seen<Wide>(e), wide_to_ = seen<Wide>(f);
    for (int i = 0; i < 2; ++i) {
      const auto sign = [](const Wide& x, const Wide& y) { return x.sign() != 0 ? x.sign() : y.sign(); };
      sign_x_[i] = sign(wide_from_.along[i], wide_to_.along[i]);
      sign_y_[i] = sign(wide_from_.across[i], wide_to_.across[i]);
    }
    for (bool& known : straight_known_) known = false;
  }
  /// In which the slope changes its sign.
  void find_sector() noexcept {
    int low = -1, high = edges_;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      set_sector(edge_[middle], edge_[middle]);
      (slope({}).value.sign() > 0 ? low : high) = middle;
    }
    set_sector(low < 0 ? SectorEdge{SectorEdge::across_v, -1, false} : edge_[low],
               high == edges_ ? SectorEdge{SectorEdge::across_v, 1, false} : edge_[high]);
    if (low < 0 || high == edges_) find_gap(low < 0 ? -1 : 1);
  }
  /// The reach across v less w, by (x^2 - w^2) / (x + w) where it cancels; 0 where it is not known well.
  void find_gap(int side) noexcept {
    const Rough a = root(Rough(*squared_[0])), b = root(Rough(*squared_[1])), w = turned(Rough(pair_.w_), side),
                twice = crossings::times(2, a * b);
    Rough gap = a + b - w;
    if (!gap.is_precise()) {
      const Few of_a(*squared_[0]), of_b(*squared_[1]), rest = square(Few(pair_.w_)) - of_a - of_b;
      Rough over = twice - rough(rest);
      if (!over.is_precise()) over = rough(times(4, of_a * of_b) - square(rest)) / (twice + rough(rest));
      gap = over / (a + b + w);
    }
    gap_ = gap.is_precise() ? wide(gap) : Wide{};
  }

  /// The slope in s at a share l, how steeply it falls, and how far s may change for that to hold roughly. Of the terms
  /// of either sign, how many times more is there of the positive ones, and by which power of l that falls.
  struct Slope {
    Wide value, fall, room, against;
    int excess = 0;
    double power = 1;
  };
  Slope slope(const Wide& l) const noexcept {
    const SeenDirection<Wide> n = between(wide_from_, wide_to_, l);
    const bool a_by_x = is_by_x(n, 0), b_by_x = is_by_x(n, 1);
    const Reach<Wide> a = reach(sizes_, n, 0, a_by_x), b = reach(sizes_, n, 1, b_by_x);
    const int which = (a_by_x ? 1 : 0) + (b_by_x ? 2 : 0);
    if (!straight_known_[which]) straight_[which] = from_exact<Wide>(straight(a_by_x, b_by_x));
    straight_known_[which] = true;
    Wide falls[2];
    Slope out = fall(n.against, a.h, b.h, falls);
    const Wide& known = straight_[which];
    Wide positive, negative, falling, rising;
    if (gap_.sign() > 0 && gap_ < arithmetic::abs(known)) {
      const bool is_last = to_.ellipse == SectorEdge::across_v;
      const Wide rest = left_of_reach(n, a, 0) + left_of_reach(n, b, 1);
      positive = is_last ? rest : gap_, negative = is_last ? gap_ : rest;
      (is_last ? falling : rising) = out.fall;
    } else {
      (known.sign() > 0 ? positive : negative) = arithmetic::abs(known);
      for (int i = 0; i < 2; ++i) {
        const Reach<Wide>& r = i == 0 ? a : b;
        const Wide part = r.beside / (r.h * r.sum);
        if (part.sign() > 0) {
          negative = negative + part, rising = rising + falls[i];
        } else {
          positive = positive - part, falling = falling + falls[i];
        }
      }
    }
    out.value = positive - negative;
    if (out.value.exponent < positive.exponent - 50) out.value = {};  // rounding errors
    if (l.sign() > 0 && positive.sign() > 0 && negative.sign() > 0) {
      const Wide power = l / as_share({1, 0}, n.against) * (falling / positive + rising / negative);
      out.excess = positive.exponent - negative.exponent;
      out.power = power.value * arithmetic::scale(1, power.exponent);
    }
    return out;
  }
  /// What its reach across v is more than perp(v).x.
  Wide left_of_reach(const SeenDirection<Wide>& n, const Reach<Wide>& r, int i) const noexcept {
    const Wide across = arithmetic::root(wide(Few(*squared_[i]))), area = sizes_.area[i] * n.against;
    const Wide product = r.p * arithmetic::abs(sizes_.by_k[i]) + r.q * arithmetic::abs(sizes_.by_c[i]);
    return area * area / (r.h * (across * r.h + product));
  }
  Slope fall(const Wide& against, const Wide& height_a, const Wide& height_b, Wide (&falls)[2]) const noexcept {
    Slope out;
    out.against = against;
    for (int i = 0; i < 2; ++i) {
      const Wide h = (i == 0 ? height_a : height_b) * vv_ / against, area = sizes_.area[i] * vv_;
      falls[i] = area * area / (h * h * h);
      const Wide room = h / (arithmetic::root(wide(Few(*squared_[i]))) * Wide{8, 0});
      if (i == 0 || room < out.room) out.room = room;
    }
    out.fall = falls[0] + falls[1];
    return out;
  }
  /// A change of s as one of l: dl / ds = (n.v)^2 / (v.v |e x f|).
  Wide as_share(const Wide& step, const Wide& against) const noexcept {
    return step * against * against / (vv_ * width(wide_from_, wide_to_));
  }
  /// |e x f|
  template <class Real>
  Real width(const SeenDirection<Real>& e, const SeenDirection<Real>& f) const noexcept {
    const bool from_ellipse = from_.ellipse != SectorEdge::across_v;
    const SectorEdge& edge = from_ellipse ? from_ : to_;
    const SeenDirection<Real>& other = from_ellipse ? f : e;
    return magnitude(edge.turned ? other.along[edge.ellipse] : other.across[edge.ellipse]);
  }

  /// From where on n is e, and f, but for what is 0 there.
  void find_bends(Wide& first, Wide& last) const noexcept {
    const auto look = [&](const Wide& e, const Wide& f) {
      if (e.sign() == 0 || f.sign() == 0) return;
      const Wide x = arithmetic::abs(e / f);
      if (first.sign() == 0 || x < first) first = x;
      if (last < x) last = x;
    };
    for (int i = 0; i < 2; ++i) {
      look(wide_from_.along[i], wide_to_.along[i]);
      look(wide_from_.across[i], wide_to_.across[i]);
    }
    look(wide_from_.against, wide_to_.against);
    if (first.sign() == 0) first = last = {1, 0};
  }

  /// By Newton's method, on the logarithms where terms of unlike sizes are to be equal; within a bracket.
  Wide find_share() const noexcept {
    Wide first, last;
    find_bends(first, last);
    Wide l = arithmetic::root(first * last), low{1, first.exponent - 5000}, high{1, last.exponent + 5000};
    for (int i = 0, size = 0;; ++i) {
      const Slope at = slope(l);
      (at.value.sign() > 0 ? low : high) = l;
      const bool is_slow = i > 4 && at.value.exponent > size - 3;
      size = at.value.exponent;
      Wide next = l;
      if (std::abs(at.excess) > 2 && at.power < 4 && i < most_trials) {
        next.exponent += static_cast<int>(lane::max(-5000.0, lane::min(5000.0, at.excess / at.power)));
      } else {
        next = l + as_share(at.value / at.fall, at.against);
        const Wide change = arithmetic::abs(next - l);
        if (change.sign() == 0 || change.exponent < l.exponent - 26 || i > most_trials) return l;
      }
      if (is_slow || !(low < next) || !(next < high)) next = arithmetic::root(low * high);
      if (last < next && l < last) next = last;
      if (next < first && first < l) next = first;
      l = next;
    }
  }

  /// Of the ends of an axis of either ellipse: v x D', e.D' and f.D'.
  template <class Real>
  struct Ends {
    Real straight, along_e, along_f;
  };
  template <class Real>
  Ends<Real> ends(bool a_by_x, bool b_by_x) const noexcept {
    Number<2> x = pair_.dx_, y = pair_.dy_;
    for (int i = 0; i < 2; ++i) {
      const exact::Box& e = body_[i]->box;
      const bool by_x = i == 0 ? a_by_x : b_by_x;
      Number<1> size = by_x ? e.hx : e.hy;
      size.sign *= by_x ? sign_x_[i] : sign_y_[i];
      x = by_x ? x - size * e.ux : x + size * e.uy;
      y = by_x ? y - size * e.uy : y - size * e.ux;
    }
    const auto along = [&](const SectorEdge& e) {
      const bool is_across_v = e.ellipse == SectorEdge::across_v, by_cross = is_across_v || e.turned;
      const Number<1>&ux = is_across_v ? pair_.vx_ : body_[e.ellipse]->box.ux,
            &uy = is_across_v ? pair_.vy_ : body_[e.ellipse]->box.uy;
      Number<3> of_e = by_cross ? exact::cross(ux, uy, x, y) : exact::dot(ux, uy, x, y);
      of_e.sign *= e.sign;
      return from_exact<Real>(of_e);
    };
    return {from_exact<Real>(straight(a_by_x, b_by_x)), along(from_), along(to_)};
  }

  /// What n = e + l f is seen by, whatever l is.
  template <class Real>
  struct Terms {
    SeenDirection<Real> e, f;
    Sizes<Real> sizes;
    Ends<Real> ends[4];
    bool is_known[4] = {};

    const Ends<Real>& of_ends(const SeenEllipses& seen, bool a_by_x, bool b_by_x) noexcept {
      const int which = (a_by_x ? 1 : 0) + (b_by_x ? 2 : 0);
      if (!is_known[which]) ends[which] = seen.ends<Real>(a_by_x, b_by_x);
      is_known[which] = true;
      return ends[which];
    }
  };
  template <class Real>
  Terms<Real> terms() const noexcept {
    return {seen<Real>(from_), seen<Real>(to_), sizes<Real>(), {}, {}};
  }

  /// The greatest T(n), from one n; how far off the best l is.
  struct Evaluated {
    Rough time, step;
    bool is_near;      ///< the step is so short that what it gains has a bound
    bool more_digits;  ///< are needed

    bool is_below_all_doubles() const noexcept {
      return arithmetic::scale(std::fabs(rounded(time.value)) + time.error, time.exponent - least_exponent) < 1;
    }
  };
  /// A step of Newton's method in s is slope / bend, bend = k (n.v)^3 / v.v with k = sum of area^2 / h^3. It gains
  /// about slope^2 / (2 bend v.v).
  ///
  /// Proved: the greatest T lies within 2d (bound.hpp), where h changes by a share x = d / (4 room) at most. So bend is
  /// between bend / (1 + x)^3 and bend / (1 - x)^3 there, and what is gained between (1 - x)^3 and (1 + x)^3 times the
  /// above. As x <= 1/4, that is within 4 x of it.
  template <class Real>
  VESICA_COLD Evaluated evaluate(const Real& l, Terms<Real>& terms) const noexcept {
    const SeenDirection<Real> n = between(terms.e, terms.f, l);
    const SeenDirection<Wide> seen_n = between(wide_from_, wide_to_, wide(rough(l)));
    const bool a_by_x = is_by_x(seen_n, 0), b_by_x = is_by_x(seen_n, 1);
    const Sizes<Real>& s = terms.sizes;
    const Ends<Real>& ends = terms.of_ends(*this, a_by_x, b_by_x);
    const Reach<Real> a = reach(s, n, 0, a_by_x), b = reach(s, n, 1, b_by_x);
    const Real of_a = a.h * a.sum, of_b = b.h * b.sum;
    const Real beside = ends.straight * of_a * of_b - a.beside * of_b - b.beside * of_a;
    const Rough slope = rough(beside) / rough(of_a * of_b), against = rough(n.against);
    const Rough height_a = rough(a.h), height_b = rough(b.h);
    const Rough k = square(rough(s.area[0]) / height_a) / height_a + square(rough(s.area[1]) / height_b) / height_b;
    Wide falls[2];
    const Slope at = fall(seen_n.against, wide(height_a), wide(height_b), falls);
    const Wide steepest(std::fabs(rounded(slope.value)) + slope.error, slope.exponent), change = steepest / at.fall;
    const Real ahead = ends.along_e + l * ends.along_f;
    const Real gap = ahead * a.sum * b.sum - a.rest * b.sum - b.rest * a.sum;
    const Rough time = rough(gap) / rough(a.sum * b.sum * n.against);
    const Rough unit = k * against;
    const Wide rest = Wide(0.51, 0) * steepest * change / vv_ * (change / at.room);
    const Rough gain =
        square(slope) / crossings::times(2, unit * square(against)) + Rough({}, rest.value, rest.exponent);
    const bool is_known = slope.sign_is_known();
    const Rough step = is_known ? slope / (unit * rough(width(terms.e, terms.f))) : Rough();
    return {time + gain, step, change < at.room,
            !is_known || Wide(gain.error, gain.exponent) < Wide(time.error, time.exponent)};
  }
  Evaluated evaluate(const Digits& l) const noexcept {
    Terms<Digits> as_many = terms<Digits>();
    return evaluate(l, as_many);
  }

  const ExactPair& pair_;
  const ExactBody* body_[2];
  const Number<6>* squared_[2];
  Number<2> dot_, cross_, uu_[2], c_[2], k_[2];
  Number<3> beside_x_[2], beside_y_[2];  ///< hx k, hy c
  Sizes<Wide> sizes_;
  Wide vv_, gap_;
  SectorEdge edge_[4], from_{}, to_{};
  int edges_ = 0, limbs_ = 0;  ///< limbs: of the digits, 0 for Rough
  SeenDirection<Wide> wide_from_, wide_to_;
  int sign_x_[2], sign_y_[2];
  mutable Wide straight_[4];
  mutable bool straight_known_[4];
};

}  // namespace vesica::detail::cast
