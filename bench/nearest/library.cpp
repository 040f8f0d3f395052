// SPDX-License-Identifier: Apache-2.0
/// vesica_nearest, a call at a time and as a batch.
#include <array>

#include "nearest/contestant.hpp"
#include "nearest/outline_columns.hpp"

namespace vesica::bench {
namespace {

class Calls final : public DistancePairs {
 public:
  Calls(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs)
      : kind_a_(kind_a), kind_b_(kind_b), pairs_(pairs.begin(), pairs.end()) {}

  double distance(std::size_t pair) override {
    vesica_closest_points_f64 out;
    vesica_nearest_f64(kind_a_, pairs_[pair].a.data(), kind_b_, pairs_[pair].b.data(), &out);
    return out.distance;
  }

  double sum(std::size_t first, std::size_t count) override {
    double result = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      vesica_closest_points_f64 out;
      vesica_nearest_f64(kind_a_, pairs_[i].a.data(), kind_b_, pairs_[i].b.data(), &out);
      result += out.distance + out.ax;
    }
    return result;
  }

 private:
  std::int32_t kind_a_, kind_b_;
  std::vector<OutlinePair> pairs_;
};

/// Columns in, columns out.
class Batch final : public DistancePairs {
 public:
  Batch(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs)
      : columns_(kind_a, kind_b, pairs) {}

  double distance(std::size_t pair) override {
    ask(pair, 1);
    return out_[0][0];
  }

  double sum(std::size_t first, std::size_t count) override {
    ask(first, count);
    return out_[0][count - 1];
  }

 private:
  void ask(std::size_t first, std::size_t count) {
    const vesica_shapes_f64 a = columns_.shapes(0, first, count), b = columns_.shapes(1, first, count);
    vesica_nearest_many_f64(&a, &b, out_[0].data(), out_[1].data(), out_[2].data(), out_[3].data(), out_[4].data());
  }

  OutlineColumns columns_;
  std::array<std::array<double, pairs_a_call>, 5> out_{};
};

template <class Pairs>
std::unique_ptr<DistancePairs> make(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
  return std::make_unique<Pairs>(kind_a, kind_b, pairs);
}

const bool added = add_contestant({"vesica", any_kinds, make<Calls>, 64}) &&
                   add_contestant({"vesica, batch", any_kinds, make<Batch>, 64});

}  // namespace
}  // namespace vesica::bench
