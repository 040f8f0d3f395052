// SPDX-License-Identifier: Apache-2.0
/// The loops that are timed, and how a file of overlap/ registers its pair.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "row.hpp"

namespace vesica::bench {

/// Pairs a timed pass. The two buffers stay in the first-level cache (24 KiB for the largest shapes), and a pass is
/// long enough (1 us and more) that reading the clock costs 1 or 2%, the same for both sides of a ratio.
constexpr std::size_t pairs_per_pass = 256;

/// The function of any two kinds, for those without a typed one.
template <class A, class B>
std::int32_t overlap_by_kind(const A* a, const B* b) {
  if constexpr (std::is_same_v<typename Described<A>::Scalar, double>) {
    return vesica_overlap_f64(kind_of<A>, a, kind_of<B>, b);
  } else {
    return vesica_overlap_f32(kind_of<A>, a, kind_of<B>, b);
  }
}

template <class Function>
struct Arguments;
template <class A_, class B_>
struct Arguments<std::int32_t (*)(const A_*, const B_*)> {
  using A = A_;
  using B = B_;
};

/// Passes over one typed C function, reached through the shared library, and one yardstick (nullptr for none), inlined.
/// Both are template arguments, so that neither is called through a pointer.
template <auto library, auto yardstick>
class TypedPasses final : public Passes {
 public:
  using A = typename Arguments<decltype(library)>::A;
  using B = typename Arguments<decltype(library)>::B;
  static constexpr bool has_yardstick = !std::is_null_pointer_v<decltype(yardstick)>;

  void load(const Pool& pool) override {
    for (const Numbers& numbers : pool.a) all_a_.push_back(to_shape<A>(numbers));
    for (const Numbers& numbers : pool.b) all_b_.push_back(to_shape<B>(numbers));
    matched_ = pool.matched;
  }

  void unload() override {
    all_a_ = {};
    all_b_ = {};
  }

  void draw(Random& random, std::size_t count) override {
    count_ = count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t index = random.index(all_a_.size());
      a_[i] = all_a_[index];
      b_[i] = all_b_[matched_ ? index : random.index(all_b_.size())];
    }
  }

  std::int64_t library_hits() const override {
    std::int64_t hits = 0;
    for (std::size_t i = 0; i < count_; ++i) hits += library(&a_[i], &b_[i]);
    return hits;
  }

  std::int64_t yardstick_hits() const override {
    std::int64_t hits = 0;
    if constexpr (has_yardstick) {
      for (std::size_t i = 0; i < count_; ++i) hits += yardstick(a_[i], b_[i]);
    }
    return hits;
  }

  std::int64_t disagreements() const override {
    std::int64_t different = 0;
    if constexpr (has_yardstick) {
      for (std::size_t i = 0; i < count_; ++i) different += yardstick(a_[i], b_[i]) != (library(&a_[i], &b_[i]) == 1);
    }
    return different;
  }

 private:
  std::array<A, pairs_per_pass> a_{};
  std::array<B, pairs_per_pass> b_{};
  std::size_t count_ = 0;
  std::vector<A> all_a_;
  std::vector<B> all_b_;
  bool matched_ = false;
};

struct WorkloadAndTarget {
  Workload workload;
  Target target = {};
};

/// Adds the rows of one pair and scalar. Workloads the pair does not have are left out.
template <auto library, auto yardstick = nullptr>
bool add_rows(std::initializer_list<WorkloadAndTarget> workloads) {
  using Typed = TypedPasses<library, yardstick>;
  using A = typename Typed::A;
  using B = typename Typed::B;
  for (const auto& [workload, target] : workloads) {
    if (!has_workload(kind_of<A>, kind_of<B>, workload)) continue;
    Row row{};
    row.kind_a = kind_of<A>;
    row.kind_b = kind_of<B>;
    row.scalar = scalar_name<A>;
    row.workload = workload;
    row.target = target;
    row.has_yardstick = Typed::has_yardstick && !is_exact(workload);
    row.passes = std::make_unique<Typed>();
    rows().push_back(std::move(row));
  }
  return true;
}

/// The rows of a pair of kinds, with the stated shares of overlapping pairs.
template <auto library_f64, auto yardstick_f64, auto library_f32, auto yardstick_f32>
bool add_rates(Target target) {
  bool added = true;
  for (const Workload workload : by_rate) added = add_rows<library_f64, yardstick_f64>({{workload, target}}) && added;
  return added && add_rows<library_f64, yardstick_f64>({{Workload::near}}) &&
         add_rows<library_f32, yardstick_f32>({{Workload::mixed}});
}

}  // namespace vesica::bench
