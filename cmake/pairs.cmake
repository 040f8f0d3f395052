# SPDX-License-Identifier: Apache-2.0
# The stems of files that exist once for each pair of shapes: VESICA_EACH_PAIR in include/vesica/each_shape.hpp, as names.
# pairs_test compares the two lists.
set(vesica_pairs
  point_point
  point_segment
  point_circle
  point_aabb
  point_rect
  point_ellipse
  segment_segment
  segment_circle
  segment_aabb
  segment_rect
  segment_ellipse
  circle_circle
  circle_aabb
  circle_rect
  circle_ellipse
  aabb_aabb
  aabb_rect
  aabb_ellipse
  rect_rect
  rect_ellipse
  ellipse_ellipse)
