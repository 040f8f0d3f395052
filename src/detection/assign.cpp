// SPDX-License-Identifier: Apache-2.0
#include "detection/assign.hpp"

#include <algorithm>

#include "join/ranked.hpp"

namespace vesica::detection {

namespace {

using index::Ranked;

std::int64_t words_of(std::int64_t bits) noexcept { return (bits + 63) / 64; }

void take(std::uint64_t* bits, std::int64_t i) noexcept { bits[i / 64] |= std::uint64_t{1} << (i % 64); }
/// Sorts entries of equal values by row, column and number.
void sort_ties(const std::int64_t* row, const std::int64_t* column, Ranked* begin, Ranked* end) noexcept {
  std::sort(begin, end, [=](const Ranked& p, const Ranked& q) {
    const std::uint32_t i = p.place, j = q.place;
    if (row[i] != row[j]) return row[i] < row[j];
    if (column[i] != column[j]) return column[i] < column[j];
    return i < j;
  });
}

bool is_taken(const std::uint64_t* bits, std::int64_t i) noexcept { return (bits[i / 64] >> (i % 64) & 1) != 0; }

}  // namespace

std::int64_t assignment_bytes(std::int64_t count, std::int64_t rows, std::int64_t columns) noexcept {
  return 2 * count * static_cast<std::int64_t>(sizeof(Ranked)) + 8 * (words_of(rows) + words_of(columns));
}

template <class T>
std::int64_t assign_greedily(const Entries<T>& entries, void* scratch, std::int64_t* chosen) noexcept {
  auto* ranked = static_cast<Ranked*>(scratch);
  Ranked* const spare = ranked + entries.count;
  auto* const rows = reinterpret_cast<std::uint64_t*>(spare + entries.count);
  std::uint64_t* const columns = rows + words_of(entries.rows);
  std::fill_n(rows, words_of(entries.rows) + words_of(entries.columns), std::uint64_t{0});
  std::int64_t n = 0;
  for (std::int64_t k = 0; k < entries.count; ++k) {
    const auto value = static_cast<double>(entries.value[k]);
    ranked[n] = {index::key_of(value), static_cast<std::uint32_t>(k)};
    n += value == value;
  }
  ranked = index::sort_ranked(ranked, spare, n);
  for (std::int64_t i = 0; i < n;) {
    std::int64_t end = i + 1;
    while (end < n && ranked[end].key == ranked[i].key) ++end;
    if (end - i > 1) sort_ties(entries.row, entries.column, ranked + i, ranked + end);
    i = end;
  }
  std::int64_t matches = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    const std::uint32_t k = ranked[i].place;
    if (is_taken(rows, entries.row[k]) || is_taken(columns, entries.column[k])) continue;
    take(rows, entries.row[k]);
    take(columns, entries.column[k]);
    chosen[matches++] = k;
  }
  return matches;
}
template std::int64_t assign_greedily(const Entries<double>&, void*, std::int64_t*) noexcept;
template std::int64_t assign_greedily(const Entries<float>&, void*, std::int64_t*) noexcept;

}  // namespace vesica::detection
