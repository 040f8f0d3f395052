// SPDX-License-Identifier: Apache-2.0
// The queries of shared area, compiled as one object: each by itself would compile the areas again.
// NOLINTBEGIN(bugprone-suspicious-include)
#include "queries/area.cpp"
#include "queries/iou.cpp"
#include "queries/ratio.cpp"
// NOLINTEND(bugprone-suspicious-include)
