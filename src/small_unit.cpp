// SPDX-License-Identifier: Apache-2.0
// The queries that are little more than filters, or ask other queries, compiled as one: to read the core takes as long
// as to compile the smallest of them. NOLINTBEGIN(bugprone-suspicious-include)
#include "queries/overlap.cpp"
#include "queries/relation.cpp"
#include "queries/signed_distance.cpp"
#include "queries/within.cpp"
// NOLINTEND(bugprone-suspicious-include)
