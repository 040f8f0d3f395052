// SPDX-License-Identifier: Apache-2.0
// The exact stage and the two queries that take most of it with them, compiled as one: each by itself would compile the
// same predicates again.
// NOLINTBEGIN(bugprone-suspicious-include)
#include "exact_stage.cpp"
#include "queries/cast.cpp"
#include "queries/crossings.cpp"
// NOLINTEND(bugprone-suspicious-include)
