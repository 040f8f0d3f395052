// SPDX-License-Identifier: Apache-2.0
#include "boundary_distance/reference.hpp"
#include "nearest/outline_columns.hpp"
#include "nearest/outline_report.hpp"

namespace vesica::bench {
namespace {

vesica_closest_points_f64 ask(const OutlineRow& row, const OutlinePair& p) {
  vesica_closest_points_f64 out{};
  vesica_boundary_distance_f64(row.kind_a, p.a.data(), row.kind_b, p.b.data(), &out);
  return out;
}

/// In roundoffs of the scale. Of crossing outlines, how far the common point is off either.
double error(const OutlineRow& row, const OutlinePair& p) {
  namespace reference = outline_reference;
  const vesica_closest_points_f64 c = ask(row, p);
  const auto a = reference::shape(row.kind_a, p.a), b = reference::shape(row.kind_b, p.b);
  const double scale = reference::scale(a, b), unit = 0x1p-53 * scale;
  if (row.relative == Relative::crossing) {
    return std::fmax(reference::distance_from_outline(a, c.ax, c.ay), reference::distance_from_outline(b, c.bx, c.by)) /
           unit;
  }
  // Disjoint shapes are as far apart as they overlap less.
  const bool nested = row.relative == Relative::nested;
  const auto least = reference::least(a, b, nested ? -1 : 1).value;
  return std::fabs(reference::error_in_roundoffs(nested ? c.distance : -c.distance, least, scale));
}

void report(std::FILE* out, const OutlineRow& row) {
  const auto pairs = draw_pairs(row.kind_a, row.kind_b, row.relative, row.aspect, pairs_timed);
  const double time = nanoseconds(pairs, [&](const OutlinePair& p) {
    const auto c = ask(row, p);
    return c.distance + c.ax;
  });
  const double batch_time =
      batch_nanoseconds(OutlineColumns(row.kind_a, row.kind_b, pairs), [](const auto& a, const auto& b, auto& c) {
        vesica_boundary_distance_many_f64(&a, &b, c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data());
      });
  double worst = 0;
  for (std::size_t i = 0; i < pairs_checked; ++i) worst = std::fmax(worst, error(row, pairs[i]));
  print_row(out, row, {time, batch_time, worst});
}

}  // namespace

void report_boundary_distance(std::FILE* out) {
  print_head(out, "vesica_boundary_distance_f64");
  for (const Relative relative : {Relative::nested, Relative::disjoint, Relative::crossing}) {
    report(out, {VESICA_RECT, VESICA_RECT, relative, 20});
    report(out, {VESICA_RECT, VESICA_ELLIPSE, relative, 20});
    report(out, {VESICA_ELLIPSE, VESICA_RECT, relative, 20});
    report(out, {VESICA_ELLIPSE, VESICA_CIRCLE, relative, 20});
    for (const double aspect : {20., 1e3, 1e6}) report(out, {VESICA_ELLIPSE, VESICA_ELLIPSE, relative, aspect});
  }
}

}  // namespace vesica::bench
