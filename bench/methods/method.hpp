// SPDX-License-Identifier: Apache-2.0
/// A named method beside the exact default, on the same fresh pairs.
#pragma once

#include <vesica_methods.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "methods/pools.hpp"
#include "pair.hpp"

namespace vesica::bench::methods {

/// A method's result on one pool.
struct Outcome {
  double method = 0, exact = 0;  ///< nanoseconds a test
  std::int64_t wrong = 0, uncertain = 0, asked = 0;
};

/// The typed code of a method. Shapes are copied at random from the pool into hot buffers before each timed pass.
class Contest {
 public:
  virtual ~Contest() = default;
  virtual void load(const Pool& pool) = 0;
  virtual void unload() = 0;
  virtual void draw(Random& random) = 0;
  /// How many pairs a pass has.
  virtual std::size_t pairs() const { return pairs_per_pass; }
  /// Sums of answers, for the clock.
  virtual std::int64_t method_sum() const = 0;
  virtual std::int64_t exact_sum() const = 0;
  /// Every pair of the pool, answers compared.
  virtual void count(Outcome& outcome) const = 0;
};

/// A shape in the form a method takes it, from the numbers of the kind. Methods with forms of their own specialise it.
template <class Shape>
struct FormOf {
  static constexpr std::int32_t kind = kind_of<Shape>;
  static Shape make(const Numbers& numbers) { return to_shape<Shape>(numbers); }
};

/// Both functions through the shared library, as template arguments, so that neither is called through a pointer.
/// `exact` answers of the very numbers that the method is given.
template <auto method, auto exact>
class TypedContest final : public Contest {
 public:
  using A = typename Arguments<decltype(method)>::A;
  using B = typename Arguments<decltype(method)>::B;

  void load(const Pool& pool) override {
    for (const Numbers& numbers : pool.a) all_a_.push_back(FormOf<A>::make(numbers));
    for (const Numbers& numbers : pool.b) all_b_.push_back(FormOf<B>::make(numbers));
    matched_ = pool.matched;
  }

  void unload() override {
    all_a_ = {};
    all_b_ = {};
  }

  void draw(Random& random) override {
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      const std::size_t index = random.index(all_a_.size());
      a_[i] = all_a_[index];
      b_[i] = all_b_[matched_ ? index : random.index(all_b_.size())];
    }
  }

  std::int64_t method_sum() const override {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < pairs_per_pass; ++i) sum += method(&a_[i], &b_[i]);
    return sum;
  }

  std::int64_t exact_sum() const override {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < pairs_per_pass; ++i) sum += exact(&a_[i], &b_[i]);
    return sum;
  }

  void count(Outcome& outcome) const override {
    for (std::size_t i = 0; i < all_a_.size(); ++i) {
      const std::int32_t answer = method(&all_a_[i], &all_b_[i]), truth = exact(&all_a_[i], &all_b_[i]);
      ++outcome.asked;
      outcome.uncertain += answer == VESICA_UNCERTAIN;
      outcome.wrong += answer != VESICA_UNCERTAIN && answer != truth;
    }
  }

 private:
  std::array<A, pairs_per_pass> a_{};
  std::array<B, pairs_per_pass> b_{};
  std::vector<A> all_a_;
  std::vector<B> all_b_;
  bool matched_ = false;
};

struct Method {
  std::string name;
  std::string table, exact;  ///< the table it stands in, and the exact default's name there
  Kinds kinds;
  std::unique_ptr<Contest> contest;
  std::vector<Outcome> outcomes;  ///< one a trial, once measured
};

/// Adds one; `name` is that of the C function without vesica_method_ and the scalar.
template <auto method, auto exact>
void add(std::vector<Method>& methods, const char* name, Axes axes = Axes::any) {
  using Typed = TypedContest<method, exact>;
  const Kinds kinds{FormOf<typename Typed::A>::kind, FormOf<typename Typed::B>::kind, axes};
  const std::string pair = std::string(vesica_kind_name(kinds.a)) + "_" + vesica_kind_name(kinds.b);
  methods.push_back({name,
                     axes == Axes::parallel ? pair + ", parallel axes" : pair,
                     "vesica_overlap_" + pair,
                     kinds,
                     std::make_unique<Typed>(),
                     {}});
}

// In the order in which their tables are printed.
void add_rect_rect(std::vector<Method>& methods);
void add_rect_ellipse(std::vector<Method>& methods);
void add_segment_circle(std::vector<Method>& methods);
void add_circle_ellipse(std::vector<Method>& methods);
void add_ellipse_ellipse(std::vector<Method>& methods);
void add_ellipse_ellipse_distance(std::vector<Method>& methods);

}  // namespace vesica::bench::methods
