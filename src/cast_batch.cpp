// SPDX-License-Identifier: Apache-2.0
// Casts of arrays, a block at a time: a kernel decides most misses, another finds most first contacts, and the rest are
// asked as single pairs.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vesica/cast.hpp>
#include <vesica/cast/before.hpp>

#include "kernels/cast_columns.hpp"
#include "number_columns.hpp"
#include "polygon/arrays.hpp"
#include "queries/cast.hpp"

namespace vesica::batch {

namespace {

using detail::cast::Body;
using detail::cast::Motion;

/// For fewer pairs the columns are not worth their while.
inline constexpr std::int64_t fewest_for_lanes = 4;

/// An invalid shape shows before anything else.
void note(std::int32_t error, std::int32_t& worst) noexcept {
  if (error < 0 && worst != error_shape) worst = error;
}

/// Element i; in step with another array, whose count of 1 repeats.
template <class Item, class T>
Item item_at(const Shapes<T>& shapes, std::int64_t i) noexcept {
  if constexpr (std::is_same_v<Item, Body>) {
    return body_at(shapes, i);
  } else {
    return {shapes, shapes.count == 1 ? 0 : i};
  }
}

bool is_valid(const Body& body) noexcept {
  return with_shape<double>(static_cast<std::int32_t>(body.kind), body.number,
                            [](const HasCore auto& s) { return check(s); }) == 0;
}

/// After a block of which the kernels decide less than a sixteenth, this many blocks are answered as single pairs: the
/// filter takes 3% of the time of a contact that it does not decide.
inline constexpr std::int32_t blocks_without = 7;

/// Numbers of listed elements side by side, in whole vectors that repeat the first; of an operand that repeats, as
/// many.
class Gathered {
 public:
  [[gnu::noinline]] void set(std::int32_t columns, const double* const* from, bool repeated, const std::int32_t* list,
                             std::int32_t n, std::int32_t end) noexcept {
    for (std::int32_t k = 0; k < columns; ++k) {
      number_[k] = room_[k];
      if (repeated) {
        std::fill(room_[k], room_[k] + end, from[k][0]);
        continue;
      }
      for (std::int32_t i = 0; i < n; ++i) room_[k][i] = from[k][list[i]];
      std::fill(room_[k] + n, room_[k] + end, room_[k][0]);
    }
  }
  void set(const NumberColumns& from, const std::int32_t* list, std::int32_t n, std::int32_t end) noexcept {
    set(field_count(from.kind()), from.numbers(), from.repeated(), list, n, end);
  }
  const double* const* numbers() const noexcept { return number_; }
  QueryOperand operand() const noexcept {
    QueryOperand out{};
    std::copy(number_, number_ + max_fields, out.number);
    return out;
  }

 private:
  const double* number_[max_fields] = {};
  double room_[max_fields][query_block];
};

/// A block of pairs and what the kernels know of them. Certain misses are left out, the others are listed.
class CastBlock {
 public:
  explicit CastBlock(const KernelTable& kernels) noexcept : kernels_(kernels), casts_(*kernels.queries->cast) {}

  template <class T>
  void set(const Shapes<T>& a, const Shapes<T>& b, const Velocities<T>& v, std::int64_t begin,
           std::int32_t n) noexcept {
    if (begin == 0 || a.stride != 0) read(a, begin, n, a_);
    if (begin == 0 || b.stride != 0) read(b, begin, n, b_);
    if (begin == 0 || v.stride != 0) {
      read(v.vx.advanced(begin * v.stride), v.stride, n, vx_);
      read(v.vy.advanced(begin * v.stride), v.stride, n, vy_);
    }
    n_ = n;
  }

  /// Asks the kernels about the block.
  void answer(double end) noexcept {
    const CastColumns columns{side_columns(a_.kind(), a_.operand()), side_columns(b_.kind(), b_.operand()), vx_, vy_,
                              end};
    std::uint8_t missed[query_block], meets[query_block];
    casts_.filter(columns, whole(n_), {missed, meets});
    const CastKernel kernel = end >= least_end ? casts_.contact[a_.kind()][b_.kind()] : nullptr;
    const std::uint8_t may_know = kernel != nullptr ? 1 : 0;
    std::int32_t known = 0, of_block[query_block];
    count_ = 0;
    for (std::int32_t i = 0; i < n_; ++i) {
      const std::int32_t met = meets[i] & may_know;
      list_[count_] = i;
      found_at_[count_] = met != 0 ? known : unknown;
      of_block[known] = i;
      known += met;
      count_ += 1 - missed[i];
    }
    if (known > 0) find(kernel, end, of_block, known);
  }

