// SPDX-License-Identifier: Apache-2.0
/// The contact of two ellipses that move, at a time: by the cubic of exact/contact_cubic.hpp. Its coefficients are
/// polynomials in the time, of which leading digits mostly tell.
#pragma once

#include <vesica/cast/trial.hpp>
#include <vesica/cast/wide.hpp>

namespace vesica::detail::cast {

/// What a discriminant tells whose sign is certain. After contact it may be positive again: its negative is the value.
VESICA_CALLED inline Trial trial_of(const Leading<exact::few_limbs>& discriminant, bool after) noexcept {
  constexpr int limbs = exact::few_limbs;
  const auto digit = [&discriminant](int i) { return static_cast<double>(discriminant.limb[limbs - i]); };
  const double size = digit(1) * 0x1p-64 + digit(2) * 0x1p-128;
  return {true, after, discriminant.sign != 0, {after ? -size : size, 64 * (discriminant.low + limbs)}};
}

using exact::times;

/// An ellipse, and another's centre that passes: d + t v in its frame, each coordinate times the other half length.
class LeadingFrame {
  using Few = Leading<exact::few_limbs>;

 public:
  LeadingFrame(const exact::Box& e, const Passage& p) noexcept
      : hx(e.hx),
        hy(e.hy),
        squared_area(square(hx * hy * Few(exact::dot(e.ux, e.uy, e.ux, e.uy)))),
        at_x_(hy * Few(exact::dot(e.ux, e.uy, p.dx, p.dy))),
        at_y_(hx * Few(exact::cross(e.ux, e.uy, p.dx, p.dy))),
        by_x_(hy * Few(exact::dot(e.ux, e.uy, p.vx, p.vy))),
        by_y_(hx * Few(exact::cross(e.ux, e.uy, p.vx, p.vy))),
        half_slope_(at_x_ * by_x_ + at_y_ * by_y_),
        bend_(square(by_x_) + square(by_y_)) {}

  /// al or be of the cubic.
  Few offset(const Few& t) const noexcept { return square(at_x_ + t * by_x_) + square(at_y_ + t * by_y_); }
  /// How much more that is at t than at t0.
  Few offset_since(const Few& t0, const Few& t) const noexcept {
    return (t - t0) * (times(2, half_slope_) + bend_ * (t0 + t));
  }

  Few hx, hy, squared_area;

 private:
  Few at_x_, at_y_, by_x_, by_y_, half_slope_, bend_;
};

/// The cubic at a time for which all digits of its coefficients were formed.
struct KnownCubic {
  using Few = Leading<exact::few_limbs>;

  bool has_discriminant = false;  ///< else nothing is known
  Few time, c1, c2, discriminant;

  /// What a trial at a time tells; it is known from then on, unless the signs of coefficients told it. Not known where
  /// the place then is beyond exact numbers.
  VESICA_COLD Trial try_at(const ExactPair& pair, double t) noexcept {
    Trial trial;
    pair.with_placed(t, [&](const ExactBody& a, const ExactBody& b, const Window& window) {
      const exact::ContactCubic p = exact::contact_cubic(a.ellipse(), b.ellipse());
      trial = {true, true};
      if (p.c1.sign >= 0 && p.c2.sign >= 0) return;
      // Coefficients are of degree 4 in offsets and axes, and their discriminant is of degree 4 in them.
      const int limbs = 4 * window.limbs();
      *this = {true, Few(exact::from_double(t)), lowered(Few(p.c1), limbs), lowered(Few(p.c2), limbs),
               lowered(exact::leading_discriminant(p), 4 * limbs)};
      trial = trial_of(discriminant, discriminant.sign < 0);
    });
    return trial;
  }

 private:
  /// Over so many powers of 2^64.
  static Few lowered(Few x, int limbs) noexcept {
    x.low -= limbs;
    if (x.error != Few::nothing) x.error -= std::int64_t{64} * limbs;
    return x;
  }
};

/// The cubic at a time, from leading digits.
class LeadingContact {
  using Few = Leading<exact::few_limbs>;

 public:
  explicit LeadingContact(const ExactPair& pair) noexcept
      : LeadingContact(pair.a_.box, pair.b_.box, {pair.dx_, pair.dy_, pair.vx_, pair.vy_}) {}

  Trial at(double time) const noexcept {
    const Few t(exact::from_double(time)), &d1 = first_.squared_area, &d2 = second_.squared_area;
    const Few c1 = d1 + mixed_ - first_.offset(t), c2 = d2 + mixed_ - second_.offset(t);
    return told(c1, c2, [&] { return exact::detail::discriminant(d1, c1, c2, d2, product_); });
  }

  /// The same by how it differs from a cubic that is known. Where shapes nearly touch at either time, nearly all digits
  /// of both discriminants cancel, but fewer of their difference.
  VESICA_COLD Trial at(double time, const KnownCubic& known) const noexcept {
    const Few t(exact::from_double(time)), &d1 = first_.squared_area, &d2 = second_.squared_area;
    const Few x = -first_.offset_since(known.time, t), y = -second_.offset_since(known.time, t);
    const Few c1 = known.c1 + x, c2 = known.c2 + y;
    return told(c1, c2, [&] {
      // Of exact::detail::discriminant()'s lower and upper, and of c1 c2.
      const Few lower = square(known.c1) - times(4, d1 * known.c2), upper = square(c2) - times(4, d2 * c1);
      const Few lower_change = x * (known.c1 + c1) - times(4, d1 * y),
                upper_change = y * (known.c2 + c2) - times(4, d2 * x), change = x * known.c2 + y * c1;
      return known.discriminant + lower * upper_change + upper * lower_change + product_ * times(2, change);
    });
  }

 private:
  LeadingContact(const exact::Box& a, const exact::Box& b, const Passage& p) noexcept
      : first_(a, p),
        second_(b, p),
        mixed_(
            mixed(first_, second_, Few(exact::dot(a.ux, a.uy, b.ux, b.uy)), Few(exact::cross(a.ux, a.uy, b.ux, b.uy)))),
        product_(first_.squared_area * second_.squared_area) {}

  /// As exact::overlap decides it: contact if both inner coefficients are not negative or the discriminant is not
  /// positive; of insides unless it is 0.
  template <class Discriminant>
  static Trial told(const Few& c1, const Few& c2, const Discriminant& discriminant) noexcept {
    if (!c1.sign_is_certain() || !c2.sign_is_certain()) return {};
    const bool after = c1.sign >= 0 && c2.sign >= 0;
    const Few value = discriminant();
    if (value.sign_is_certain() && value.sign != 0) return trial_of(value, after || value.sign < 0);
    return {after, after};
  }
  static Few mixed(const LeadingFrame& e, const LeadingFrame& f, const Few& dot, const Few& cross) noexcept {
    const Few a0 = square(e.hx), a1 = square(e.hy), b0 = square(f.hx), b1 = square(f.hy);
    return square(dot) * (a0 * b1 + a1 * b0) + square(cross) * (a0 * b0 + a1 * b1);
  }

  LeadingFrame first_, second_;
  Few mixed_, product_;  // mu, and d1 d2
};

}  // namespace vesica::detail::cast
