// SPDX-License-Identifier: Apache-2.0
/// vesica::Index<T>: an index that owns its memory, and loops over the pairs of two. A C++20 face of vesica.h, for
/// programs that link the library.
///
///     const vesica::Index<double> trees({vesica::shapes(circles), vesica::shapes(boxes)});
///     const vesica::Index<double> roads({vesica::shapes(rects)}, vesica::Threads());
///     for (const auto& [tree, road] : vesica::pairs(trees, roads)) ...
///     for (const std::int64_t tree : trees.overlapping(vesica_circle_f64{0, 0, 1})) ...
///
/// Shapes are the structs of vesica.h, or the core's: vesica::Rect<double> is vesica_rect_f64. They stay the caller's:
/// an index keeps the descriptors of their arrays, and the arrays must outlive it. Errors of the library are exceptions
/// of std::invalid_argument with its words.
#pragma once

#if !defined(_MSC_VER) && __cplusplus < 201709L
#error "vesica_index.hpp needs C++20: compile with -std=c++20"
#endif

#include <vesica.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace vesica {

// The core's shapes, laid out as those of vesica.h.
template <class T>
struct Point;
template <class T>
struct Segment;
template <class T>
struct Circle;
template <class T>
struct Aabb;
template <class T>
struct Rect;
template <class T>
struct Ellipse;
template <class T>
struct Capsule;
template <class T>
struct RoundRect;
template <class T>
struct Polygon;
template <class T>
struct Polyline;

namespace index_face {

/// The C functions of a scalar type.
template <class T>
struct Functions;
template <>
struct Functions<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
  using Impact = vesica_impact_f64;
  using Turn = vesica_turn_f64;
  static constexpr auto build = vesica_index_build_f64;
  static constexpr auto step = vesica_index_step_f64;
  static constexpr auto select = vesica_index_select_f64;
  static constexpr auto nearest = vesica_index_nearest_f64;
  static constexpr auto cast = vesica_index_cast_f64;
  static constexpr auto cast_first = vesica_index_cast_first_f64;
  static constexpr auto impact_time = vesica_index_impact_time_f64;
  static constexpr auto join = vesica_join_f64;
  static constexpr auto join_within = vesica_join_within_f64;
  static constexpr auto join_nearest = vesica_join_nearest_f64;
};
template <>
struct Functions<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
  using Impact = vesica_impact_f32;
  using Turn = vesica_turn_f32;
  static constexpr auto build = vesica_index_build_f32;
  static constexpr auto step = vesica_index_step_f32;
  static constexpr auto select = vesica_index_select_f32;
  static constexpr auto nearest = vesica_index_nearest_f32;
  static constexpr auto cast = vesica_index_cast_f32;
  static constexpr auto cast_first = vesica_index_cast_first_f32;
  static constexpr auto impact_time = vesica_index_impact_time_f32;
  static constexpr auto join = vesica_join_f32;
  static constexpr auto join_within = vesica_join_within_f32;
  static constexpr auto join_nearest = vesica_join_nearest_f32;
};

/// The kind of a struct of the library's, and the type of its numbers.
template <class T, std::int32_t the_kind>
struct Is {
  using Scalar = T;
  static constexpr std::int32_t kind = the_kind;
};
template <class Struct>
struct Shape;
#define VESICA_INDEX_SHAPE(Core, name, kind)               \
  template <class T>                                       \
  struct Shape<Core<T>> : Is<T, kind> {};                  \
  template <>                                              \
  struct Shape<vesica_##name##_f64> : Is<double, kind> {}; \
  template <>                                              \
  struct Shape<vesica_##name##_f32> : Is<float, kind> {};
