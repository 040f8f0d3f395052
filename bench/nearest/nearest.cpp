// SPDX-License-Identifier: Apache-2.0
/// Times and errors of vesica_nearest and of others on the same disjoint pairs.
#include <algorithm>

#include "nearest/contestant.hpp"
#include "nearest/outline_report.hpp"
#include "nearest/reference.hpp"
#include "quantile.hpp"

namespace vesica::bench {
namespace {

constexpr std::size_t pairs_a_pass = 256, most_passes = 64;

struct Kinds {
  std::int32_t a, b;
  double aspect;
};

/// One contestant's result in one row.
struct Result {
  double nanoseconds = 0, median_error = 0, worst_error = 0;
};

double time_of_pass(DistancePairs& pairs, std::size_t pass) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  volatile double used = pairs.sum(pass * pairs_a_pass, pairs_a_pass);
  static_cast<void>(used);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_a_pass;
}

struct Truth {
  nearest_reference::Distance distance;
  nearest_reference::Real scale;
};

std::vector<Truth> truths(const Kinds& kinds, std::span<const OutlinePair> pairs) {
  std::vector<Truth> result;
  for (const OutlinePair& p : pairs) {
    properties::Pair pair{kinds.a, kinds.b, {}, {}};
    std::ranges::copy(p.a, pair.a.begin());
    std::ranges::copy(p.b, pair.b.begin());
    nearest_reference::set_precision(pair);
    const auto a = nearest_reference::shape(kinds.a, pair.a), b = nearest_reference::shape(kinds.b, pair.b);
    vesica_closest_points_f64 hint{};
    vesica_nearest_f64(kinds.a, p.a.data(), kinds.b, p.b.data(), &hint);
    result.push_back(
        {nearest_reference::distance(a, b, hint.bx - hint.ax, hint.by - hint.ay), nearest_reference::scale(a, b)});
  }
  return result;
}

/// Relative to the largest coordinate of the offset, or half length.
double error(double computed, const Truth& truth) {
  using nearest_reference::Real;
  if (!truth.distance.proved()) return HUGE_VAL;
  return Real(abs(Real(computed) - truth.distance.upper) / truth.scale).get_d();
}

Result measure(DistancePairs& pairs, std::size_t passes, std::span<const Truth> exact) {
  std::vector<double> times, errors;
  for (std::size_t pass = 0; pass < passes; ++pass) times.push_back(time_of_pass(pairs, pass));
  for (std::size_t i = 0; i < exact.size(); ++i) errors.push_back(error(pairs.distance(i), exact[i]));
  return {median(times), median(errors), *std::ranges::max_element(errors)};
}

void report_row(std::FILE* out, const Kinds& kinds) {
  const auto pairs = draw_pairs(kinds.a, kinds.b, Relative::disjoint, kinds.aspect, most_passes * pairs_a_pass);
  const auto exact = truths(kinds, std::span(pairs).first(pairs_checked));
  std::fprintf(out, "\n%s and %s, aspects up to %g\n", vesica_kind_name(kinds.a), vesica_kind_name(kinds.b),
               kinds.aspect);
  double own = 0;
  for (const Contestant& contestant : contestants()) {
    if (!contestant.answers(kinds.a, kinds.b)) continue;
    const auto used = std::span(pairs).first(std::max(contestant.passes * pairs_a_pass, pairs_checked));
    const auto native = contestant.make(kinds.a, kinds.b, used);
    const Result r = measure(*native, contestant.passes, exact);
    if (own == 0) own = r.nanoseconds;
    std::fprintf(out, "  %-26s%10.1f ns %9.2f   %8.1e %8.1e\n", contestant.name.c_str(), r.nanoseconds,
                 r.nanoseconds / own, r.median_error, r.worst_error);
  }
}

}  // namespace

void report_nearest(std::FILE* out) {
  std::fprintf(
      out,
      "vesica_nearest_f64 on fresh disjoint pairs: time a pair, its ratio to the library's, and the error of the\n"
      "distance relative to the scale of the pair (median, worst of %zu)\n",
      pairs_checked);
  // Whoever registered first, the library's calls are what the others are compared with.
  std::ranges::stable_sort(contestants(), {}, [](const Contestant& c) { return !c.name.starts_with("vesica"); });
  report_row(out, {VESICA_RECT, VESICA_RECT, 20});
  report_row(out, {VESICA_RECT, VESICA_ELLIPSE, 20});
  report_row(out, {VESICA_CIRCLE, VESICA_ELLIPSE, 20});
  for (const double aspect : {20., 1e3, 1e6}) report_row(out, {VESICA_ELLIPSE, VESICA_ELLIPSE, aspect});
}

}  // namespace vesica::bench
