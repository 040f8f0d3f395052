// SPDX-License-Identifier: Apache-2.0
#include "stress/progress.hpp"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace stress {

bool Progress::load(const std::string& file) {
  std::ifstream in(file);
  if (!in) return false;
  std::string key, what;
  while (in >> key) {
    std::uint64_t number = 0;
    if (key == "asked" || key == "slow" || key == "faults") in >> what;
    if (!(in >> number)) throw std::runtime_error(file + ": not a file of the stress test's");
    if (key == "seed") seed = number;
    if (key == "next_group") next_group = number;
    if (key == "pairs") pairs = number;
    if (key == "faults") faults[what] = number;
    const auto query = find_query(what);
    if (key == "asked" && query) asked[*query] = number;
    if (key == "slow" && query) slow[*query] = number;
  }
  return true;
}

void Progress::save(const std::string& file) const {
  const std::string fresh = file + ".new";
  {
    std::ofstream out(fresh);
    out << "seed " << seed << "\nnext_group " << next_group << "\npairs " << pairs << '\n';
    for (const auto& [query, count] : asked) out << "asked " << name(query) << ' ' << count << '\n';
    for (const auto& [query, count] : slow) out << "slow " << name(query) << ' ' << count << '\n';
    for (const auto& [law, count] : faults) out << "faults " << law << ' ' << count << '\n';
    if (!out) throw std::runtime_error("cannot write " + fresh);
  }
  if (std::rename(fresh.c_str(), file.c_str()) != 0) throw std::runtime_error("cannot write " + file);
}

void Progress::report(const std::map<std::string, bool>& known) const {
  std::printf("seed %" PRIu64 ": %" PRIu64 " groups, %" PRIu64 " pairs\n", seed, next_group, pairs);
  for (const auto& [query, count] : asked) {
    const auto found = slow.find(query);
    std::printf("  %-18s %12" PRIu64 " asked, %10" PRIu64 " of them against a slow reference\n", name(query), count,
                found != slow.end() ? found->second : 0);
  }
  for (const auto& [law, count] : faults) {
    const auto query = find_query(law.substr(0, law.find('.')));
    const double of = query && asked.contains(*query) ? static_cast<double>(asked.at(*query)) : 1;
    std::printf("  %-46s %8" PRIu64 " faults, %9.2f in a million%s\n", law.c_str(), count,
                1e6 * static_cast<double>(count) / of, known.contains(law) ? ", known" : "");
  }
}

}  // namespace stress
