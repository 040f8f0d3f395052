// SPDX-License-Identifier: Apache-2.0
/// Each argument of each function over an index made wrong alone, in double and in float: the function says which error
/// that is, and writes nothing. As they are the arguments are accepted.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "index/face.hpp"

namespace index_tests {
namespace {

/// The arguments of all functions: two sides, a moving shape, and room for answers.
template <class T>
struct Call {
  using Shapes = typename Face<T>::Shapes;
  const void *index, *index_b;
  const Shapes *sets, *sets_b, *one;
  std::int32_t set_count = 1, set_count_b = 1, query = VESICA_JOIN_OVERLAP;
  std::int64_t k = 2, capacity = 2, part = 0, parts = 1, scratch_size;
  T within = 1, vx = 1, vy = 0, end = 1;
  void* scratch;
  std::int64_t *out, *out_b, *state;
  T* distance;
  typename Face<T>::Impact* hit;
};

template <class T>
struct Wrong {
  const char* what;
  std::int64_t error;
  std::function<void(Call<T>&)> make;
};

template <class T>
class Refusals : public testing::Test {
 protected:
  using Shapes = typename Face<T>::Shapes;
  using Function = std::function<std::int64_t(const Call<T>&)>;

  Refusals() : a_(rects<T>("uniform", 300, 1)), b_(rects<T>("uniform", 200, 2)), scratch_(vesica_join_scratch()) {
    std::memset(foreign_, 0, sizeof foreign_);
    one_ = shapes_of(VESICA_RECT, 1);
    none_ = shapes_of(VESICA_RECT, 0);
    other_kind_ = one_;
    other_kind_.kind = VESICA_POLYLINE + 1;
    invalid_ = one_;
    invalid_.field[4] = &minus_one_;
  }

  Shapes shapes_of(std::int32_t kind, std::int64_t count) {
    Shapes shapes;
    EXPECT_EQ(Face<T>::from_records(kind, count, numbers_, sizeof numbers_, &shapes), 0);
    return shapes;
  }

  Call<T> sound() {
    return {.index = a_.index.get(),
            .index_b = b_.index.get(),
            .sets = a_.sets.data(),
            .sets_b = b_.sets.data(),
            .one = &one_,
            .scratch_size = scratch_.size,
            .scratch = scratch_.get(),
            .out = out_,
            .out_b = out_b_,
            .state = state_,
            .distance = distance_,
            .hit = &hit_};
  }

  void clear() {
    for (int i = 0; i < 8; ++i) out_[i] = out_b_[i] = 7, distance_[i] = 7;
    for (std::int64_t& s : state_) s = 0;
    std::memset(&hit_, 7, sizeof hit_);
  }

  void expect_refusals(const char* name, const Function& function, const std::vector<Wrong<T>>& all) {
    clear();
    EXPECT_GE(function(sound()), 0) << name;
    for (const Wrong<T>& wrong : all) {
      clear();
      Call<T> call = sound();
      wrong.make(call);
      EXPECT_EQ(function(call), wrong.error) << name << ": " << wrong.what;
      for (int i = 0; i < 8; ++i) EXPECT_TRUE(out_[i] == 7 && out_b_[i] == 7 && distance_[i] == 7) << wrong.what;
    }
    for (const Wrong<T>& wrong : all) {
      if (wrong.error == VESICA_E_INDEX || std::strcmp(wrong.what, "index at 8") == 0) {
        expect_order(name, function, wrong, all);
      }
    }
  }

  /// An index that cannot be read, and besides it any other argument wrong: the error that comes first is returned.
  void expect_order(const char* name, const Function& function, const Wrong<T>& of_index,
                    const std::vector<Wrong<T>>& all) {
    for (const Wrong<T>& other : all) {
      clear();
      Call<T> call = sound();
      of_index.make(call);
      const void *const a = call.index, *const b = call.index_b;
      other.make(call);
      const bool replaced = a != sound().index ? call.index != a : call.index_b != b;
      EXPECT_EQ(function(call), replaced ? other.error : first_of(of_index.error, other.error))
          << name << ": " << of_index.what << ", " << other.what;
    }
  }

  static std::int64_t first_of(std::int64_t a, std::int64_t b) {
    for (const std::int64_t e : {VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT}) {
      if (a == e || b == e) return e;
    }
    return 0;
  }

