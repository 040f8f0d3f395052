// SPDX-License-Identifier: Apache-2.0
// The exact stage and the queries that use most of it, compiled as one object: each by itself would compile the same
// predicates again.
// NOLINTBEGIN(bugprone-suspicious-include)
#include "exact_overlap.cpp"
#include "exact_stage.cpp"
#include "queries/cast.cpp"
#include "queries/crossings.cpp"
#include "queries/de9im.cpp"
#include "queries/intersection.cpp"
// NOLINTEND(bugprone-suspicious-include)