VESICA_INDEX_SHAPE(Point, point, VESICA_POINT)
VESICA_INDEX_SHAPE(Segment, segment, VESICA_SEGMENT)
VESICA_INDEX_SHAPE(Circle, circle, VESICA_CIRCLE)
VESICA_INDEX_SHAPE(Aabb, aabb, VESICA_AABB)
VESICA_INDEX_SHAPE(Rect, rect, VESICA_RECT)
VESICA_INDEX_SHAPE(Ellipse, ellipse, VESICA_ELLIPSE)
VESICA_INDEX_SHAPE(Capsule, capsule, VESICA_CAPSULE)
VESICA_INDEX_SHAPE(RoundRect, round_rect, VESICA_ROUND_RECT)
VESICA_INDEX_SHAPE(Polygon, polygon, VESICA_POLYGON)
VESICA_INDEX_SHAPE(Polyline, polyline, VESICA_POLYLINE)
#undef VESICA_INDEX_SHAPE

/// Memory aligned as an index and scratch must be.
class Memory {
 public:
  explicit Memory(std::int64_t bytes)
      : bytes_(bytes), data_(::operator new (static_cast<std::size_t>(bytes), std::align_val_t{64})) {}
  void* data() const { return data_.get(); }
  std::int64_t size() const { return bytes_; }

 private:
  struct Delete {
    void operator()(void* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  std::int64_t bytes_;
  std::unique_ptr<void, Delete> data_;
};

/// A result, or what vesica_strerror says of it.
inline std::int64_t checked(std::int64_t result) {
  if (result < 0) throw std::invalid_argument(vesica_strerror(static_cast<std::int32_t>(result)));
  return result;
}

/// Parts into which work is divided among threads: more than there are, so that none waits long for another.
inline constexpr std::int64_t parts = 64;

/// Runs task(part), which returns a result of the library, for all parts. Throws for the first part with an error.
template <class Run, class Task>
void run_parts(const Run& run, const Task& task) {
  std::array<std::int64_t, parts> results{};
  run(parts, [&](std::int64_t part) { results[static_cast<std::size_t>(part)] = task(part); });
  for (const std::int64_t result : results) checked(result);
}

}  // namespace index_face

/// An executor: runs tasks on some threads, all that there are unless told otherwise. In its place, any object will do
/// that calls task(0) to task(parts - 1) when it is called with parts and a task, at once or in turn, and then returns.
class Threads {
 public:
  explicit Threads(std::size_t count = std::thread::hardware_concurrency()) : count_(std::max<std::size_t>(count, 1)) {}

  template <class Task>
  void operator()(std::int64_t parts, const Task& task) const {
    std::atomic<std::int64_t> next{0};
    const auto work = [&] {
      for (std::int64_t part = next++; part < parts; part = next++) task(part);
    };
    struct Others {
      std::vector<std::thread> threads;
      ~Others() {
        for (std::thread& t : threads) t.join();
      }
    } others;
    others.threads.reserve(count_ - 1);
    for (std::size_t i = 1; i < count_; ++i) others.threads.emplace_back(work);
    work();
  }

 private:
  std::size_t count_;
};

/// The descriptor of an array of shapes, as vesica_rect_f64.
template <class Array>
auto shapes(const Array& array) {
  const std::span all(array);
  using Struct = typename decltype(all)::value_type;
  using Functions = index_face::Functions<typename index_face::Shape<Struct>::Scalar>;
  typename Functions::Shapes out;
  index_face::checked(
      Functions::from_records(index_face::Shape<Struct>::kind, std::ssize(all), all.data(), sizeof(Struct), &out));
  return out;
}

/// An index of one or more sets of shapes. Invalid shapes are left out; has_invalid() says whether there were any.
/// A question's shape is a struct of vesica.h or of the core, or the descriptor of an array of one.
template <class T>
class Index {
  using F = index_face::Functions<T>;

 public:
  using Shapes = typename F::Shapes;
  using Impact = typename F::Impact;
  using Turn = typename F::Turn;