  /// A pair of the block, as read.
  Body first(std::int32_t i) const noexcept { return body(a_, i); }
  Body second(std::int32_t i) const noexcept { return body(b_, i); }
  Motion motion(std::int32_t i, double end) const noexcept { return {vx_[i], vy_[i], end}; }

  /// Pairs that are not certain misses, by their places in the block.
  std::int32_t count() const noexcept { return count_; }
  std::int32_t place(std::int32_t k) const noexcept { return list_[k]; }
  /// The first contact of the k-th of them; its time is infinite after a miss, and NaN where it is not known.
  Impact<double> found(std::int32_t k) const noexcept {
    const std::int32_t at = found_at_[k];
    if (at == unknown) return {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0};
    return {found_[0][at], found_[1][at], found_[2][at], found_[3][at], found_[4][at]};
  }

 private:
  static constexpr std::int32_t unknown = -1;
  /// The least end in detail::cast::in_early_range().
  static constexpr double least_end = 0x1p-300;

  const KernelTable& kernels_;
  const CastTable& casts_;
  std::int32_t n_ = 0, count_ = 0;
  NumberColumns a_, b_;
  Gathered near_a_, near_b_, near_v_;
  double vx_[query_block], vy_[query_block];
  std::int32_t list_[query_block], found_at_[query_block];
  double found_[5][query_block];

  static Body body(const NumberColumns& shapes, std::int32_t i) noexcept {
    Body out{static_cast<Kind>(shapes.kind()), {}};
    shapes.element(i, out.number);
    return out;
  }

  /// n in whole vectors of these kernels.
  std::int32_t whole(std::int32_t n) const noexcept {
    const std::int32_t width = kernels_.width_f64;
    return (n + width - 1) / width * width;
  }

  template <class T>
  [[gnu::noinline]] void read(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n,
                              NumberColumns& to) const noexcept {
    to.set(shapes, begin, n, kernels_);
  }
  template <class T>
  static void read(Unaligned<T> from, std::ptrdiff_t stride, std::int32_t n, double (&to)[query_block]) noexcept {
    const std::int32_t given = stride == 0 ? 1 : n;
    for (std::int32_t i = 0; i < given; ++i) to[i] = static_cast<double>(from.advanced(i * stride)[0]);
    // One that repeats does so for all blocks; whole vectors repeat the first.
    std::fill(to + given, to + (stride == 0 ? query_block : whole_vectors(n)), to[0]);
  }

