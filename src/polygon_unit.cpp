// SPDX-License-Identifier: Apache-2.0
// The questions of polygons, compiled as one object. NOLINTBEGIN(bugprone-suspicious-include)
#include "polygon/overlap.cpp"
// NOLINTEND(bugprone-suspicious-include)
