// SPDX-License-Identifier: Apache-2.0
/// The greatest double with no contact before it, from exact numbers.
///
/// It is defined by a search: doubles are tried, from an estimate on, and where a place that is tried is beyond exact
/// numbers, the search ends with an error. At unlike exponents the time is mostly found otherwise (wide.hpp,
/// ellipse_trials.hpp); then only the places are looked at.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/ellipse_trials.hpp>

namespace vesica::detail::cast {

/// Whether no double that search_up() tries between a start and a time is beyond ExactPair::contact_at(). It goes at
/// most as far beyond the time as the start is from it; and after the witness no place is asked for.
inline bool have_room_for_trials(const PlaceBits& places, double start, double t, double witness) noexcept {
  const std::uint64_t bottom = arithmetic::rank(0.0) + 1, top = arithmetic::rank(std::numeric_limits<double>::max());
  const std::uint64_t from = arithmetic::rank(start), to = t > 0 ? arithmetic::rank(t) : bottom,
                      way = (from < to ? to - from : from - to) + 3;
  const std::uint64_t least = from < to ? from : to - bottom > way ? to - way : bottom;
  const std::uint64_t most = from > to ? from : top - to > way ? to + way : top;
  const double last = lane::min(arithmetic::at_rank<double>(most), witness);
  return places.have_room(arithmetic::at_rank<double>(least), lane::max(last, t));
}

/// The smallest double from which on reaches() holds. A negative answer of it, an error, ends the search.
template <class Reaches>
std::int32_t search(double start, const Reaches& reaches, double& out) noexcept {
  std::int32_t error = 0;
  const auto is_after = [&](double t) {
    if (error != 0) return true;
    const std::int32_t reached = reaches(t);
    if (reached < 0) error = reached;
    return reached != 0;
  };
  const bool found = arithmetic::search_up(start, is_after, out);
  return error == 0 && !found ? static_cast<std::int32_t>(error_range) : error;
}

/// The search for a time that is known, or infinite: an error if it would end with one.
inline std::int32_t repeat_search(const ExactPair& pair, double start, double t) noexcept {
  if (!(t <= std::numeric_limits<double>::max())) return error_range;
  const Between witness = between(pair.rough_witness());
  const PlaceBits places = pair.place_bits();
  if (pair.line_grazes() || have_room_for_trials(places, start, t, witness.most)) return 0;
  // After the witness no place is asked for, and contact was before: t <= t0 <= witness < x. So where the place is held
  // it need not be asked whether x is after the witness.
  const auto reaches = [&](double x) -> std::int32_t {
    if (!(x > 0)) return 0;
    if (x > witness.most || places.have_room(x) || pair.holds_place(x)) return x > t ? 1 : 0;
    return pair.witness_after(x) < 0 ? 1 : static_cast<std::int32_t>(error_range);
  };
  double out;
  return search(start, reaches, out);
}

/// The time, as far as it is known without trials.
inline WideTime known_time_of_ellipses(const ExactPair& pair) noexcept {
  const WideTime of_circles = wide_time_of_circles(pair);
  if (of_circles.certain) return of_circles;
  const ByExtent by_extent(pair);
  return by_extent.bits > 64 ? wide_time_of_thin(pair, by_extent) : WideTime{};
}
inline WideTime known_time(const ExactPair& pair) noexcept {
  if (pair.line_grazes()) return wide_grazing_time(pair);
  return pair.of_ellipses() ? known_time_of_ellipses(pair) : wide_time(pair);
}

/// Contact at one time; where the shapes touch is not told.
inline std::int32_t exact_contact_at(const ExactPair& pair, double t) noexcept {
  const Contact contact = pair.contact_at(t);
  return contact == Contact::beyond ? static_cast<std::int32_t>(error_range) : contact != Contact::none ? 1 : 0;
}

/// Sign of the time less the end, 0 where that is not known.
inline int time_after(double end, const WideTime& found) noexcept {
  if (!found.tells()) return 0;
  const Rough left = found.time - Rough(exact::from_double(end));
  // The errors of two times of boxes are within 2^-90 of either.
  const double error = left.error + arithmetic::scale(0x1p-88, found.time.exponent - left.exponent);
  return std::fabs(rounded(left.value)) > error ? left.sign() : 0;
}
/// The same by the floor of the time, negative where that is not known.
inline int time_after(double end, double floor) noexcept {
  return floor < 0 || floor == end ? 0 : floor < end ? -1 : 1;
}

/// Whether there is contact at the end, where the witness comes after it, or an error.
inline std::int32_t contact_at_end(const ExactPair& pair, double end, int time_after_end) noexcept {
  if (time_after_end == 0) return exact_contact_at(pair, end);
  return pair.holds_place(end) ? (time_after_end < 0 ? 1 : 0) : static_cast<std::int32_t>(error_range);
}

/// The floor of a time by the search that defines it, with what trials told, if there were any.
VESICA_COLD inline std::int32_t searched_floor(const ExactPair& pair, EllipseTrials* trials, double start,
                                               double& out) noexcept {
  const auto contact_before = [&pair, trials](double t) {
    return trials != nullptr ? trials->contact_before(t) : pair.contact_before(t);
  };
  double after;
  const std::int32_t error = search(start, contact_before, after);
  if (error == 0) out = arithmetic::at_rank<double>(arithmetic::rank(after) - 1);
  return error;
}

/// Where the search begins: beside an estimate, where there is one.
struct Start {
  bool is_estimate;
  double time;