  /// Faults of every function that takes an index of the first side.
  std::vector<Wrong<T>> of_first_side() {
    return {{"index NULL", VESICA_E_NULL, [](auto& c) { c.index = nullptr; }},
            {"index at 8", VESICA_E_ARGUMENT, [](auto& c) { c.index = static_cast<const char*>(c.index) + 8; }},
            {"no index", VESICA_E_INDEX, [this](auto& c) { c.index = foreign_; }},
            {"sets NULL", VESICA_E_NULL, [](auto& c) { c.sets = nullptr; }},
            {"-1 sets", VESICA_E_ARGUMENT, [](auto& c) { c.set_count = -1; }},
            {"sets of another kind", VESICA_E_KIND, [this](auto& c) { c.sets = &other_kind_; }},
            {"sets of another index", VESICA_E_ARGUMENT, [](auto& c) { c.sets = c.sets_b; }}};
  }
  std::vector<Wrong<T>> of_second_side() {
    return {{"index NULL", VESICA_E_NULL, [](auto& c) { c.index_b = nullptr; }},
            {"index at 8", VESICA_E_ARGUMENT, [](auto& c) { c.index_b = static_cast<const char*>(c.index_b) + 8; }},
            {"no index", VESICA_E_INDEX, [this](auto& c) { c.index_b = foreign_; }},
            {"sets NULL", VESICA_E_NULL, [](auto& c) { c.sets_b = nullptr; }},
            {"sets of another kind", VESICA_E_KIND, [this](auto& c) { c.sets_b = &other_kind_; }},
            {"sets of another index", VESICA_E_ARGUMENT, [](auto& c) { c.sets_b = c.sets; }}};
  }
  std::vector<Wrong<T>> of_one() {
    return {{"one NULL", VESICA_E_NULL, [](auto& c) { c.one = nullptr; }},
            {"no shape", VESICA_E_ARGUMENT, [this](auto& c) { c.one = &none_; }},
            {"one of another kind", VESICA_E_KIND, [this](auto& c) { c.one = &other_kind_; }},
            {"one invalid", VESICA_E_SHAPE, [this](auto& c) { c.one = &invalid_; }}};
  }
  std::vector<Wrong<T>> of_pages() {
    return {{"out NULL", VESICA_E_NULL, [](auto& c) { c.out = nullptr; }},
            {"state NULL", VESICA_E_NULL, [](auto& c) { c.state = nullptr; }},
            {"capacity -1", VESICA_E_ARGUMENT, [](auto& c) { c.capacity = -1; }},
            {"state[0] -2", VESICA_E_ARGUMENT, [](auto& c) { c.state[0] = -2; }},
            {"state[0] beyond", VESICA_E_ARGUMENT, [](auto& c) { c.state[0] = 1 << 20; }},
            {"state[1] 1", VESICA_E_ARGUMENT, [](auto& c) { c.state[1] = 1; }},
            {"state[1] -1", VESICA_E_ARGUMENT, [](auto& c) { c.state[1] = -1; }},
            {"state[2] 1", VESICA_E_ARGUMENT, [](auto& c) { c.state[2] = 1; }},
            {"state[2] -1", VESICA_E_ARGUMENT, [](auto& c) { c.state[2] = -1; }},
            {"state[3] 1", VESICA_E_ARGUMENT, [](auto& c) { c.state[3] = 1; }},
            {"state[3] -1", VESICA_E_ARGUMENT, [](auto& c) { c.state[3] = -1; }}};
  }
  std::vector<Wrong<T>> of_parts() {
    return {{"0 parts", VESICA_E_ARGUMENT, [](auto& c) { c.parts = 0; }},
            {"part -1", VESICA_E_ARGUMENT, [](auto& c) { c.part = -1; }},
            {"part 1 of 1", VESICA_E_ARGUMENT, [](auto& c) { c.part = 1; }}};
  }
  std::vector<Wrong<T>> of_distances() {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    return {{"k -1", VESICA_E_ARGUMENT, [](auto& c) { c.k = -1; }},
            {"out NULL", VESICA_E_NULL, [](auto& c) { c.out = nullptr; }},
            {"distance NULL", VESICA_E_NULL, [](auto& c) { c.distance = nullptr; }},
            {"within -1", VESICA_E_ARGUMENT, [](auto& c) { c.within = -1; }},
            {"within NaN", VESICA_E_ARGUMENT, [](auto& c) { c.within = nan; }}};
  }
  std::vector<Wrong<T>> of_motion() {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    return {{"vx infinite", VESICA_E_ARGUMENT, [](auto& c) { c.vx = infinity; }},
            {"vy NaN", VESICA_E_ARGUMENT, [](auto& c) { c.vy = nan; }},
            {"end -1", VESICA_E_ARGUMENT, [](auto& c) { c.end = -1; }},
            {"end NaN", VESICA_E_ARGUMENT, [](auto& c) { c.end = nan; }}};
  }
  static std::vector<Wrong<T>> all(std::initializer_list<std::vector<Wrong<T>>> lists) {
    std::vector<Wrong<T>> joined;
    for (const auto& list : lists) joined.insert(joined.end(), list.begin(), list.end());
    return joined;
  }