  explicit Index(std::span<const Shapes> sets) : sets_(sets.begin(), sets.end()), memory_(size_for(sets)) { build(); }
  explicit Index(std::initializer_list<Shapes> sets) : Index(std::span<const Shapes>(sets.begin(), sets.size())) {}
  /// Built by an executor, such as Threads: the same bytes.
  template <class Run>
  requires std::is_invocable_v<const Run&, std::int64_t, void (*)(std::int64_t)> Index(std::span<const Shapes> sets,
                                                                                       const Run& run)
      : sets_(sets.begin(), sets.end()), memory_(size_for(sets)) {
    build(run);
  }
  template <class Run>
  requires std::is_invocable_v<const Run&, std::int64_t, void (*)(std::int64_t)> Index(
      std::initializer_list<Shapes> sets, const Run& run)
      : Index(std::span<const Shapes>(sets.begin(), sets.size()), run) {}
  /// A copy of the bytes of an index of the same sets, from wherever they come: they are checked.
  Index(std::span<const Shapes> sets, std::span<const std::byte> saved)
      : sets_(sets.begin(), sets.end()), memory_(std::ssize(saved)) {
    if (!saved.empty()) std::memcpy(memory_.data(), saved.data(), saved.size());
    index_face::checked(vesica_index_check(memory_.data(), memory_.size()));
  }

  const void* data() const { return memory_.data(); }
  /// The bytes to save.
  std::span<const std::byte> bytes() const {
    const auto size = static_cast<std::size_t>(vesica_index_bytes(data()));
    return {static_cast<const std::byte*>(data()), size};
  }
  std::int64_t count() const { return vesica_index_count(data()); }
  bool has_invalid() const { return vesica_index_order(data(), nullptr, 0) < count(); }
  const Shapes* sets() const { return sets_.data(); }
  std::int32_t set_count() const { return static_cast<std::int32_t>(sets_.size()); }

  /// Items in spatial order.
  std::vector<std::int64_t> order() const {
    std::vector<std::int64_t> items(static_cast<std::size_t>(vesica_index_order(data(), nullptr, 0)));
    vesica_index_order(data(), items.data(), static_cast<std::int64_t>(items.size()));
    return items;
  }

  /// Items that overlap a shape.
  template <class One>
  std::vector<std::int64_t> overlapping(const One& one) const {
    const Shapes asked = array_of(one);
    return all([&](std::int64_t* out, std::int64_t capacity, std::int64_t* state) {
      return F::select(data(), sets(), set_count(), &asked, out, capacity, state);
    });
  }

  /// The k items nearest to a shape, at most `within` away, each with its distance.
  template <class One>
  std::vector<std::pair<std::int64_t, T>> nearest(const One& one, std::int64_t k,
                                                  T within = std::numeric_limits<T>::infinity()) const {
    const Shapes asked = array_of(one);
    const auto room = static_cast<std::size_t>(std::max<std::int64_t>(k, 0));
    std::vector<std::int64_t> items(room);
    std::vector<T> distance(room);
    const auto n =
        index_face::checked(F::nearest(data(), sets(), set_count(), &asked, k, within, items.data(), distance.data()));
    std::vector<std::pair<std::int64_t, T>> found;
    if (k == 0) return found;  // n is how many there are
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found.emplace_back(items[i], distance[i]);
    return found;
  }

  /// Items that a shape touches as it moves, at (vx, vy) t for t from 0 to t_end.
  template <class One>
  std::vector<std::int64_t> touched(const One& one, T vx, T vy, T t_end = std::numeric_limits<T>::infinity()) const {
    const Shapes asked = array_of(one);
    return all([&](std::int64_t* out, std::int64_t capacity, std::int64_t* state) {
      return F::cast(data(), sets(), set_count(), &asked, vx, vy, t_end, out, capacity, state);
    });
  }

  /// The item that it touches first, and when and where.
  template <class One>
  std::optional<std::pair<std::int64_t, Impact>> first_touched(const One& one, T vx, T vy,
                                                               T t_end = std::numeric_limits<T>::infinity()) const {
    const Shapes asked = array_of(one);
    Impact impact;
    const auto item = index_face::checked(F::cast_first(data(), sets(), set_count(), &asked, vx, vy, t_end, &impact));
    if (item == count()) return std::nullopt;
    return std::pair(item, impact);
  }

  /// A contact of a shape that turns: there is none before impact.t. `answer`: VESICA_CAST_HIT, _NEAR or _START. `gap`:
  /// the distance at that time, at most.
  struct TurningContact {
    std::int64_t item;
    Impact impact;
    T gap;
    std::int32_t answer;
  };

