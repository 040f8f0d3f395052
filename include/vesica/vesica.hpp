// SPDX-License-Identifier: Apache-2.0
/// Everything in the core.
#pragma once

#include <vesica/area.hpp>
#include <vesica/boundary_distance.hpp>
#include <vesica/bounds.hpp>
#include <vesica/check.hpp>
#include <vesica/construct.hpp>
#include <vesica/crossings.hpp>
#include <vesica/depth.hpp>
#include <vesica/iou.hpp>
#include <vesica/nearest.hpp>
#include <vesica/nms.hpp>
#include <vesica/overlap.hpp>
#include <vesica/relation.hpp>
#include <vesica/shape_area.hpp>
#include <vesica/shapes.hpp>
