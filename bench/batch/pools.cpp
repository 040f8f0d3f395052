// SPDX-License-Identifier: Apache-2.0
#include "batch/pools.hpp"

#include <map>
#include <utility>

namespace vesica::bench {

const Pool& pool_of(std::int32_t kind_a, std::int32_t kind_b, Workload workload) {
  static std::pair<std::int32_t, std::int32_t> pair;
  static std::map<Workload, Pool> pools;
  if (pair != std::pair(kind_a, kind_b)) pools.clear();
  pair = {kind_a, kind_b};
  const auto known = pools.find(workload);
  if (known != pools.end()) return known->second;
  return pools[workload] = make_pool(kind_a, kind_b, workload, seed_of_run());
}

Stretch stretch_of_round(std::uint64_t round, std::size_t pool_size, std::size_t length) {
  Random random(seed_of_run() + round);
  const auto room = static_cast<double>(pool_size - length + 1);
  const auto start = [&] { return static_cast<std::size_t>(room * random.unit()); };
  const std::size_t a = start();
  return {a, start()};
}

}  // namespace vesica::bench