  /// The item that a shape touches first as it moves and turns, for t from 0 to 1: vesica_index_impact_time_f64.
  template <class One>
  std::optional<TurningContact> first_touched(const One& one, const Turn& turn, T tolerance) const {
    const Shapes asked = array_of(one);
    TurningContact found;
    found.item = index_face::checked(F::impact_time(data(), sets(), set_count(), &asked, &turn, tolerance,
                                                    &found.impact, &found.gap, &found.answer));
    if (found.item == count()) return std::nullopt;
    return found;
  }

 private:
  static const Shapes& array_of(const Shapes& one) { return one; }
  template <class One>
  static Shapes array_of(const One& one) {
    return shapes(std::span(&one, 1));
  }

  /// All items that a call finds some at a time.
  template <class Call>
  static std::vector<std::int64_t> all(const Call& call) {
    std::vector<std::int64_t> items;
    std::array<std::int64_t, 256> some;
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) {
      const auto n = index_face::checked(call(some.data(), std::ssize(some), state));
      items.insert(items.end(), some.begin(), some.begin() + n);
    }
    return items;
  }

  static std::int64_t items_of(std::span<const Shapes> sets) {
    std::int64_t items = 0;
    for (const Shapes& set : sets) items += set.count;
    return items;
  }
  static std::int64_t size_for(std::span<const Shapes> sets) {
    return index_face::checked(vesica_index_size(items_of(sets)));
  }
  void build() {
    const index_face::Memory scratch(index_face::checked(vesica_index_scratch(items_of(sets_))));
    const auto result = F::build(sets(), set_count(), memory_.data(), memory_.size(), scratch.data(), scratch.size());
    if (result != VESICA_E_SHAPE) index_face::checked(result);
  }
  template <class Run>
  void build(const Run& run) {
    const index_face::Memory scratch(index_face::checked(vesica_index_scratch(items_of(sets_))));
    const auto step = [&](std::int32_t number, std::int64_t part, std::int64_t parts) {
      const std::int64_t result = F::step(number, part, parts, sets(), set_count(), memory_.data(), memory_.size(),
                                          scratch.data(), scratch.size());
      return result == VESICA_E_SHAPE ? 0 : result;
    };
    index_face::checked(step(0, 0, 1));
    for (const std::int32_t number : {1, 2, 3}) {
      index_face::run_parts(run, [&](std::int64_t part) { return step(number, part, index_face::parts); });
    }
    index_face::checked(step(4, 0, 1));
  }

  std::vector<Shapes> sets_;
  index_face::Memory memory_;
};

/// The pairs of two indexes, or of one with itself, for a range-based for: fetched a few thousand at a time. It refers
/// to the indexes, which must outlive it and stay where they are.
template <class T>
class Pairs {
 public:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  Pairs(const Index<T>& a, const Index<T>& b, std::int32_t query)
      : a_(a), b_(b), query_(query), scratch_(vesica_join_scratch()) {}
  /// Pairs at most a distance apart.
  Pairs(const Index<T>& a, const Index<T>& b, T distance) : a_(a), b_(b), within_(distance), scratch_(0) {}

  class Iterator {
   public:
    using value_type = Pair;
    using difference_type = std::ptrdiff_t;
    explicit Iterator(Pairs& pairs) : pairs_(&pairs) { pairs_->fetch(); }
    Pair operator*() const { return {pairs_->first_[pairs_->at_], pairs_->second_[pairs_->at_]}; }
    Iterator& operator++() {
      if (++pairs_->at_ == pairs_->count_) pairs_->fetch();
      return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t) const { return pairs_->at_ == pairs_->count_; }

   private:
    Pairs* pairs_;
  };
  /// Starts the loop again; only one loop at a time.
  Iterator begin() {
    for (std::int64_t& s : state_) s = 0;
    return Iterator(*this);
  }
  std::default_sentinel_t end() const { return {}; }

  /// How many there are.
  std::int64_t count() { return index_face::checked(call(0, 1, scratch_, nullptr, nullptr, 0, nullptr)); }

