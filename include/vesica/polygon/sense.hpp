// SPDX-License-Identifier: Apache-2.0
/// The side of a ring's edges on which the inside is. Rings come in any order and direction; the even-odd rule decides.
#pragma once

#include <cstring>
#include <optional>
#include <vesica/polygon/inside.hpp>

namespace vesica::detail::polygon {

/// The sign of the turn from the direction of e to the direction of f, exact.
VESICA_COLD inline int exact_turn(const Edge& e, const Edge& f) noexcept {
  using exact::from_double;
  const auto difference = [](double to, double from) { return from_double(to) - from_double(from); };
  return (difference(e.x1, e.x0) * difference(f.y1, f.y0) - difference(e.y1, e.y0) * difference(f.x1, f.x0)).sign;
}

/// Does the ray to the right cross f, from the point of e just behind its first vertex? e must not be level. Edges that
/// touch e there are left or right of that point by their directions.
inline bool crosses_ray_behind(const Edge& e, const Edge& f) noexcept {
  const bool rises = e.y1 > e.y0;
  const auto above = [&](double y) { return y > e.y0 || (y == e.y0 && !rises); };
  if (above(f.y0) == above(f.y1)) return false;
  int s = side(e.x0, e.y0, f);
  if (s == 0) s = -exact_turn(e, f);
  return f.y1 > f.y0 ? s > 0 : s < 0;
}

/// The sense of each ring: 1 if the inside is on the left of its edges, -1 on the right. Each is found when it is first
/// asked for; those of the first rings are kept. Of a single ring it is 1: its area is positive, whatever the sign of
/// the sum of its terms.
template <class T>
class Senses {
 public:
  explicit Senses(const Edges<T>& edges) noexcept : edges_(edges), single_(edges.rings() == 1) {
    if (single_) {
      last_ = edges.all();
      return;
    }
    blocks_.emplace(edges, edges.all(), [](const Box&) { return true; });
    std::memset(known_, 0, sizeof known_);
  }

  double of_ring(std::int64_t j) noexcept {
    if (single_) return 1;
    if (j >= kept) return found(j);
    const std::uint8_t bit = static_cast<std::uint8_t>(1u << (j % 4)), negative = static_cast<std::uint8_t>(bit << 4);
    std::uint8_t& byte = known_[j / 4];
    if ((byte & bit) == 0) byte |= static_cast<std::uint8_t>(found(j) < 0 ? bit | negative : bit);
    return (byte & negative) != 0 ? -1 : 1;
  }
  /// Calls visit(edge, sense) for each edge of a polygon that begins in a range.
  template <class Visit>
  VESICA_INLINE void for_edges(const Range& range, const Visit& visit) noexcept {
    for (std::int64_t i = range.first; i < range.last;) {
      const double sense = of_vertex(i);
      const std::int64_t last = std::min(range.last, last_.last);
      Point<double> from = edges_.vertex(i);
      for (; i < last; ++i) {
        const Point<double> to = edges_.vertex(i + 1 == last_.last ? last_.first : i + 1);
        visit(Edge{from.x, from.y, to.x, to.y}, sense);
        from = to;
      }
    }
  }

 private:
  /// Returns the sense of the ring that has vertex i, and remembers that ring.
  double of_vertex(std::int64_t i) noexcept {
    if (i < last_.first || i >= last_.last) {
      // The last ring that begins at or before the vertex.
      std::int64_t low = 0, high = edges_.rings();
      while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (edges_.ring(middle).first <= i ? low : high) = middle;
      }
      last_ = edges_.ring(low);
      sense_ = of_ring(low);
    }
    return sense_;
  }

  static constexpr std::int64_t kept = 32768;

  /// By the edges on the right of a point of the ring, of all rings: from an odd number on, the inside is there.
  double found(std::int64_t j) const noexcept {
    Edge e{};
    if (!edges_.for_edges(edges_.ring(j), [&](const Edge& edge, std::int64_t) {
          e = edge;
          return e.y0 != e.y1;
        })) {
      return 1;
    }
    bool odd = false;
    for (int i = 0; i < blocks_->count; ++i) {
      const Box& box = blocks_->box[i];
      if (e.y0 < box.min_y || e.y0 > box.max_y || e.x0 > box.max_x) continue;
      edges_.for_edges(blocks_->range(i), [&](const Edge& f, std::int64_t) {
        odd ^= crosses_ray_behind(e, f);
        return false;
      });
    }
    return odd == (e.y1 > e.y0) ? -1 : 1;
  }

  const Edges<T>& edges_;
  bool single_;
  Range last_{0, 0};
  double sense_ = 1;
  std::optional<Blocks> blocks_;
  std::uint8_t known_[kept / 4];  // of four rings each: is it known, and is it negative
};

}  // namespace vesica::detail::polygon
