// SPDX-License-Identifier: Apache-2.0
/// The questions asked and the faults found; a file keeps them from one run to the next.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "stress/laws.hpp"

namespace stress {

class Progress {
 public:
  std::uint64_t seed = 0, next_group = 0, pairs = 0;

  /// Cases asked, by query; those that the slow references judged too.
  std::map<Query, std::uint64_t> asked, slow;
  /// Broken promises by law.
  std::map<std::string, std::uint64_t> faults;

  /// False where there is no such file; throws where it cannot be read as one.
  bool load(const std::string& file);
  void save(const std::string& file) const;

  /// Counts by query, and faults by law with their number in a million cases of the query.
  void report(const std::map<std::string, bool>& known) const;
};

}  // namespace stress