  /// All of them, found by an executor such as Threads, in the order of the loop.
  template <class Run>
  std::vector<Pair> all(const Run& run) const {
    std::array<std::vector<Pair>, index_face::parts> found;
    index_face::run_parts(run, [&](std::int64_t part) {
      const index_face::Memory scratch(scratch_.size());
      std::array<std::int64_t, 2048> first, second;
      std::vector<Pair>& pairs = found[static_cast<std::size_t>(part)];
      std::int64_t state[4] = {0, 0, 0, 0}, n = 0;
      while (state[0] != -1 && n >= 0) {
        n = call(part, index_face::parts, scratch, first.data(), second.data(), std::ssize(first), state);
        for (std::size_t i = 0; n > 0 && i < static_cast<std::size_t>(n); ++i) pairs.emplace_back(first[i], second[i]);
      }
      return n;
    });
    std::vector<Pair> pairs;
    for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
    return pairs;
  }

 private:
  std::int64_t call(std::int64_t part, std::int64_t parts, const index_face::Memory& scratch, std::int64_t* first,
                    std::int64_t* second, std::int64_t capacity, std::int64_t* state) const {
    using F = index_face::Functions<T>;
    if (within_) {
      return F::join_within(a_.data(), a_.sets(), a_.set_count(), b_.data(), b_.sets(), b_.set_count(), *within_, part,
                            parts, first, second, capacity, state);
    }
    return F::join(query_, a_.data(), a_.sets(), a_.set_count(), b_.data(), b_.sets(), b_.set_count(), part, parts,
                   scratch.data(), scratch.size(), first, second, capacity, state);
  }
  void fetch() {
    at_ = count_ = 0;
    while (count_ == 0 && state_[0] != -1) {
      count_ = static_cast<std::size_t>(
          index_face::checked(call(0, 1, scratch_, first_.data(), second_.data(), std::ssize(first_), state_)));
    }
  }

  const Index<T>& a_;
  const Index<T>& b_;
  std::int32_t query_ = VESICA_JOIN_OVERLAP;
  std::optional<T> within_;
  index_face::Memory scratch_;
  std::array<std::int64_t, 2048> first_, second_;
  std::size_t at_ = 0, count_ = 0;
  std::int64_t state_[4] = {0, 0, 0, 0};
};

template <class T>
Pairs<T> pairs(const Index<T>& a, const Index<T>& b, std::int32_t query = VESICA_JOIN_OVERLAP) {
  return Pairs<T>(a, b, query);
}
/// Pairs a < b of one index.
template <class T>
Pairs<T> pairs(const Index<T>& a) {
  return Pairs<T>(a, a, VESICA_JOIN_OVERLAP);
}

/// Pairs at most a distance apart; a negative one asks for a depth.
template <class T>
Pairs<T> pairs_within(const Index<T>& a, const Index<T>& b, std::type_identity_t<T> distance) {
  return Pairs<T>(a, b, distance);
}

/// The items of an index that are nearest to each of some shapes, k in a row.
template <class T>
struct NearestOfEach {
  std::int64_t k;
  std::vector<std::int64_t> item;  // -1 where there are fewer
  std::vector<T> distance;         // infinite there

  std::span<const std::int64_t> items_of(std::size_t i) const {
    const auto length = static_cast<std::size_t>(k);
    return {item.data() + i * length, length};
  }
};

/// For all items of `of`, by an executor such as Threads.
template <class T, class Run>
NearestOfEach<T> nearest_of_each(const Index<T>& of, const Index<T>& index, std::int64_t k, const Run& run,
                                 std::type_identity_t<T> within = std::numeric_limits<T>::infinity()) {
  const auto size = static_cast<std::size_t>(std::max<std::int64_t>(of.count() * k, 0));
  NearestOfEach<T> found{k, std::vector<std::int64_t>(size), std::vector<T>(size)};
  index_face::run_parts(run, [&](std::int64_t part) {
    const std::int64_t result = index_face::Functions<T>::join_nearest(
        of.sets(), of.set_count(), index.data(), index.sets(), index.set_count(), k, within, part, index_face::parts,
        found.item.data(), found.distance.data());
    return result == VESICA_E_SHAPE ? 0 : result;  // rows of invalid shapes are empty
  });
  return found;
}

}  // namespace vesica
