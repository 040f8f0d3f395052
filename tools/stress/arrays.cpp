// SPDX-License-Identifier: Apache-2.0
#include "stress/arrays.hpp"

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cast/motions.hpp"
#include "stress/libraries.hpp"

namespace stress {
namespace {

constexpr std::int64_t nearest_items = 3;

std::vector<Numbers> side(std::span<const Pair> pairs, bool of_b) {
  std::vector<Numbers> result;
  for (const Pair& p : pairs) result.push_back(of_b ? p.b : p.a);
  return result;
}

/// The error of a call whose elements had these codes: an invalid shape before any other.
std::int64_t error_of(std::int64_t error, std::int32_t code) {
  return code == VESICA_E_SHAPE || (code < 0 && error == 0) ? code : error;
}

/// Memory as an index needs it.
struct Aligned {
  struct alignas(64) Unit {
    std::byte bytes[64];
  };
  std::vector<Unit> units;
  std::int64_t size;
  explicit Aligned(std::int64_t n) : units(static_cast<std::size_t>(n / 64 + 1)), size(n) {}
  void* data() { return units.data(); }
};

template <class T>
class Arrays {
 public:
  Arrays(std::span<const Pair> pairs, unsigned layout, const Environment& environment, std::vector<BatchFault>& faults)
      : pairs_(pairs),
        layout_(layout),
        environment_(environment),
        faults_(faults),
        a_(pairs[0].kind_a, side(pairs, false), layout / 3, memory_a_),
        b_(pairs[0].kind_b, side(pairs, true), layout / 5, memory_b_) {
    properties::Random random(layout);
    for (const Pair& p : pairs) {
      const bool sound = properties::valid(p.kind_a, p.a) && properties::valid(p.kind_b, p.b);
      motions_.push_back(sound ? cast_test::draw_motion(p, Types<T>::scalar, random) : Motion{1, 2, 3});
      vx_.push_back(static_cast<T>(motions_.back().vx)), vy_.push_back(static_cast<T>(motions_.back().vy));
      scores_.push_back(static_cast<T>(random.integer(0, 5)));
      labels_.push_back(random.integer(0, 1));
    }
  }

  void judge(const Loaded& library) {
    library_ = &library;
    judge_ratios();
    judge_casts();
    judge_bounds();
    judge_select();
    judge_suppression();
    judge_index();
  }

 private:
  using F = capi_tests::Face<T>;

  template <class Call>
  auto run(const char* function, Call call) {
    function_ = function;
    bool changed = false;
    const auto result = run_in(environment_, changed, call);
    demand(!changed, pairs_.size(), "the environment as before", "another");
    return result;
  }
  void demand(bool holds, std::size_t element, const std::string& expected, const std::string& got) {
    if (holds) return;
    const std::string where = environment_.bits == 0 ? "" : std::string("_environment_") + environment_.name;
    faults_.push_back({element, {std::string("batch.") + function_ + '_' + library_->isa + where, expected, got}});
  }
  void demand_equal(std::size_t element, std::int64_t expected, std::int64_t got) {
    demand(expected == got, element, std::to_string(expected), std::to_string(got));
  }
  void demand_bits(std::size_t element, double expected, T got) {
    const auto wide = static_cast<double>(got);
    const bool same = std::memcmp(&expected, &wide, sizeof wide) == 0 || (std::isnan(expected) && std::isnan(wide));
    demand(same, element, hex(expected), hex(wide));
  }
  template <class Items>
  void demand_items(const Items& expected, const std::vector<std::int64_t>& got) {
    const auto listed = [](const auto& items) {
      std::string text;
      for (const std::int64_t item : items) text += std::to_string(item) + ' ';
      return text;
    };
    demand(std::equal(expected.begin(), expected.end(), got.begin(), got.end()), pairs_.size(), listed(expected),
           listed(got));
  }