  /// Finds the contacts of the listed pairs, copied side by side.
  void find(CastKernel kernel, double end, const std::int32_t* list, std::int32_t n) noexcept {
    const std::int32_t padded = whole(n);
    const double* const velocities[] = {vx_, vy_};
    near_v_.set(2, velocities, false, list, n, padded);
    near_a_.set(a_, list, n, padded);
    near_b_.set(b_, list, n, padded);
    const CastColumns asked{side_columns(a_.kind(), near_a_.operand()), side_columns(b_.kind(), near_b_.operand()),
                            near_v_.numbers()[0], near_v_.numbers()[1], end};
    double* const results[] = {found_[0], found_[1], found_[2], found_[3], found_[4]};
    kernel(asked, padded, results);
  }
};

/// The same for an element of a pair with a polygon or a polyline.
template <class T>
bool is_valid(const Element<T>& element) noexcept {
  return polygon::is_valid(element.operand());
}
template <class T>
std::int32_t cast(const Element<T>& first, const Element<T>& second, const Motion& motion, Impact<T>& impact) noexcept {
  return polygon::cast(first.operand(), second.operand(), motion, impact);
}
using queries::cast;

/// One pair, by the scalar function.
template <class T, class Item>
[[gnu::noinline]] void ask(const Item& first, const Item& second, const Motion& motion, CastTally& tally,
                           Impact<T>& impact) noexcept {
  impact = detail::cast::no_impact<T>();
  const bool moves = detail::cast::is_sound(motion);
  const std::int32_t still = moves || (is_valid(first) && is_valid(second)) ? error_argument : error_shape;
  const std::int32_t code = moves ? cast(first, second, motion, impact) : still;
  if (code < 0) impact.t = std::numeric_limits<T>::quiet_NaN();
  tally.hits += code > 0;
  note(code, tally.error);
}

template <class T>
void put(const Impact<T>& impact, std::int64_t i, T* const (&columns)[5]) noexcept {
  const T numbers[] = {impact.t, impact.x, impact.y, impact.nx, impact.ny};
  for (int k = 0; k < 5; ++k) {
    if (columns[k] != nullptr) columns[k][i] = numbers[k];
  }
}

/// Elements [begin, end) one by one; Item: Body, or Element<T> with a path.
template <class Item, class T>
[[gnu::noinline]] void ask_each(const Shapes<T>& a, const Shapes<T>& b, const Velocities<T>& v, double t_end,
                                std::int64_t begin, std::int64_t end, T* const (&columns)[5],
                                CastTally& tally) noexcept {
  for (std::int64_t i = begin; i < end; ++i) {
    const Motion motion{static_cast<double>(v.vx.advanced(i * v.stride)[0]),
                        static_cast<double>(v.vy.advanced(i * v.stride)[0]), t_end};
    Impact<T> impact;
    ask(item_at<Item>(a, i), item_at<Item>(b, i), motion, tally, impact);
    put(impact, i, columns);
  }
}

/// The answers of a block. They are written when all of it was read: an output may lie where an operand does.
template <class T>
class Answers {
 public:
  Answers() noexcept : columns_{number_[0], number_[1], number_[2], number_[3], number_[4]} {}
  void set_misses(std::int32_t n) noexcept {
    const Impact<T> none = detail::cast::no_impact<T>();
    for (int k = 0; k < 5; ++k) std::fill_n(number_[k], n, k == 0 ? none.t : none.x);
  }
  void set(std::int32_t i, const Impact<T>& impact) noexcept { put(impact, i, columns_); }
  void write(std::int64_t begin, std::int32_t n, T* const (&columns)[5]) const noexcept {
    for (int k = 0; k < 5; ++k) {
      if (columns[k] != nullptr) std::memcpy(columns[k] + begin, number_[k], static_cast<std::size_t>(n) * sizeof(T));
    }
  }

 private:
  T number_[5][query_block];
  T* const columns_[5];
};

/// Answers a block that was read. Returns how many pairs were asked as single ones.
template <class T>
std::int32_t answer_block(CastBlock& block, double end, std::int32_t n, Answers<T>& answers,
                          CastTally& tally) noexcept {
  block.answer(end);
  answers.set_misses(n);
  std::int32_t asked = 0;
  for (std::int32_t k = 0; k < block.count(); ++k) {
    const std::int32_t i = block.place(k);
    const Impact<double> found = block.found(k);
    Impact<T> impact;
    if (found.t == std::numeric_limits<double>::infinity()) continue;
    if (!std::isnan(found.t) && detail::cast::rounded_to(found, impact)) {
      ++tally.hits;
    } else {
      ask(block.first(i), block.second(i), block.motion(i, end), tally, impact);
      ++asked;
    }
    answers.set(i, impact);
  }
  return asked;
}

template <class T>
void cast_many_in_lanes(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, const Velocities<T>& v, double end,
                        T* const (&columns)[5], CastTally& tally) noexcept {
  CastBlock block(kernels());
  Answers<T> answers;
  std::int32_t blocks_to_ask = 0;
  for (std::int64_t begin = 0; begin < n; begin += query_block) {
    const std::int32_t length = block_length(n - begin, query_block);
    if (blocks_to_ask > 0) {
      --blocks_to_ask;
      ask_each<Body>(a, b, v, end, begin, begin + length, columns, tally);
      continue;
    }
    block.set(a, b, v, begin, length);
    const std::int32_t asked = answer_block(block, end, length, answers, tally);
    answers.write(begin, length, columns);
    if (16 * (length - asked) < length) blocks_to_ask = blocks_without;
  }
}

/// The earliest so far, and the shape that moves.
template <class T, class Item>
struct FirstSearch {
  const Shapes<T>& many;
  Item moving;
  Motion motion;
  FirstHit first;
  Impact<T> best;

