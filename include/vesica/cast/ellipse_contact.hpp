// SPDX-License-Identifier: Apache-2.0
/// The contact of two ellipses that move, from the leading digits of numbers that do not depend on the time: the cubic
/// of exact/contact_cubic.hpp.
#pragma once

#include <vesica/cast/leading_root.hpp>
#include <vesica/cast/wide.hpp>

namespace vesica::detail::cast {

/// What a trial tells: whether there is contact of insides before the time, and where known the discriminant of the
/// cubic, which is positive before contact, and falls through 0 at it.
struct Trial {
  bool known = false, after = false, has_value = false;
  arithmetic::Scaled value{0, 0};
};

using exact::times;

/// An ellipse as seen along v, and the offset of centres by its axis.
template <int limbs>
struct EllipseDigits {
  Leading<limbs> squared, m, area, uu, hx, hy, c, k, along_d, across_d;

  EllipseDigits(const exact::Box& e, const ExactReach& reach, const Passage& p) noexcept
      : squared(reach.squared),
        m(reach.m),
        uu(exact::dot(e.ux, e.uy, e.ux, e.uy)),
        hx(e.hx),
        hy(e.hy),
        c(exact::dot(e.ux, e.uy, p.vx, p.vy)),
        k(exact::cross(e.ux, e.uy, p.vx, p.vy)),
        along_d(exact::dot(e.ux, e.uy, p.dx, p.dy)),
        across_d(exact::cross(e.ux, e.uy, p.dx, p.dy)) {
    area = hx * hy * uu;
  }
};

/// A pair of ellipses in so many leading digits.
template <int limbs>
struct PairDigits {
  EllipseDigits<limbs> ellipse[2];
  Leading<limbs> axes_along, axes_across, w, vv;

  explicit PairDigits(const ExactPair& pair) noexcept
      : PairDigits(pair, {pair.dx_, pair.dy_, pair.vx_, pair.vy_}, pair.a_.box, pair.b_.box) {}

 private:
  PairDigits(const ExactPair& pair, const Passage& p, const exact::Box& a, const exact::Box& b) noexcept
      : ellipse{{a, pair.reach_a_, p}, {b, pair.reach_b_, p}},
        axes_along(exact::dot(a.ux, a.uy, b.ux, b.uy)),
        axes_across(exact::cross(a.ux, a.uy, b.ux, b.uy)),
        w(pair.w_),
        vv(pair.vv_) {}
};

/// An ellipse, and another's centre that passes: d + t v in its frame, each coordinate times the other half length.
struct LeadingFrame {
  using Few = exact::Leading<exact::few_limbs>;
  Few at_x, at_y, by_x, by_y, squared_area;

  explicit LeadingFrame(const EllipseDigits<exact::few_limbs>& e) noexcept
      : at_x(e.hy * e.along_d),
        at_y(e.hx * e.across_d),
        by_x(e.hy * e.c),
        by_y(e.hx * e.k),
        squared_area(square(e.area)) {}

  /// al or be of the cubic.
  Few offset(const Few& t) const noexcept { return square(at_x + t * by_x) + square(at_y + t * by_y); }
  /// The same as a polynomial: its value at 0, half of its derivative there, and half of the second one.
  Few start() const noexcept { return square(at_x) + square(at_y); }
  Few half_slope() const noexcept { return at_x * by_x + at_y * by_y; }
  Few bend() const noexcept { return square(by_x) + square(by_y); }
};

/// At most so great.
inline Wide most(const LeadingFrame::Few& x) noexcept {
  const Wide size = arithmetic::abs(wide(x));
  return x.error == LeadingFrame::Few::nothing ? size : size + Wide(1, static_cast<int>(x.error));
}

/// The cubic at a time.
class LeadingContact {
  using Few = LeadingFrame::Few;

 public:
  explicit LeadingContact(const PairDigits<exact::few_limbs>& pair) noexcept
      : first_(pair.ellipse[0]),
        second_(pair.ellipse[1]),
        mixed_(mixed(pair)),
        product_(first_.squared_area * second_.squared_area) {}

  /// As exact::overlap decides it: contact if both inner coefficients are not negative or the discriminant is not
  /// positive; of insides unless it is 0.
  Trial at(double time) const noexcept {
    const Few t(exact::from_double(time)), &d1 = first_.squared_area, &d2 = second_.squared_area;
    const Few c1 = d1 + mixed_ - first_.offset(t), c2 = d2 + mixed_ - second_.offset(t);
    Trial trial;
    if (!c1.sign_is_certain() || !c2.sign_is_certain()) return trial;
    if (c1.sign >= 0 && c2.sign >= 0) return {true, true};
    const Few discriminant = exact::detail::discriminant(d1, c1, c2, d2, product_);
    if (!discriminant.sign_is_certain() || discriminant.sign == 0) return trial;
    return told(discriminant);
  }

  /// The same from the cubic's exact coefficients; not known where the place then is beyond exact numbers.
  VESICA_COLD static Trial exactly_at(const ExactPair& pair, double time) noexcept {
    Trial trial;
    pair.with_placed(time, [&trial](const ExactBody& a, const ExactBody& b, const Window& window) {
      const exact::ContactCubic p = exact::contact_cubic(a.ellipse(), b.ellipse());
      trial = {true, true};
      if (p.c1.sign >= 0 && p.c2.sign >= 0) return;
      trial = told(exact::leading_discriminant(p));
      trial.value.exponent -= 16 * 64 * window.limbs();  // it is of degree 16 in offsets and axes
    });
    return trial;
  }