  Pair pair(std::size_t i, std::size_t j) const {
    return {pairs_[0].kind_a, pairs_[0].kind_b, pairs_[i].a, pairs_[j].b};
  }
  Answer ask_pair(Query query, std::size_t i, std::size_t j) const { return ask(query, Types<T>::scalar, pair(i, j)); }
  /// b[j], moved, with a[i].
  Answer ask_cast(std::size_t i, std::size_t j, const Motion& m) const {
    return ask({Query::cast, Types<T>::scalar, pair(i, j), m});
  }
  bool valid_a(std::size_t i) const { return properties::valid(pairs_[0].kind_a, pairs_[i].a); }
  bool valid_b(std::size_t i) const { return properties::valid(pairs_[0].kind_b, pairs_[i].b); }

  void judge_ratios() {
    const std::size_t n = pairs_.size(), which = layout_ % ratio_count, rows = std::min<std::size_t>(n, 2);
    std::vector<T> out(n), matrix(rows * n);
    auto few = a_.view();
    few.count = static_cast<std::int64_t>(rows);
    const auto compare = [&](std::int64_t returned, const std::vector<T>& got, const auto& index_a) {
      std::int64_t count = 0, error = 0;
      for (std::size_t k = 0; k < got.size(); ++k) {
        const Answer r = ask_pair(Query::ratio, index_a(k), k % n);
        const auto code = r.code == VESICA_E_SHAPE ? r.code : static_cast<std::int32_t>(r.numbers[ratio_count + which]);
        error = error_of(error, code);
        count += code == 0 && r.numbers[which] > 0;
        demand_bits(k % n, code == 0 ? r.numbers[which] : std::nan(""), got[k]);
      }
      demand_equal(n, error != 0 ? error : count, returned);
    };
    const auto ratio = static_cast<std::int32_t>(which);
    compare(run("ratio_many",
                [&] { return VESICA_FIND(*library_, T, ratio_many)(ratio, &a_.view(), &b_.view(), out.data()); }),
            out, [](std::size_t k) { return k; });
    compare(run("ratio_matrix",
                [&] {
                  return VESICA_FIND(*library_, T, ratio_matrix)(ratio, &few, &b_.view(), matrix.data(),
                                                                 static_cast<std::ptrdiff_t>(n));
                }),
            matrix, [n](std::size_t k) { return k / n; });
  }

  void judge_casts() {
    const std::size_t n = pairs_.size();
    const T end = layout_ % 2 == 0 ? std::numeric_limits<T>::infinity() : T{2};
    std::vector<T> c[5];
    for (auto& column : c) column.resize(n);
    const std::int64_t returned = run("cast_many", [&] {
      return VESICA_FIND(*library_, T, cast_many)(&a_.view(), &b_.view(), vx_.data(), vy_.data(), sizeof(T), end,
                                                  c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data());
    });
    std::int64_t count = 0, error = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Answer r = ask_cast(i, i, {motions_[i].vx, motions_[i].vy, static_cast<double>(end)});
      error = error_of(error, r.code);
      count += r.code > 0;
      for (std::size_t k = 0; k < 5; ++k) demand_bits(i, r.code < 0 ? std::nan("") : r.numbers[k], c[k][i]);
    }
    demand_equal(n, error != 0 ? error : count, returned);
    judge_first_cast(end);
  }

  /// The earliest of all that b[0] touches, by single calls; an error where one has it.
  struct First {
    std::int64_t item;
    Answer impact;
    bool or_range;  // a cast that is out of range may be the first
  };
  /// A cast that is out of range counts unless it misses before the earliest contact.
  First first_of_all(double end) const {
    const auto none = static_cast<std::int64_t>(pairs_.size());
    First first{none, {}, false};
    std::vector<std::size_t> out_of_range;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Answer r = ask_cast(i, 0, {motions_[0].vx, motions_[0].vy, end});
      if (r.code == VESICA_E_SHAPE) return {VESICA_E_SHAPE, {}, false};
      if (r.code == VESICA_E_RANGE) out_of_range.push_back(i);
      const bool is_first = first.item == none || r.numbers[0] < first.impact.numbers[0];
      if (r.code > 0 && is_first) first = {static_cast<std::int64_t>(i), r, false};
    }
    if (first.item == none && !out_of_range.empty()) return {VESICA_E_RANGE, {}, true};
    const auto next = static_cast<double>(
        std::nextafter(static_cast<T>(first.impact.numbers[0]), std::numeric_limits<T>::infinity()));
    for (const std::size_t i : out_of_range) {
      const Answer r = ask_cast(i, 0, {motions_[0].vx, motions_[0].vy, std::fmin(next, end)});
      first.or_range = first.or_range || r.code != VESICA_CAST_MISS;
    }
    return first;
  }
  void demand_first(const First& expected, std::int64_t got, const typename F::Impact& impact) {
    if (expected.or_range && got == VESICA_E_RANGE) return;
    demand_equal(0, expected.item, got);
    if (got == expected.item && got >= 0 && got < a_.view().count) demand_impact(expected.impact, impact);
  }

