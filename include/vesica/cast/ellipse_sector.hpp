// SPDX-License-Identifier: Apache-2.0
/// Two ellipses seen along a line n that turns: the axes of both, what is across them, and perp(v) cut the directions
/// into sectors. In the one from e to f, n = e + l f with l > 0: there u.n, u x n and n.v are sums of terms of one
/// sign, so that nothing cancels in them. And half of an ellipse along an axis is a vector without a root. With
/// p = hx |u.n| and q = hy |u x n|,
///
///     h = sqrt(p^2 + q^2) = p + q^2 / (h + p) = q + p^2 / (h + q)
///
/// so the terms that may cancel in n.D - h_a - h_b where exponents are unlike are those of n.D', where D' leads from
/// the end of an axis to that of another, and is exact.
#pragma once

#include <vesica/cast/ellipse_contact.hpp>

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

/// n = e + l f, signs left out.
template <class Real>
SeenDirection<Real> between(const SeenDirection<Real>& e, const SeenDirection<Real>& f, const Real& l) noexcept {
  SeenDirection<Real> n;
  for (int i = 0; i < 2; ++i) {
    n.along[i] = magnitude(e.along[i] + l * f.along[i]);
    n.across[i] = magnitude(e.across[i] + l * f.across[i]);
  }
  n.against = e.against + l * f.against;
  return n;
}

/// Two ellipses seen from a sector; and the edges of all sectors, in order of s (bound.hpp).
class EllipseSector {
 public:
  /// Of ellipses; area: hx hy u.u.
  template <class Real>
  struct Sizes {
    Real hx[2], hy[2], area[2], by_k[2], by_c[2];
  };
  /// How far an ellipse reaches along n, h; beyond the end of its axis hx u, or of hy perp(u), by rest / sum. How far
  /// beside that its point farthest along n lies: beside / (h sum).
  template <class Real>
  struct Reach {
    Real p, q, h, sum, rest, beside;
  };
  /// Of the ends of an axis of either ellipse: v x D', e.D' and f.D'.
  template <class Real>
  struct Ends {
    Real straight, along_e, along_f;
  };

  explicit EllipseSector(const ExactPair& pair) noexcept : pair_(pair), body_{&pair.a_, &pair.b_} {
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
    sizes_ = sizes<Wide>(0);
  }

  int edges() const noexcept { return edges_; }
  const SectorEdge& edge(int i) const noexcept { return edge_[i]; }

  /// From e to f; both alike for the direction e alone.
  void set(const SectorEdge& e, const SectorEdge& f) noexcept {
    from_edge_ = e, to_edge_ = f;
    from_ = seen<Wide>(e, 0), to_ = seen<Wide>(f, 0);
    for (int i = 0; i < 2; ++i) {
      const auto sign = [](const Wide& x, const Wide& y) { return x.sign() != 0 ? x.sign() : y.sign(); };
      sign_x_[i] = sign(from_.along[i], to_.along[i]);
      sign_y_[i] = sign(from_.across[i], to_.across[i]);
    }
  }
  bool ends_across_v() const noexcept { return to_edge_.ellipse == SectorEdge::across_v; }
  const SeenDirection<Wide>& from() const noexcept { return from_; }
  const SeenDirection<Wide>& to() const noexcept { return to_; }
  template <class Real>
  SeenDirection<Real> from(int limbs) const noexcept {
    return seen<Real>(from_edge_, limbs);
  }
  template <class Real>
  SeenDirection<Real> to(int limbs) const noexcept {
    return seen<Real>(to_edge_, limbs);
  }
  /// |e x f|
  template <class Real>
  Real width(const SeenDirection<Real>& e, const SeenDirection<Real>& f) const noexcept {
    const bool from_ellipse = from_edge_.ellipse != SectorEdge::across_v;
    const SectorEdge& edge = from_ellipse ? from_edge_ : to_edge_;
    const SeenDirection<Real>& other = from_ellipse ? f : e;
    return magnitude(edge.turned ? other.along[edge.ellipse] : other.across[edge.ellipse]);
  }

  const Sizes<Wide>& sizes() const noexcept { return sizes_; }
  template <class Real>
  Sizes<Real> sizes(int limbs) const noexcept {
    Sizes<Real> s;
    for (int i = 0; i < 2; ++i) {
      const exact::Box& e = body_[i]->box;
      s.hx[i] = from_exact<Real>(e.hx, limbs);
      s.hy[i] = from_exact<Real>(e.hy, limbs);
      s.area[i] = s.hx[i] * s.hy[i] * from_exact<Real>(uu_[i], limbs);
      s.by_k[i] = from_exact<Real>(beside_x_[i], limbs);
      s.by_c[i] = from_exact<Real>(beside_y_[i], limbs);
    }
    return s;
  }
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

  template <class Real>
  Ends<Real> ends(bool a_by_x, bool b_by_x, int limbs) const noexcept {
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
      return from_exact<Real>(of_e, limbs);
    };
    return {from_exact<Real>(straight(a_by_x, b_by_x), limbs), along(from_edge_), along(to_edge_)};
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

 private:
  /// Numbers of some type from exact ones; of Digits so many limbs.
  template <class Real, int Degree>
  static Real from_exact(const Number<Degree>& x, int limbs) noexcept {
    if constexpr (std::is_same_v<Real, Wide>) {
      return Wide(exact::rounded(x));
    } else if constexpr (std::is_same_v<Real, Digits>) {
      return Digits(x, limbs);
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

  template <class Real>
  VESICA_COLD SeenDirection<Real> seen(const SectorEdge& e, int limbs) const noexcept {
    SeenDirection<Real> out;
    const auto set = [&out, &e](int i, const Real& along, const Real& across) {
      out.along[i] = turned(along, e.sign);
      out.across[i] = turned(across, e.sign);
    };
    if (e.ellipse == SectorEdge::across_v) {
      for (int i = 0; i < 2; ++i) set(i, -from_exact<Real>(k_[i], limbs), from_exact<Real>(c_[i], limbs));
      return out;
    }
    const int own = e.ellipse, other = 1 - own;
    const Real uu = from_exact<Real>(uu_[own], limbs), dot = from_exact<Real>(dot_, limbs),
               cross = turned(from_exact<Real>(cross_, limbs), own == 0 ? 1 : -1);
    e.turned ? set(own, {}, uu) : set(own, uu, {});
    e.turned ? set(other, cross, dot) : set(other, dot, -cross);
    out.against = magnitude(from_exact<Real>(e.turned ? k_[own] : c_[own], limbs));
    return out;
  }

  const ExactPair& pair_;
  const ExactBody* body_[2];
  Number<2> dot_, cross_, uu_[2], c_[2], k_[2];
  Number<3> beside_x_[2], beside_y_[2];  ///< hx k, hy c
  Sizes<Wide> sizes_;
  SectorEdge edge_[4], from_edge_{}, to_edge_{};
  int edges_ = 0;
  SeenDirection<Wide> from_, to_;
  int sign_x_[2], sign_y_[2];
};

}  // namespace vesica::detail::cast