  const Indexed<T> a_, b_;
  const Memory scratch_;
  T numbers_[6] = {0, 0, 1, 0, 1, 1}, minus_one_ = -1;
  Shapes one_, none_, other_kind_, invalid_;
  alignas(64) char foreign_[1024];
  std::int64_t out_[8], out_b_[8], state_[4];
  T distance_[8];
  typename Face<T>::Impact hit_;
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(Refusals, Scalars);

TYPED_TEST(Refusals, Select) {
  using F = Face<TypeParam>;
  auto wrong = this->all({this->of_first_side(), this->of_one(), this->of_pages()});
  // Without sets boxes are compared; that there are none must be said.
  wrong.push_back({"no sets, of which there are 1", VESICA_E_ARGUMENT, [](auto& c) { c.sets = nullptr; }});
  std::erase_if(wrong, [](const auto& w) { return std::strcmp(w.what, "sets NULL") == 0; });
  this->expect_refusals(
      "select",
      [](const Call<TypeParam>& c) {
        return F::index_select(c.index, c.sets, c.set_count, c.one, c.out, c.capacity, c.state);
      },
      wrong);
}

TYPED_TEST(Refusals, Nearest) {
  using F = Face<TypeParam>;
  this->expect_refusals(
      "nearest",
      [](const Call<TypeParam>& c) {
        return F::index_nearest(c.index, c.sets, c.set_count, c.one, c.k, c.within, c.out, c.distance);
      },
      this->all({this->of_first_side(), this->of_one(), this->of_distances()}));
}

TYPED_TEST(Refusals, JoinNearest) {
  using F = Face<TypeParam>;
  auto wrong = this->all({this->of_second_side(), this->of_distances(), this->of_parts()});
  std::erase_if(wrong, [](const auto& w) { return std::strcmp(w.what, "sets of another index") == 0; });
  wrong.push_back({"k 0", VESICA_E_ARGUMENT, [](auto& c) { c.k = 0; }});
  wrong.push_back({"k beyond memory", VESICA_E_ARGUMENT, [](auto& c) { c.k = INT64_MAX / 8; }});
  wrong.push_back({"first sets NULL", VESICA_E_NULL, [](auto& c) { c.sets = nullptr; }});
  wrong.push_back({"second sets those of another index", VESICA_E_ARGUMENT, [](auto& c) { c.sets_b = c.sets; }});
  const auto few = [](const Call<TypeParam>& c) {
    // The first side has one shape: its rows fit.
    const bool as_it_is = c.sets != nullptr;
    return F::join_nearest(as_it_is ? c.one : nullptr, 1, c.index_b, c.sets_b, c.set_count_b, c.k, c.within, c.part,
                           c.parts, c.out, c.distance);
  };
  this->expect_refusals("join_nearest", few, wrong);
}

TYPED_TEST(Refusals, Join) {
  using F = Face<TypeParam>;
  auto wrong = this->all({this->of_first_side(), this->of_second_side(), this->of_pages(), this->of_parts()});
  wrong.push_back({"second out NULL", VESICA_E_NULL, [](auto& c) { c.out_b = nullptr; }});
  wrong.push_back({"scratch NULL", VESICA_E_NULL, [](auto& c) { c.scratch = nullptr; }});
  wrong.push_back({"scratch at 8", VESICA_E_ARGUMENT, [](auto& c) { c.scratch = static_cast<char*>(c.scratch) + 8; }});
  wrong.push_back({"scratch too small", VESICA_E_ARGUMENT, [](auto& c) { --c.scratch_size; }});
  wrong.push_back({"query -1", VESICA_E_ARGUMENT, [](auto& c) { c.query = -1; }});
  wrong.push_back({"query 5", VESICA_E_ARGUMENT, [](auto& c) { c.query = VESICA_JOIN_INTERIORS + 1; }});
  this->expect_refusals(
      "join",
      [](const Call<TypeParam>& c) {
        return F::join(c.query, c.index, c.sets, c.set_count, c.index_b, c.sets_b, c.set_count_b, c.part, c.parts,
                       c.scratch, c.scratch_size, c.out, c.out_b, c.capacity, c.state);
      },
      wrong);
}

TYPED_TEST(Refusals, JoinWithin) {
  using F = Face<TypeParam>;
  auto wrong = this->all({this->of_first_side(), this->of_second_side(), this->of_pages(), this->of_parts()});
  wrong.push_back({"second out NULL", VESICA_E_NULL, [](auto& c) { c.out_b = nullptr; }});
  wrong.push_back(
      {"distance NaN", VESICA_E_ARGUMENT, [](auto& c) { c.within = std::numeric_limits<TypeParam>::quiet_NaN(); }});
  this->expect_refusals(
      "join_within",
      [](const Call<TypeParam>& c) {
        return F::join_within(c.index, c.sets, c.set_count, c.index_b, c.sets_b, c.set_count_b, c.within, c.part,
                              c.parts, c.out, c.out_b, c.capacity, c.state);
      },
      wrong);
}

TYPED_TEST(Refusals, Cast) {
  using F = Face<TypeParam>;
  const auto wrong = this->all({this->of_first_side(), this->of_one(), this->of_motion()});
  this->expect_refusals(
      "index_cast",
      [](const Call<TypeParam>& c) {
        return F::index_cast(c.index, c.sets, c.set_count, c.one, c.vx, c.vy, c.end, c.out, c.capacity, c.state);
      },
      this->all({wrong, this->of_pages()}));
  const Wrong<TypeParam> no_room{"out NULL", VESICA_E_NULL, [](auto& c) { c.hit = nullptr; }};
  this->expect_refusals(
      "index_cast_first",
      [](const Call<TypeParam>& c) {
        return F::index_cast_first(c.index, c.sets, c.set_count, c.one, c.vx, c.vy, c.end, c.hit);
      },
      this->all({wrong, {no_room}}));
}

}  // namespace
}  // namespace index_tests
