// SPDX-License-Identifier: Apache-2.0
#include "table.hpp"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <string>
#include <vector>

#include "peers/peer.hpp"
#include "quantile.hpp"
#include "row.hpp"

namespace vesica::bench {
namespace {

std::string format(const char* pattern, auto... values) {
  std::array<char, 128> text{};
  const int length = std::snprintf(text.data(), text.size(), pattern, values...);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::string nanoseconds(double value) { return format(value < 100 ? "%.2f" : "%.0f", value); }

template <class Of>
std::vector<double> over_samples(const Row& row, Of of) {
  std::vector<double> values;
  for (const Sample& sample : row.samples) values.push_back(of(sample));
  return values;
}

double library_time(const Row& row) {
  return median(over_samples(row, [](const Sample& sample) { return sample.library; }));
}

/// The ratio of each pass's two times, not of the two medians: what disturbed the machine disturbed both of a pass.
std::vector<double> ratios(const Row& row) {
  return over_samples(row, [](const Sample& sample) { return sample.library / sample.yardstick; });
}

double yardstick_time(const Row& row) {
  return median(over_samples(row, [](const Sample& sample) { return sample.yardstick; }));
}

/// The library's time above the yardstick's.
double above(const Row& row) {
  return median(over_samples(row, [](const Sample& sample) { return sample.library - sample.yardstick; }));
}

bool is_beside_short_yardstick(const Row& row) {
  return row.target.above > 0 && !row.samples.empty() && yardstick_time(row) < 5;
}

std::string target(const Row& row) {
  if (is_beside_short_yardstick(row)) return "+" + nanoseconds(row.target.above) + " ns";
  if (row.target.ratio > 0) return format("%.2f", row.target.ratio);
  if (row.target.nanoseconds > 0) return nanoseconds(row.target.nanoseconds) + " ns";
  return "";
}

std::string verdict(const Row& row) {
  if (is_beside_short_yardstick(row)) return above(row) <= row.target.above ? "met" : "MISSED";
  if (row.target.ratio > 0) return median(ratios(row)) <= row.target.ratio ? "met" : "MISSED";
  if (row.target.nanoseconds > 0) return library_time(row) <= row.target.nanoseconds ? "met" : "MISSED";
  return "";
}

std::string wrong_of(std::int64_t wrong, std::int64_t asked) { return format("%" PRId64 "/%" PRId64, wrong, asked); }

std::vector<std::string> library_cells(const Row& row) {
  if (row.samples.empty()) return {"", ""};
  return {format("%.2f", static_cast<double>(row.hits) / static_cast<double>(row.tests)),
          nanoseconds(library_time(row))};
}

std::vector<std::string> yardstick_cells(const Row& row) {
  if (!row.has_yardstick || row.samples.empty()) return {"", "", "", ""};
  const std::vector<double> all = ratios(row);
  return {nanoseconds(yardstick_time(row)), wrong_of(row.yardstick_wrong, row.yardstick_asked),
          format("%.2f", median(all)), format("%.2f-%.2f", quantile(all, 0.25), quantile(all, 0.75))};
}

std::string peer_cell(const Row& row, const std::string& name) {
  const auto peer = std::ranges::find(row.peers, name, &PeerResult::name);
  if (peer == row.peers.end()) return "";
  return nanoseconds(median(peer->nanoseconds)) + " (" + wrong_of(peer->wrong, peer->asked) + ")";
}

bool timed(const Row& row) { return !row.samples.empty() || !row.peers.empty(); }

std::vector<std::string> shown_peers() {
  std::vector<std::string> names;
  for (const Peer& peer : peers()) {
    if (std::ranges::any_of(rows(), [&](const Row& row) { return !peer_cell(row, peer.name).empty(); })) {
      names.push_back(peer.name);
    }
  }
  return names;
}

using Table = std::vector<std::vector<std::string>>;

Table make_table() {
  const std::vector<std::string> names = shown_peers();
  Table table{{"pair/scalar/workload", "hits", "vesica", "textbook", "wrong", "ratio", "quartiles", "target", ""}};
  table[0].insert(table[0].end(), names.begin(), names.end());
  for (const Row& row : rows()) {
    if (!timed(row)) continue;
    std::vector<std::string>& cells = table.emplace_back(std::vector{row.name()});
    for (const auto& part : {library_cells(row), yardstick_cells(row)})
      cells.insert(cells.end(), part.begin(), part.end());
    cells.push_back(target(row));
    cells.push_back(row.samples.empty() ? "" : verdict(row));
    for (const std::string& name : names) cells.push_back(peer_cell(row, name));
  }
  return table;
}

void print(std::FILE* out, const Table& table) {
  std::vector<int> widths(table[0].size());
  for (const auto& cells : table) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], static_cast<int>(cells[i].size()));
  }
  for (const auto& cells : table) {
    std::fprintf(out, "%-*s", widths[0], cells[0].c_str());
    for (std::size_t i = 1; i < cells.size(); ++i) std::fprintf(out, "  %*s", widths[i], cells[i].c_str());
    std::fputc('\n', out);
  }
}

}  // namespace

void print_table(std::FILE* out) {
  const Table table = make_table();
  if (table.size() == 1) return;
  std::fprintf(
      out,
      "\nNanoseconds a test, medians over passes on fresh pairs; seed %" PRIu64
      ". vesica: through the shared library,\nvalidity included. textbook: inlined here, unchecked. ratio: "
      "vesica / textbook, the median of passes timed back to\nback. wrong: answers unlike the library's. Peers "
      "as time (wrong), shapes built beforehand, ellipses as 64-gons.\n\n",
      seed_of_run());
  print(out, table);
}

}  // namespace vesica::bench