  bool some() const noexcept { return first.index != many.count; }
  /// Contact later than the best so far is a miss.
  double end() const noexcept { return some() ? static_cast<double>(best.t) : motion.end; }
  void take(std::int64_t i, const Impact<T>& impact) noexcept {
    if (some() && (impact.t > best.t || (impact.t == best.t && i > first.index))) return;
    best = impact;
    first.index = i;
  }
  /// Element i, by the scalar function.
  [[gnu::noinline]] void ask(std::int64_t i, const Item& still, double end) noexcept {
    Impact<T> impact;
    const std::int32_t code = detail::cast::cast_before(end, motion.end, [&](double until) {
      return cast(still, moving, {motion.vx, motion.vy, until}, impact);
    });
    note(code, first.error);
    if (code > 0) take(i, impact);
  }
  /// A pair that was undecided before the earliest hit was found may come after it.
  void settle() noexcept {
    if (first.error != error_range || !some()) return;
    first.error = 0;
    for (std::int64_t i = 0; i < many.count; ++i) {
      // Among equal times the first element counts. Contact before the next number has the time of the best.
      const auto next = static_cast<double>(detail::arithmetic::next_above(best.t));
      ask(i, item_at<Item>(many, i), i > first.index ? end() : next < motion.end ? next : motion.end);
    }
  }
};

template <class T>
void cast_first_in_lanes(const Shapes<T>& one, FirstSearch<T, Body>& search) noexcept {
  const Shapes<T>& many = search.many;
  const T vx = static_cast<T>(search.motion.vx), vy = static_cast<T>(search.motion.vy);
  const Velocities<T> v{Unaligned<T>(&vx), Unaligned<T>(&vy), 0};
  CastBlock block(kernels());
  for (std::int64_t begin = 0; begin < many.count; begin += query_block) {
    block.set(many, element(one, 0), v, begin, block_length(many.count - begin, query_block));
    block.answer(search.end());
    for (std::int32_t k = 0; k < block.count(); ++k) {
      const std::int64_t i = begin + block.place(k);
      const Impact<double> found = block.found(k);
      Impact<T> impact;
      if (found.t == std::numeric_limits<double>::infinity()) continue;
      if (!std::isnan(found.t) && detail::cast::rounded_to(found, impact)) {
        search.take(i, impact);
      } else {
        search.ask(i, block.first(block.place(k)), search.end());
      }
    }
  }
}

[[maybe_unused]] bool in_lanes(std::int64_t n) noexcept {
  return n >= fewest_for_lanes && kernels().queries->cast != nullptr;
}

}  // namespace

template <class T>
CastTally cast_many(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, const Velocities<T>& v, double end,
                    T* const (&columns)[5]) noexcept {
  CastTally tally;
  if (has_path(a, b)) {
    ask_each<Element<T>>(a, b, v, end, 0, n, columns, tally);
    return tally;
  }
  if constexpr (has_cast_kernels) {
    if (in_lanes(n)) {
      cast_many_in_lanes(a, b, n, v, end, columns, tally);
      return tally;
    }
  }
  ask_each<Body>(a, b, v, end, 0, n, columns, tally);
  return tally;
}

template <class Item, class T>
FirstHit find_first(const Shapes<T>& many, const Shapes<T>& one, const Motion& motion, Impact<T>& out) noexcept {
  FirstSearch<T, Item> search{many, item_at<Item>(one, 0), motion, {many.count, 0}, detail::cast::no_impact<T>()};
  if (!is_valid(search.moving)) return {0, error_shape};
  bool asked = false;
  if constexpr (has_cast_kernels && std::is_same_v<Item, Body>) {
    asked = in_lanes(many.count);
    if (asked) cast_first_in_lanes(one, search);
  }
  for (std::int64_t i = asked ? many.count : 0; i < many.count; ++i) {
    search.ask(i, item_at<Item>(many, i), search.end());
  }
  search.settle();
  if (search.first.error == 0) out = search.best;
  return search.first;
}

template <class T>
FirstHit cast_first(const Shapes<T>& many, const Shapes<T>& one, const Motion& motion, Impact<T>& out) noexcept {
  return has_path(many, one) ? find_first<Element<T>>(many, one, motion, out)
                             : find_first<Body>(many, one, motion, out);
}

#define VESICA_CASTS(T)                                                                                        \
  template CastTally cast_many(const Shapes<T>&, const Shapes<T>&, std::int64_t, const Velocities<T>&, double, \
                               T* const(&)[5]) noexcept;                                                       \
  template FirstHit cast_first(const Shapes<T>&, const Shapes<T>&, const Motion&, Impact<T>&) noexcept;
VESICA_CASTS(double)
VESICA_CASTS(float)
#undef VESICA_CASTS

}  // namespace vesica::batch
