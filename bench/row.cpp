// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace vesica::bench {

std::string Row::pair() const { return std::string(vesica_kind_name(kind_a)) + "_" + vesica_kind_name(kind_b); }

std::string Row::name() const { return pair() + "/" + scalar + "/" + name_of(workload); }

std::vector<Row>& rows() {
  static std::vector<Row> all;
  return all;
}

void sort_rows() {
  std::ranges::sort(rows(), {}, [](const Row& row) {
    return std::tuple(row.kind_a, row.kind_b, std::string_view(row.scalar) == "f32", row.workload);
  });
}

}  // namespace vesica::bench
