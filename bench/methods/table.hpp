// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include "methods/method.hpp"

namespace vesica::bench::methods {

/// For each pair of kinds a table in Markdown: a row a method, below the exact default's, and a column a trial.
void print_tables(std::FILE* out, const std::vector<Method>& methods);

}  // namespace vesica::bench::methods
