// SPDX-License-Identifier: Apache-2.0
// The same hashes of what is asked of many shapes: an index, its bytes and answers, joins by each query, and
// suppression. They are those of scenes.txt; see answers_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "answers/scene.hpp"
#include "answers/table.hpp"
#include "index/face.hpp"

namespace {

using answers::Hash;
using answers::Table;
using index_tests::Indexed;
using index_tests::Memory;
using index_tests::Sets;

template <class T>
class Asked {
  using F = index_tests::Face<T>;
  using Shapes = typename F::Shapes;

 public:
  explicit Asked(const std::string& name)
      : a_(answers::scene<T>(name, name == "whole_range" ? 24 : 200, 1)),
        b_(answers::scene<T>(name, name == "whole_range" ? 12 : 70, 2)) {}

  std::map<std::string, Hash> all() {
    add("build", a_.result, b_.result);
    hashes_["bytes"].add(a_.copy());
    hashes_["bytes"].add(b_.copy());
    select_cast_and_nearest();
    for (std::int32_t query = VESICA_JOIN_OVERLAP; query <= VESICA_JOIN_BOUNDS; ++query) join(query);
    join_within();
    join_nearest();
    for (std::size_t kind = 0; kind < 6; ++kind) {
      suppress(kind);
    }
    return hashes_;
  }

 private:
  template <class... Values>
  void add(const std::string& name, const Values&... values) {
    (hashes_[name].add_values(&values, 1), ...);
  }
  template <class Value>
  void add_list(const std::string& name, const std::vector<Value>& values) {
    hashes_[name].add_values(values.data(), values.size());
  }

  /// Shape i of a set as an array of one.
  static Shapes one(Shapes shapes, std::int64_t i) {
    shapes.count = 1;
    for (auto& field : shapes.field) {
      if (field != nullptr) {
        field = reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(field) + i * shapes.stride);
      }
    }
    return shapes;
  }

  void select_cast_and_nearest() {
    for (const Shapes& set : b_.sets.sets) {
      for (std::int64_t i = 0; i < set.count; i += 9) {
        const Shapes asked = one(set, i);
        std::vector<std::int64_t> out(7);
        std::vector<T> distance(7);
        for (std::int64_t state[4] = {}; state[0] != -1;) {
          const std::int64_t n =
              F::index_select(a_.index.get(), a_.sets.data(), a_.sets.count(), &asked, out.data(), 7, state);
          add("select", n);
          add_list("select", out);
          if (n < 0) break;
        }
        const T infinity = std::numeric_limits<T>::infinity(), vx = T{3} - static_cast<T>(i % 7), vy = T{1} / 2;
        for (const T within : {T{1}, infinity}) {
          add("nearest", F::index_nearest(a_.index.get(), a_.sets.data(), a_.sets.count(), &asked, 7, within,
                                          out.data(), distance.data()));
          add_list("nearest", out);
          add_list("nearest", distance);
        }
        for (std::int64_t state[4] = {}; state[0] != -1;) {
          const std::int64_t n = F::index_cast(a_.index.get(), a_.sets.data(), a_.sets.count(), &asked, vx, vy, T{2},
                                               out.data(), 7, state);
          add("cast", n);
          add_list("cast", out);
          if (n < 0) break;
        }
        typename F::Impact impact{};
        add("cast first",
            F::index_cast_first(a_.index.get(), a_.sets.data(), a_.sets.count(), &asked, vx, vy, infinity, &impact));
        add("cast first", impact);
      }
    }
  }

  void join(std::int32_t query) {
    const std::string name = "join " + std::to_string(query);
    for (const Indexed<T>* b : {&b_, &a_}) {
      for (std::int64_t part = 0; part < 3; ++part) add_list(name, index_tests::join(query, a_, *b, part, 3, 50));
      add(name, index_tests::count(query, a_, *b));
    }
  }

  void join_within() {
    std::vector<std::int64_t> out_a(500), out_b(500);
    for (const T distance : {T{0}, T{1} / 4}) {
      for (std::int64_t state[4] = {}; state[0] != -1;) {
        const std::int64_t n =
            F::join_within(a_.index.get(), a_.sets.data(), a_.sets.count(), b_.index.get(), b_.sets.data(),
                           b_.sets.count(), distance, 0, 1, out_a.data(), out_b.data(), 500, state);
        add("join within", n);
        add_list("join within", out_a);
        add_list("join within", out_b);
        if (n < 0) break;
      }
    }
  }

