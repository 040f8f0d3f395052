// SPDX-License-Identifier: Apache-2.0
/// Areas to more than 60 digits, by another way than the library's: Green's theorem along the outlines' parts.
#pragma once

namespace reference {

/// The larger of the two shapes' aspects, and how far a value is from their shared area.
struct Deviation {
  double aspect;
  double in_roundoffs;  ///< |value - area| / (2^-53 * aspect * the lesser shape's area)
  double share;         ///< the shared area over the lesser shape's
};

/// Valid shapes with area, kinds and numbers as in vesica.h, which overlap; neither is more than 10^15
/// times as long as the other. Milliseconds.
Deviation deviation(int kind_a, const double* a, int kind_b, const double* b, double value);

/// The shared area, rounded.
double area(int kind_a, const double* a, int kind_b, const double* b);

/// The area of one shape to 60 digits, less `value`, over the distance of doubles at the area: at most 1/2 where the
/// value is correctly rounded (except subnormal areas).
double shape_area_error_in_places(int kind, const double* numbers, double value);

/// How far two ellipses or circles are from being one, where the first is the unit disc: the offset of centres and what
/// their matrices differ by. Greater than 1 for other shapes.
double difference(int kind_a, const double* a, int kind_b, const double* b);

/// How far a point is from an outline, to a few digits, for points near it.
double distance_to_outline(int kind, const double* numbers, double x, double y);

/// How far a point is from the nearest place where the outlines of two shapes meet, a circle or an ellipse among them.
double distance_to_meeting(int kind_a, const double* a, int kind_b, const double* b, double x, double y);

}  // namespace reference
