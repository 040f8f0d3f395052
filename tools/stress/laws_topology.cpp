// SPDX-License-Identifier: Apache-2.0
// Nine-intersection matrices and shared regions: from the exact relation, the shared area, and the oracle.
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/de9im.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr double u = 0x1p-53;

std::string matrix(const Answer& r) {
  std::string m(9, 'F');
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (r.numbers[i] >= 0) m[i] = static_cast<char>('0' + static_cast<int>(r.numbers[i]));
  }
  return m;
}

std::string transposed(const std::string& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }

/// The relation that a matrix says.
std::int32_t relation_of(const std::string& m) {
  const auto none = [&](std::initializer_list<std::size_t> cells) {
    return std::all_of(cells.begin(), cells.end(), [&](std::size_t k) { return m[k] == 'F'; });
  };
  if (none({0, 1, 3, 4})) return VESICA_DISJOINT;
  const bool inside = none({2, 5}), contains = none({6, 7});
  if (inside && contains) return VESICA_EQUAL;
  if (inside) return none({1, 4}) ? VESICA_INSIDE : VESICA_INSIDE_TOUCH;
  if (contains) return none({3, 4}) ? VESICA_CONTAINS : VESICA_CONTAINS_TOUCH;
  return none({0}) ? VESICA_TOUCH : VESICA_CROSS;
}

/// The vertices' area, from the first one: less is lost than from a far origin.
double area_of(const Answer& r) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(r.code); ++i) {
    const double *first = r.numbers.data(), *v = first + 2 * i, *w = v + 2;
    twice += (v[0] - first[0]) * (w[1] - first[1]) - (v[1] - first[1]) * (w[0] - first[0]);
  }
  return twice / 2;
}

/// From the lowest, of two equally low ones the left one; what is not used is 0.
void demand_order(Judge& j, const Answer& r) {
  for (std::size_t i = 0; i < 16; i += 2) {
    const double x = r.numbers[i], y = r.numbers[i + 1];
    if (i < 2 * static_cast<std::size_t>(r.code)) {
      const bool after = y > r.numbers[1] || (y == r.numbers[1] && x >= r.numbers[0]);
      j.demand(after, "lowest_first", "not lower", text(r));
    } else {
      j.demand(x == 0 && y == 0, "unused_is_0", "0", text(r));
    }
  }
}

/// They enclose the shared area.
void demand_shared(Judge& j, const Case& c, const Answer& r) {
  const Answer area = ask(Query::area, Scalar::f64, c.pair);
  const double scale = extent(c.pair);
  if (area.code != 0 || !(scale > 0x1p-400 && scale < 0x1p400)) return;
  const double expected = area.numbers[0], got = area_of(r), room = 256 * u * scale * scale;
  j.demand(std::fabs(got - expected) <= room, "area", expected, got);
  if (expected > room) j.demand(r.code >= 3, "vertices_of_area", "3 at least", text(r));
}

/// The double's vertices, rounded. What is lowest is so by rounded numbers: they may begin elsewhere.
void demand_rounded_vertices(Judge& j, const Case& c, const Answer& narrow) {
  const Answer wide = ask({c.query, Scalar::f64, c.pair});
  if (narrow.code == VESICA_E_RANGE || wide.code == VESICA_E_RANGE) return;
  const auto count = static_cast<std::size_t>(wide.code);
  bool same = wide.code == 0;
  for (std::size_t from = 0; from < count && !same; ++from) {
    same = true;
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const double rounded = static_cast<double>(static_cast<float>(wide.numbers[(2 * from + i) % (2 * count)]));
      same = same && rounded == narrow.numbers[i];
    }
  }
  j.demand(same && narrow.code == wide.code, "float_is_double_rounded", text(wide), text(narrow));
}

}  // namespace

void judge_de9im(Judge& j, const Case& c, Effort effort) {
  const Pair& p = c.pair;
  const std::string m = matrix(ask(c)), back = matrix(ask({c.query, c.scalar, swapped(p)}));
  j.demand(transposed(m) == back, "exchanged", transposed(m), back);
  const std::int32_t relation = exact_relation(p), said = relation_of(m);
  j.demand(said == relation, "relation", std::to_string(relation), m);
  if (has_area(p.kind_a, p.a) && has_area(p.kind_b, p.b)) {
    j.demand((m[0] == '2') == (relation > VESICA_TOUCH), "shared_area", std::to_string(relation), m);
  }
  if (effort == Effort::quick || is_curved(p.kind_a, p.a) || is_curved(p.kind_b, p.b)) return;
  const std::string expected = oracle::de9im(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  j.demand(m == expected, "oracle", expected, m);
}

void judge_intersection(Judge& j, const Case& c, Effort) {
  const Answer r = ask(c), back = ask({c.query, c.scalar, swapped(c.pair)});
  j.demand(same_bits(r, back), "exchanged", text(r), text(back));
  if (r.code == VESICA_E_RANGE) return j.demand(!far_from_overflow(c.scalar, c.pair), "range", "an answer", text(r));
  j.demand((r.code > 0) == (exact_overlap(c.pair) == 1), "overlap", "vertices where they overlap", text(r));
  j.demand(r.code <= 8, "most", "8 at most", text(r));
  demand_order(j, r);
  if (c.scalar == Scalar::f32) return demand_rounded_vertices(j, c, r);
  demand_shared(j, c, r);
}

}  // namespace stress
