// SPDX-License-Identifier: Apache-2.0
// The questions of polygons, compiled as one object. NOLINTBEGIN(bugprone-suspicious-include)
#include "polygon/area.cpp"
#include "polygon/cast.cpp"
#include "polygon/crossings.cpp"
#include "polygon/de9im.cpp"
#include "polygon/depth.cpp"
#include "polygon/distances.cpp"
#include "polygon/intersection.cpp"
#include "polygon/manifold.cpp"
#include "polygon/overlap.cpp"
#include "polygon/relation.cpp"
#include "polygon/within.cpp"
// NOLINTEND(bugprone-suspicious-include)