  /// F(0) / |F'(0)|, F being the discriminant. It is the time, and certain, where contact begins so soon that F falls
  /// straight until then: where shapes all but touch at the start, and no direction tells the time, as its digits
  /// cancel. There is no contact at 0; so F(0) > 0, and contact begins where F is 0 first.
  ///
  /// Up to limit = 2 F(0) / |F'(0)| all of F but its straight part is at most rest t |F'(0)|. Thus F > 0 while t is
  /// less than F(0) / |F'(0)| over 1 + rest, and F < 0 where it is more than that over 1 - rest.
  WideTime soon(const ExactPair& pair) const noexcept {
    const Few &d1 = first_.squared_area, &d2 = second_.squared_area;
    const Few c1 = d1 + mixed_ - first_.start(), c2 = d2 + mixed_ - second_.start();
    // Half the derivatives of F by c1 and c2.
    const Few by_c1 = times(9, product_ * c2) + c1 * square(c2) - times(6, d2 * square(c1));
    const Few by_c2 = times(9, product_ * c1) + c2 * square(c1) - times(6, d1 * square(c2));
    const Rough fall = rough(times(4, by_c1 * first_.half_slope() + by_c2 * second_.half_slope()));
    Rough value = rough(exact::detail::discriminant(d1, c1, c2, d2, product_));
    if (!fall.is_precise() || fall.sign() <= 0) return {};
    const double size = std::fabs(rounded(value.value)) + value.error;
    const Wide steep(fall.scaled()), limit = Wide(2.02 * size, value.exponent) / steep;
    const Wide rest = bent(most(c1), most(c2), limit) / (limit * steep);
    const bool is_straight = rest < Wide(0x1p-62, 0);
    if (is_straight && !value.is_precise()) value = exact_start(pair);
    const Rough time = value / fall;
    if (!is_straight) return {time, false};
    const Wide error = Wide(1.1, 0) * rest * Wide(time.scaled());
    return {time + Rough({}, std::fabs(error.value), error.exponent), value.sign() > 0};
  }

 private:
  VESICA_CALLED static arithmetic::Scaled scaled(exact::detail::Span x, int sign) noexcept {
    const auto digit = [&x](int i) { return static_cast<double>(x.limb[x.size - i]); };
    return {sign * (digit(1) * 0x1p-64 + digit(2) * 0x1p-128), 64 * (x.low + x.size)};
  }
  /// What a discriminant says whose sign is certain.
  static Trial told(const Few& discriminant) noexcept {
    const int sign = discriminant.sign;
    return {true, sign < 0, sign != 0, scaled(discriminant.span(), sign)};
  }
  static Few mixed(const PairDigits<exact::few_limbs>& pair) noexcept {
    const auto& [e, f] = pair.ellipse;
    const Few a0 = square(e.hx), a1 = square(e.hy), b0 = square(f.hx), b1 = square(f.hy);
    return square(pair.axes_along) * (a0 * b1 + a1 * b0) + square(pair.axes_across) * (a0 * b0 + a1 * b1);
  }

  /// A bound on all of F but its straight part, up to a time. F is of degree 4 in c1 and c2, and these are of degree 2
  /// in t: c - 2 half_slope t - bend t^2. With all signs positive no coefficient is less in magnitude, and in Taylor's
  /// formula the second derivatives are greatest at the far end.
  Wide bent(const Wide& c1, const Wide& c2, const Wide& limit) const noexcept {
    const auto n = [](double x) { return Wide(x, 0); };
    const Wide d1 = wide(first_.squared_area), d2 = wide(second_.squared_area), product = wide(product_);
    const Wide bend1 = limit * limit * wide(first_.bend()), bend2 = limit * limit * wide(second_.bend());
    const Wide x1 = n(2) * limit * most(first_.half_slope()) + bend1,
               x2 = n(2) * limit * most(second_.half_slope()) + bend2;
    const Wide m1 = c1 + x1, m2 = c2 + x2;
    const Wide by_c1 = n(9) * product * c2 + c1 * c2 * c2 + n(6) * d2 * c1 * c1;
    const Wide by_c2 = n(9) * product * c1 + c2 * c1 * c1 + n(6) * d1 * c2 * c2;
    const Wide twice = (m2 * m2 + n(12) * d2 * m1) * x1 * x1 + (m1 * m1 + n(12) * d1 * m2) * x2 * x2 +
                       n(2) * (n(9) * product + n(2) * m1 * m2) * x1 * x2;
    return n(2.03) * (by_c1 * bend1 + by_c2 * bend2) + n(1.03) * twice;
  }

  /// F(0), of which all leading digits may cancel.
  VESICA_COLD static Rough exact_start(const ExactPair& pair) noexcept {
    return rough(exact::leading_discriminant(exact::contact_cubic(pair.a_.ellipse(), pair.b_.ellipse())));
  }

  LeadingFrame first_, second_;
  Few mixed_, product_;  // mu, and d1 d2
};

}  // namespace vesica::detail::cast
