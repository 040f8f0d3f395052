// SPDX-License-Identifier: Apache-2.0
#include "boundary_distance/reference.hpp"
#include "nearest/outline_columns.hpp"
#include "nearest/outline_report.hpp"

namespace vesica::bench {
namespace {

vesica_penetration_f64 ask(const OutlineRow& row, const OutlinePair& p) {
  vesica_penetration_f64 out{};
  vesica_depth_f64(row.kind_a, p.a.data(), row.kind_b, p.b.data(), &out);
  return out;
}

/// In roundoffs of the scale.
double error(const OutlineRow& row, const OutlinePair& p) {
  namespace reference = outline_reference;
  const auto a = reference::shape(row.kind_a, p.a), b = reference::shape(row.kind_b, p.b);
  const auto least = reference::least(a, b, 1).value;
  return std::fabs(reference::error_in_roundoffs(ask(row, p).depth, least, reference::scale(a, b)));
}

void report(std::FILE* out, const OutlineRow& row) {
  const auto pairs = draw_pairs(row.kind_a, row.kind_b, row.relative, row.aspect, pairs_timed);
  const double time = nanoseconds(pairs, [&](const OutlinePair& p) {
    const auto d = ask(row, p);
    return d.depth + d.x;
  });
  const double batch_time =
      batch_nanoseconds(OutlineColumns(row.kind_a, row.kind_b, pairs), [](const auto& a, const auto& b, auto& columns) {
        vesica_depth_many_f64(&a, &b, columns[0].data(), columns[1].data(), columns[2].data());
      });
  double worst = 0;
  for (std::size_t i = 0; i < pairs_checked; ++i) worst = std::fmax(worst, error(row, pairs[i]));
  print_row(out, row, {time, batch_time, worst});
}

}  // namespace

void report_depth(std::FILE* out) {
  print_head(out, "vesica_depth_f64");
  report(out, {VESICA_RECT, VESICA_RECT, Relative::overlapping, 20});
  report(out, {VESICA_RECT, VESICA_ELLIPSE, Relative::overlapping, 20});
  report(out, {VESICA_CIRCLE, VESICA_ELLIPSE, Relative::overlapping, 20});
  for (const double aspect : {20., 1e3, 1e6}) {
    report(out, {VESICA_ELLIPSE, VESICA_ELLIPSE, Relative::overlapping, aspect});
  }
}

}  // namespace vesica::bench
