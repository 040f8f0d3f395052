// SPDX-License-Identifier: Apache-2.0
/// vesica_nearest, a call at a time and as a batch.
#include <array>

#include "nearest/contestant.hpp"

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

/// Columns in, columns out, 256 pairs a call.
class Batch final : public DistancePairs {
 public:
  Batch(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) : kinds_{kind_a, kind_b} {
    for (std::size_t k = 0; k < 6; ++k) {
      for (const OutlinePair& p : pairs) {
        columns_[0][k].push_back(p.a[k]);
        columns_[1][k].push_back(p.b[k]);
      }
    }
  }

  double distance(std::size_t pair) override {
    ask(pair, 1);
    return out_[0][0];
  }

  double sum(std::size_t first, std::size_t count) override {
    ask(first, count);
    return out_[0][count - 1];
  }

 private:
  vesica_shapes_f64 shapes(std::size_t side, std::size_t first, std::size_t count) const {
    vesica_shapes_f64 s{};
    s.kind = kinds_[side];
    s.count = static_cast<std::int64_t>(count);
    s.stride = sizeof(double);
    for (std::size_t k = 0; k < 6; ++k) s.field[k] = columns_[side][k].data() + first;
    return s;
  }

  void ask(std::size_t first, std::size_t count) {
    const vesica_shapes_f64 a = shapes(0, first, count), b = shapes(1, first, count);
    vesica_nearest_many_f64(&a, &b, out_[0].data(), out_[1].data(), out_[2].data(), out_[3].data(), out_[4].data());
  }

  std::array<std::int32_t, 2> kinds_;
  std::array<std::array<std::vector<double>, 6>, 2> columns_;
  std::array<std::array<double, 256>, 5> out_{};
};

template <class Pairs>
std::unique_ptr<DistancePairs> make(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
  return std::make_unique<Pairs>(kind_a, kind_b, pairs);
}

const bool added = add_contestant({"vesica", any_kinds, make<Calls>, 64}) &&
                   add_contestant({"vesica, batch", any_kinds, make<Batch>, 64});

}  // namespace
}  // namespace vesica::bench