  void judge_first_cast(T end) {
    auto one = b_.view();
    one.count = 1;
    typename F::Impact impact;
    const std::int64_t got = run("cast_first", [&] {
      return VESICA_FIND(*library_, T, cast_first)(&one, &a_.view(), vx_[0], vy_[0], end, &impact);
    });
    demand_first(first_of_all(static_cast<double>(end)), got, impact);
  }
  void demand_impact(const Answer& expected, const typename F::Impact& got) {
    const T numbers[] = {got.t, got.x, got.y, got.nx, got.ny};
    for (std::size_t k = 0; k < 5; ++k) demand_bits(0, expected.numbers[k], numbers[k]);
  }

  void judge_bounds() {
    std::vector<typename F::Aabb> out(pairs_.size());
    const std::int64_t returned =
        run("bounds_many", [&] { return VESICA_FIND(*library_, T, bounds_many)(&a_.view(), out.data()); });
    std::int64_t error = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Answer r = ask_pair(Query::bounds, i, i);
      error = error_of(error, r.code);
      const T sides[] = {out[i].min_x, out[i].min_y, out[i].max_x, out[i].max_y};
      for (std::size_t k = 0; k < 4; ++k) demand_bits(i, r.code < 0 ? std::nan("") : r.numbers[k], sides[k]);
    }
    demand_equal(pairs_.size(), error, returned);
  }

  /// Which of b does a[0] overlap?
  std::vector<std::int64_t> overlapped() const {
    std::vector<std::int64_t> found;
    for (std::size_t j = 0; j < pairs_.size(); ++j) {
      if (ask_pair(Query::overlap, 0, j).code == 1) found.push_back(static_cast<std::int64_t>(j));
    }
    return found;
  }

  void judge_select() {
    if (!valid_a(0)) return;
    auto one = a_.view();
    one.count = 1;
    std::vector<std::int64_t> out(pairs_.size());
    bool invalid = false;
    for (std::size_t j = 0; j < pairs_.size(); ++j) invalid = invalid || !valid_b(j);
    const std::int64_t returned = run("overlap_select", [&] {
      return VESICA_FIND(*library_, T, overlap_select)(&one, &b_.view(), out.data(), b_.view().count);
    });
    if (invalid) return demand_equal(pairs_.size(), VESICA_E_SHAPE, returned);
    out.resize(static_cast<std::size_t>(std::max<std::int64_t>(returned, 0)));
    demand_items(overlapped(), out);
  }

  /// The items of b that suppression keeps by its definition.
  std::vector<std::int64_t> kept_by_definition(std::int32_t ratio, double threshold, bool labelled) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (valid_b(i)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return scores_[i] > scores_[j]; });
    std::vector<std::int64_t> kept;
    const int kind = pairs_[0].kind_b;
    for (const std::size_t i : order) {
      const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](std::int64_t item) {
        const auto j = static_cast<std::size_t>(item);
        if (labelled && labels_[i] != labels_[j]) return false;
        const Answer r = ask(Query::ratio, Types<T>::scalar, {kind, kind, pairs_[j].b, pairs_[i].b});
        const auto which = static_cast<std::size_t>(ratio);
        return r.numbers[ratio_count + which] == 0 && r.numbers[which] > threshold;
      });
      if (!suppressed) kept.push_back(static_cast<std::int64_t>(i));
    }
    return kept;
  }

  void judge_suppression() {
    if (pairs_[0].kind_b < VESICA_CIRCLE) return;
    constexpr std::int32_t ratios[] = {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_SMALLER, VESICA_RATIO_GENERALIZED,
                                       VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE};
    const std::int32_t ratio = ratios[layout_ % 5];
    const bool labelled = layout_ % 2 == 0;
    const T threshold = layout_ % 3 == 0 ? T{0} : T{0.5};
    std::vector<std::byte> scratch(static_cast<std::size_t>(vesica_nms_scratch(b_.view().count)));
    const auto scratch_size = static_cast<std::int64_t>(scratch.size());
    std::vector<std::int64_t> keep(pairs_.size());
    std::int64_t kept = 0;
    run("suppress", [&] {
      return VESICA_FIND(*library_, T, suppress)(&b_.view(), scores_.data(), labelled ? labels_.data() : nullptr, ratio,
                                                 threshold, -std::numeric_limits<T>::infinity(), b_.view().count,
                                                 scratch.data(), scratch_size, keep.data(), &kept);
    });
    demand_items(kept_by_definition(ratio, static_cast<double>(threshold), labelled),
                 {keep.begin(), keep.begin() + kept});
    run("nms", [&] {
      return VESICA_FIND(*library_, T, nms)(&b_.view(), scores_.data(), threshold, scratch.data(), scratch_size,
                                            keep.data(), &kept);
    });
    demand_items(kept_by_definition(VESICA_RATIO_OVER_UNION, static_cast<double>(threshold), false),
                 {keep.begin(), keep.begin() + kept});
  }

  /// An index of a, asked with b[0], and joined with another of b.
  void judge_index() {
    if (!valid_b(0)) return;
    Aligned index_a(vesica_index_size(a_.view().count)), index_b(vesica_index_size(b_.view().count));
    Aligned scratch(vesica_index_scratch(a_.view().count));
    run("index_build", [&] {
      const auto build = VESICA_FIND(*library_, T, index_build);
      build(&a_.view(), 1, index_a.data(), index_a.size, scratch.data(), scratch.size);
      return build(&b_.view(), 1, index_b.data(), index_b.size, scratch.data(), scratch.size);
    });
    judge_index_select(index_a);
    judge_index_cast(index_a);
    judge_nearest(index_a);
    judge_join(index_a, index_b);
  }

  void judge_index_select(Aligned& index) {
    auto one = b_.view();
    one.count = 1;
    std::vector<std::int64_t> out(pairs_.size()), expected;
    std::int64_t state[4] = {};
    const std::int64_t found = run("index_select", [&] {
      return VESICA_FIND(*library_, T, index_select)(index.data(), &a_.view(), 1, &one, out.data(),
                                                     one.count * a_.view().count, state);
    });
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (ask_pair(Query::overlap, i, 0).code == 1) expected.push_back(static_cast<std::int64_t>(i));
    }
    demand_sorted(expected, out, found);
  }
  /// In any order.
  void demand_sorted(const std::vector<std::int64_t>& expected, std::vector<std::int64_t>& got, std::int64_t found) {
    got.resize(static_cast<std::size_t>(std::max<std::int64_t>(found, 0)));
    std::sort(got.begin(), got.end());
    demand_items(expected, got);
  }

  void judge_index_cast(Aligned& index) {
    const T end{2};
    std::vector<std::int64_t> expected;
    bool any_out_of_range = false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Answer r = ask_cast(i, 0, {motions_[0].vx, motions_[0].vy, 2});
      any_out_of_range = any_out_of_range || r.code == VESICA_E_RANGE;
      if (r.code > 0) expected.push_back(static_cast<std::int64_t>(i));
    }
    auto one = b_.view();
    one.count = 1;
    std::vector<std::int64_t> out(pairs_.size());
    std::int64_t state[4] = {};
    const std::int64_t found = run("index_cast", [&] {
      return VESICA_FIND(*library_, T, index_cast)(index.data(), &a_.view(), 1, &one, vx_[0], vy_[0], end, out.data(),
                                                   a_.view().count, state);
    });
    if (!any_out_of_range) demand_sorted(expected, out, found);
    typename F::Impact impact;
    const std::int64_t first = run("index_cast_first", [&] {
      return VESICA_FIND(*library_, T, index_cast_first)(index.data(), &a_.view(), 1, &one, vx_[0], vy_[0], end,
                                                         &impact);
    });
    const First earliest = first_of_all(2);
    // Single calls refuse what an index leaves out.
    if (earliest.item != VESICA_E_SHAPE) demand_first(earliest, first, impact);
  }

  struct Near {
    double distance;
    std::int64_t item;
    bool operator<(const Near& other) const {
      return distance < other.distance || (distance == other.distance && item < other.item);
    }
  };
  /// The items of a nearest to b[0].
  std::vector<Near> nearest_by_definition() const {
    std::vector<Near> all;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Answer r = ask_pair(Query::nearest, i, 0);
      if (r.code >= 0) all.push_back({r.numbers[0], static_cast<std::int64_t>(i)});
    }
    std::sort(all.begin(), all.end());
    all.resize(std::min<std::size_t>(all.size(), nearest_items));
    return all;
  }

  void judge_nearest(Aligned& index) {
    const std::vector<Near> expected = nearest_by_definition();
    auto one = b_.view();
    one.count = 1;
    std::int64_t items[nearest_items];
    T distances[nearest_items];
    const T within = std::numeric_limits<T>::infinity();
    const auto compare = [&](std::int64_t found) {
      demand_equal(0, static_cast<std::int64_t>(expected.size()), found);
      for (std::size_t k = 0; k < expected.size() && found == static_cast<std::int64_t>(expected.size()); ++k) {
        demand_equal(0, expected[k].item, items[k]);
        demand_bits(0, expected[k].distance, distances[k]);
      }
    };
    compare(run("index_nearest", [&] {
      return VESICA_FIND(*library_, T, index_nearest)(index.data(), &a_.view(), 1, &one, nearest_items, within, items,
                                                      distances);
    }));
    compare(run("join_nearest", [&] {
      return VESICA_FIND(*library_, T, join_nearest)(&one, 1, index.data(), &a_.view(), 1, nearest_items, within, 0, 1,
                                                     items, distances);
    }));
  }

  void judge_join(Aligned& index_a, Aligned& index_b) {
    const std::size_t n = pairs_.size();
    const bool contains = layout_ % 2 == 0 && !is_refused(Query::contains, pairs_[0].kind_a, pairs_[0].kind_b);
    Aligned scratch(vesica_join_scratch());
    std::vector<std::int64_t> out_a(n * n), out_b(n * n), expected, got;
    std::int64_t state[4] = {};
    const std::int64_t found = run("join", [&] {
      return VESICA_FIND(*library_, T, join)(contains ? VESICA_JOIN_CONTAINS : VESICA_JOIN_OVERLAP, index_a.data(),
                                             &a_.view(), 1, index_b.data(), &b_.view(), 1, 0, 1, scratch.data(),
                                             scratch.size, out_a.data(), out_b.data(), static_cast<std::int64_t>(n * n),
                                             state);
    });
    const auto number = [n](std::size_t i, std::size_t j) { return static_cast<std::int64_t>(i * n + j); };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (ask_pair(contains ? Query::contains : Query::overlap, i, j).code == 1) expected.push_back(number(i, j));
      }
    }
    for (std::size_t k = 0; found > 0 && k < static_cast<std::size_t>(found); ++k) {
      got.push_back(number(static_cast<std::size_t>(out_a[k]), static_cast<std::size_t>(out_b[k])));
    }
    demand_sorted(expected, got, found);
  }

  std::span<const Pair> pairs_;
  unsigned layout_;
  const Environment& environment_;
  std::vector<BatchFault>& faults_;
  GuardedMemory memory_a_, memory_b_;
  Array<T> a_, b_;
  std::vector<Motion> motions_;
  std::vector<T> vx_, vy_, scores_;
  std::vector<std::int32_t> labels_;
  const Loaded* library_ = nullptr;
  const char* function_ = "";
};

template <class T>
void judge(std::span<const Pair> pairs, unsigned layout, const Environment& environment,
           std::vector<BatchFault>& faults) {
  Arrays<T> arrays(pairs, layout, environment, faults);
  for (const Loaded& library : loaded()) arrays.judge(library);
}

}  // namespace

void judge_arrays(Scalar scalar, std::span<const Pair> pairs, unsigned layout, const Environment& environment,
                  std::vector<BatchFault>& faults) {
  if (scalar == Scalar::f64) {
    judge<double>(pairs, layout, environment, faults);
  } else {
    judge<float>(pairs, layout, environment, faults);
  }
}

}  // namespace stress
