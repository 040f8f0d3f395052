// SPDX-License-Identifier: Apache-2.0
/// The first contact of two ellipses whose exponents are unlike, by trial of doubles, most of them in a microsecond:
/// from leading digits (ellipse_contact.hpp). Where these do not tell, all digits do.
#pragma once

#include <vesica/cast/ellipse_contact.hpp>
#include <vesica/cast/trial_search.hpp>

namespace vesica::detail::cast {

/// Trials of a pair of ellipses whose line enters M after the start and does not graze it, at times above 0.
class EllipseTrials {
 public:
  explicit EllipseTrials(const ExactPair& pair) noexcept
      : pair_(pair), contact_(pair), witness_(pair.rough_witness()) {}

  /// As of TrialSearch. A trial is not known where the place then is beyond exact numbers.
  VESICA_COLD double floor(double start, double guess) noexcept {
    const auto ask = [this](double t) { return at(t); };
    Trial at_start = contact_.at(0);
    if (!at_start.known) at_start = known_.try_at(pair_, 0);
    return TrialSearch(ask, at_start, least_held()).floor(start, between(witness_), guess);
  }

  /// What ExactPair::contact_before() answers, by trials and what they told before.
  std::int32_t contact_before(double t) noexcept {
    if (!(t > 0)) return 0;
    const int left = to_witness(t);
    if (left <= 0) return left < 0 ? 1 : pair_.contact_before(t);
    if (!pair_.holds_place(t)) return error_range;
    if (t <= latest_before_ || t >= first_after_) return t < first_after_ ? 0 : 1;
    return at(t).after ? 1 : 0;  // known, as the place is held
  }

 private:
  VESICA_COLD Trial at(double t) noexcept {
    const Trial trial = find(t);
    if (trial.known) (trial.after ? first_after_ : latest_before_) = t;
    return trial;
  }
  /// The least power of two at which the place is within exact numbers, 2^1023 where it is at none. The less the time,
  /// the more digits has the place, but where terms cancel.
  double least_held() const noexcept {
    const auto is_held = [this](int exponent) { return pair_.holds_place(arithmetic::scale_far(1, exponent)); };
    int no = -1075, yes = is_held(no + 1) ? no + 1 : 1023;
    while (yes - no > 1) {
      const int middle = (no + yes) / 2;
      (is_held(middle) ? yes : no) = middle;
    }
    return arithmetic::scale_far(1, yes);
  }
  /// Not known where the place is beyond exact numbers.
  Trial find(double t) noexcept {
    const int left = to_witness(t);
    if (left < 0) return {true, true};
    Trial trial = known_.has_discriminant ? contact_.at(t, known_) : Trial{};
    if (!trial.known) trial = contact_.at(t);
    if (!trial.known) trial = known_.try_at(pair_, t);
    if (trial.known && (trial.after || left > 0)) return trial;
    const std::int32_t before = pair_.contact_before(t);
    return {before >= 0, before != 0};
  }
  /// The sign of t_w - t, 0 where a few digits do not tell it. Without contact it is before the witness or after.
  int to_witness(double t) const noexcept {
    const Rough left = witness_ - Rough(exact::from_double(t));
    return left.sign_is_known() ? left.sign() : 0;
  }

  const ExactPair& pair_;
  LeadingContact contact_;
  KnownCubic known_;
  Rough witness_;
  double latest_before_ = 0, first_after_ = std::numeric_limits<double>::infinity();
};

}  // namespace vesica::detail::cast
