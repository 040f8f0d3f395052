// SPDX-License-Identifier: Apache-2.0
/// Parts of nearest/ for the minimum over directions: axes, directions and the support function of an ellipse.
#pragma once

#include <vesica/nearest/box_ellipse.hpp>
#include <vesica/nearest/ellipse_ellipse.hpp>
#include <vesica/nearest/lane_pairs.hpp>

namespace vesica::detail::support_minimum {

using namespace arithmetic;

using nearest::Axes;
using nearest::Box;
using nearest::BoxEllipse;
using nearest::Bracket;
using nearest::ClosestOffsets;
using nearest::Direction;
using nearest::Feature;
using nearest::FoundDirection;
using nearest::Image;
using nearest::LaneAnswer;
using nearest::MaskOf;
using nearest::OneEllipse;
using nearest::Pull;
using nearest::SemiAxes;
using nearest::Support;
using nearest::TwoEllipses;

using nearest::all;
using nearest::axes;
using nearest::box;
using nearest::choose;
using nearest::cross;
using nearest::dot;
using nearest::feature_ellipse;
using nearest::image;
using nearest::middle;
using nearest::moderate_pair;
using nearest::negated;
using nearest::no_support;
using nearest::normal;
using nearest::offset;
using nearest::one_ellipse;
using nearest::pull;
using nearest::search_between;
using nearest::semi_axes;
using nearest::separation;
using nearest::size_of;
using nearest::support;
using nearest::two_ellipses;
using nearest::unit;
using nearest::vertex;

}  // namespace vesica::detail::support_minimum
