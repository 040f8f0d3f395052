// SPDX-License-Identifier: Apache-2.0
/// The whole core: every question about two shapes, in double and float.
///
/// Invalid shapes: every question has a checked form, such as overlap_or_error(a, b) or nearest_or_error(a, b, out). It
/// returns a negative Error if check() finds a shape invalid, and then leaves `out` as it was. The plain form, such as
/// overlap(a, b), is for shapes known to be valid. It treats an invalid shape as one that has nothing in common with
/// any other (no overlap, no area, no depth, no crossings), at distance NaN.
///
/// bounds() and the functions that construct shapes have the checked form only.
#pragma once

#include <vesica/area.hpp>
#include <vesica/boundary_distance.hpp>
#include <vesica/bounds.hpp>
#include <vesica/boxes.hpp>
#include <vesica/cast.hpp>
#include <vesica/check.hpp>
#include <vesica/construct.hpp>
#include <vesica/coverage.hpp>
#include <vesica/crossings.hpp>
#include <vesica/de9im.hpp>
#include <vesica/depth.hpp>
#include <vesica/gaussian.hpp>
#include <vesica/impact_time.hpp>
#include <vesica/intersection.hpp>
#include <vesica/iou.hpp>
#include <vesica/manifold.hpp>
#include <vesica/nearest.hpp>
#include <vesica/overlap.hpp>
#include <vesica/polygon/bounds.hpp>
#include <vesica/polygon/cast.hpp>
#include <vesica/polygon/crossings.hpp>
#include <vesica/polygon/de9im.hpp>
#include <vesica/polygon/depth.hpp>
#include <vesica/polygon/distances.hpp>
#include <vesica/polygon/facts.hpp>
#include <vesica/polygon/impact_time.hpp>
#include <vesica/polygon/intersection.hpp>
#include <vesica/polygon/manifold.hpp>
#include <vesica/polygon/overlap.hpp>
#include <vesica/polygon/ratio.hpp>
#include <vesica/polygon/relation.hpp>
#include <vesica/polygon/simple.hpp>
#include <vesica/polygon/smallest_rect.hpp>
#include <vesica/polygon/within.hpp>
#include <vesica/ratio.hpp>
#include <vesica/relation.hpp>
#include <vesica/shape_area.hpp>
#include <vesica/shapes.hpp>
#include <vesica/signed_distance.hpp>
#include <vesica/within.hpp>