  explicit Start(double estimate) noexcept
      : is_estimate(estimate > 0 && estimate < std::numeric_limits<double>::max()),
        time(is_estimate ? arithmetic::at_rank<double>(arithmetic::rank(estimate) + 1) : 1.0) {}
};

/// exact_floor() of two ellipses, of whose time `found` is all that is known. The floor tells of the end too.
VESICA_COLD inline std::int32_t tried_floor(const ExactPair& pair, double end, bool late, const Start& start,
                                            const WideTime& found, double& out) noexcept {
  EllipseTrials trials(pair);
  const double guess = found.time.sign() > 0 ? between(found.time).least : 0;
  out = trials.floor(start.is_estimate ? start.time : 0, guess);
  const std::int32_t at_end = late ? contact_at_end(pair, end, time_after(end, out)) : 1;
  if (at_end <= 0) return at_end;
  const std::int32_t error =
      out < 0 ? searched_floor(pair, &trials, start.time, out) : repeat_search(pair, start.time, out);
  return error != 0 ? error : 1;
}

/// exact_floor(), but a time that is the largest double is an error here: the search looks for the first double with
/// contact before it, and there is none.
VESICA_COLD inline std::int32_t floor_below_largest(const ExactPair& pair, double end, bool late, double estimate,
                                                    const WideTime& bounds, double& out) noexcept {
  const Start start(estimate);
  const WideTime found = bounds.tells() ? bounds : known_time(pair);
  if (!found.tells() && pair.of_ellipses() && !pair.line_grazes()) {
    return tried_floor(pair, end, late, start, found, out);
  }
  const std::int32_t at_end = late ? contact_at_end(pair, end, time_after(end, found)) : 1;
  if (at_end <= 0) return at_end;
  std::int32_t error;
  if (found.tells()) {
    error = floor_of_time(pair, found.time, out);
    if (error == 0) error = repeat_search(pair, start.time, out);
  } else {
    error = searched_floor(pair, nullptr, start.time, out);
  }
  return error != 0 ? error : 1;
}

/// For a line that enters M after the start, and a witness that comes after the end if that is `late`. `bounds`: what
/// is known of the time. Returns 1, or 0 where there is no contact up to the end, or error_range where the time or a
/// place is beyond the numbers.
VESICA_COLD inline std::int32_t exact_floor(const ExactPair& pair, double end, bool late, double estimate,
                                            const WideTime& bounds, double& out) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  const std::int32_t reached = floor_below_largest(pair, end, late, estimate, bounds, out);
  const bool is_at_largest = reached == error_range && end >= largest && pair.contact_before(largest) == 0 &&
                             exact_contact_at(pair, largest) > 0;
  if (is_at_largest) out = largest;
  return is_at_largest ? 1 : reached;
}

}  // namespace vesica::detail::cast