  void join_nearest() {
    constexpr std::int64_t k = 3;
    std::vector<std::int64_t> out(static_cast<std::size_t>(k * a_.sets.items));
    std::vector<T> distance(out.size());
    for (const T within : {T{1} / 2, std::numeric_limits<T>::infinity()}) {
      add("join nearest", F::join_nearest(a_.sets.data(), a_.sets.count(), b_.index.get(), b_.sets.data(),
                                          b_.sets.count(), k, within, 0, 1, out.data(), distance.data()));
      add_list("join nearest", out);
      add_list("join nearest", distance);
    }
  }

  /// Each set, which has one kind, by each ratio.
  void suppress(std::size_t kind) {
    const Shapes& shapes = a_.sets.sets[kind];
    std::vector<T> scores, decayed(static_cast<std::size_t>(shapes.count));
    std::vector<std::int32_t> labels;
    for (std::int64_t i = 0; i < shapes.count; ++i) {
      scores.push_back(static_cast<T>(i * 37 % 101) / 128);
      labels.push_back(static_cast<std::int32_t>(i % 2));
    }
    const Memory scratch(vesica_nms_scratch(shapes.count)), soft(vesica_suppress_soft_scratch(shapes.count));
    std::vector<std::int64_t> keep(scores.size());
    std::int64_t kept = 0;
    // The narrow Gaussian leaves nothing of a score.
    constexpr std::pair<std::int32_t, T> decays[] = {
        {VESICA_DECAY_LINEAR, T{1} / 2}, {VESICA_DECAY_GAUSSIAN, T{1} / 2}, {VESICA_DECAY_GAUSSIAN, T{1} / 4096}};
    for (std::int32_t ratio = 0; ratio <= VESICA_RATIO_COMPLETE; ++ratio) {
      for (const bool labelled : {false, true}) {
        add("suppress", F::suppress(&shapes, scores.data(), labelled ? labels.data() : nullptr, ratio, T{1} / 8,
                                    T{1} / 16, 150, scratch.get(), scratch.size, keep.data(), &kept));
        add("suppress", kept);
        add_list("suppress", keep);
      }
      for (const auto& [decay, parameter] : decays) {
        add("suppress soft", F::suppress_soft(&shapes, scores.data(), labels.data(), ratio, decay, parameter, T{1} / 16,
                                              60, soft.get(), soft.size, keep.data(), decayed.data(), &kept));
        add("suppress soft", kept);
        add_list("suppress soft", keep);
        add_list("suppress soft", decayed);
      }
    }
  }

  Indexed<T> a_, b_;
  std::map<std::string, Hash> hashes_;
};

class Scenes : public testing::TestWithParam<std::string> {
 protected:
  template <class T>
  void compare(const char* scalar) {
    if (std::endian::native != std::endian::little) GTEST_SKIP() << "hashes are of bytes in the other order";
    static Table pinned = answers::read_table("scenes.txt");
    for (const auto& [name, hash] : Asked<T>(GetParam()).all()) {
      auto& line = pinned[name + ' ' + scalar][GetParam()];
      line.resize(1);
      answers::judge(line[0], hash.value(), name + ' ' + scalar + " of " + GetParam());
    }
    answers::write_table("scenes.txt", pinned);
  }
};

TEST(Sizes, OfWhatCallersProvide) {
  Hash hash;
  const auto add = [&](std::int64_t size) { hash.add_values(&size, 1); };
  add(vesica_join_scratch());
  for (const std::int64_t most : {std::int64_t{0}, std::int64_t{5000}, std::int64_t{1} << 20, std::int64_t{1} << 31}) {
    for (std::int64_t n = std::max<std::int64_t>(most - 130, -2); n < most + 130; ++n) {
      for (const auto size :
           {vesica_index_size, vesica_index_scratch, vesica_nms_scratch, vesica_suppress_soft_scratch}) {
        add(size(n));
      }
    }
  }
  Table pinned = answers::read_table("scenes.txt");
  auto& line = pinned["sizes"]["all"];
  line.resize(1);
  answers::judge(line[0], hash.value(), "sizes");
  answers::write_table("scenes.txt", pinned);
}

TEST_P(Scenes, Double) { compare<double>("f64"); }
TEST_P(Scenes, Float) { compare<float>("f32"); }

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(answers::scenes()),
                         [](const testing::TestParamInfo<std::string>& scene) { return scene.param; });

}  // namespace
