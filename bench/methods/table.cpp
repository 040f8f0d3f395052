// SPDX-License-Identifier: Apache-2.0
#include "methods/table.hpp"

#include <algorithm>
#include <cinttypes>
#include <string>

namespace vesica::bench::methods {
namespace {

std::string format(const char* pattern, auto... values) {
  std::array<char, 96> text{};
  const int length = std::snprintf(text.data(), text.size(), pattern, values...);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// From 10,000 on in microseconds.
std::string nanoseconds(double value) {
  if (value >= 1e4) return format("%.0f us", value / 1000);
  return format(value < 100 ? "%.1f" : "%.0f", value);
}

/// "25.1", or with faults "25.1, 12 wrong, 3 uncertain".
std::string cell(const Outcome& outcome) {
  std::string text = nanoseconds(outcome.method);
  if (outcome.wrong > 0) text += format(", **%" PRId64 " wrong**", outcome.wrong);
  if (outcome.uncertain > 0) text += format(", %" PRId64 " uncertain", outcome.uncertain);
  return text;
}

void print_row(std::FILE* out, const std::string& name, auto cell_of) {
  std::fprintf(out, "| %s |", name.c_str());
  for (std::size_t i = 0; i < trials.size(); ++i) std::fprintf(out, " %s |", cell_of(i).c_str());
  std::fputc('\n', out);
}

/// The exact default was timed beside each method: the median of those times.
double exact_time(const std::vector<const Method*>& methods, std::size_t trial) {
  std::vector<double> times;
  for (const Method* method : methods) times.push_back(method->outcomes[trial].exact);
  std::ranges::sort(times);
  return times[times.size() / 2];
}

void print_table(std::FILE* out, const std::vector<const Method*>& methods) {
  std::fputc('\n', out);
  print_row(out, methods[0]->table, [](std::size_t i) { return std::string(name_of(trials[i])); });
  print_row(out, "---", [](std::size_t) { return std::string("---"); });
  print_row(out, "exact: " + methods[0]->exact, [&](std::size_t i) { return nanoseconds(exact_time(methods, i)); });
  for (const Method* method : methods) {
    print_row(out, method->name, [&](std::size_t i) { return cell(method->outcomes[i]); });
  }
}

}  // namespace

void print_tables(std::FILE* out, const std::vector<Method>& methods) {
  std::vector<std::string> done;
  for (const Method& first : methods) {
    if (first.outcomes.empty() || std::ranges::count(done, first.table) > 0) continue;
    done.push_back(first.table);
    std::vector<const Method*> of_pair;
    for (const Method& method : methods) {
      if (!method.outcomes.empty() && method.table == first.table) of_pair.push_back(&method);
    }
    print_table(out, of_pair);
  }
}

}  // namespace vesica::bench::methods
