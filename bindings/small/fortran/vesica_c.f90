! SPDX-License-Identifier: Apache-2.0
! Written by bindings/declare from capi/vesica.json: not to be edited.
!> The constants, types and functions of libvesica. Arrays that are written, and what may be NULL,
!> are c_ptr: c_loc of an array that is a target, or c_null_ptr. The constants of the version are called
!> vesica_declared_version, as names differ by more than case.
module vesica_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int32_t), parameter :: vesica_declared_version_major = 0
  integer(c_int32_t), parameter :: vesica_declared_version_minor = 1
  integer(c_int32_t), parameter :: vesica_declared_version_patch = 0
  integer(c_int32_t), parameter :: vesica_declared_version = 100
  integer(c_int32_t), parameter :: vesica_point = 0
  integer(c_int32_t), parameter :: vesica_segment = 1
  integer(c_int32_t), parameter :: vesica_circle = 2
  integer(c_int32_t), parameter :: vesica_aabb = 3
  integer(c_int32_t), parameter :: vesica_rect = 4
  integer(c_int32_t), parameter :: vesica_ellipse = 5
  integer(c_int32_t), parameter :: vesica_capsule = 6
  integer(c_int32_t), parameter :: vesica_round_rect = 7
  integer(c_int32_t), parameter :: vesica_polygon = 8
  integer(c_int32_t), parameter :: vesica_polyline = 9
  integer(c_int32_t), parameter :: vesica_disjoint = 0
  integer(c_int32_t), parameter :: vesica_touch = 1
  integer(c_int32_t), parameter :: vesica_cross = 2
  integer(c_int32_t), parameter :: vesica_inside = 3
  integer(c_int32_t), parameter :: vesica_inside_touch = 4
  integer(c_int32_t), parameter :: vesica_contains = 5
  integer(c_int32_t), parameter :: vesica_contains_touch = 6
  integer(c_int32_t), parameter :: vesica_equal = 7
  integer(c_int32_t), parameter :: vesica_e_null = -1
  integer(c_int32_t), parameter :: vesica_e_shape = -2
  integer(c_int32_t), parameter :: vesica_e_kind = -3
  integer(c_int32_t), parameter :: vesica_e_argument = -4
  integer(c_int32_t), parameter :: vesica_e_not_finite = -5
  integer(c_int32_t), parameter :: vesica_e_negative_size = -6
  integer(c_int32_t), parameter :: vesica_e_zero_axis = -7
  integer(c_int32_t), parameter :: vesica_e_inverted = -8
  integer(c_int32_t), parameter :: vesica_e_range = -9
  integer(c_int32_t), parameter :: vesica_e_index = -10
  integer(c_int32_t), parameter :: vesica_e_rings = -11
  integer(c_int32_t), parameter :: vesica_e_not_simple = -12
  integer(c_int32_t), parameter :: vesica_e_not_convex = -13
  integer(c_int32_t), parameter :: vesica_angle_radians = 0
  integer(c_int32_t), parameter :: vesica_angle_degrees = 1
  integer(c_int32_t), parameter :: vesica_angle_quarters = 2
  integer(c_int32_t), parameter :: vesica_angle_reversed = 4
  integer(c_int32_t), parameter :: vesica_fused_mean = 0
  integer(c_int32_t), parameter :: vesica_fused_max = 1
  integer(c_int32_t), parameter :: vesica_match_voc = 0
  integer(c_int32_t), parameter :: vesica_match_coco = 1
  integer(c_int32_t), parameter :: vesica_truth_counts = 0
  integer(c_int32_t), parameter :: vesica_truth_crowd = 1
  integer(c_int32_t), parameter :: vesica_truth_ignored = 2
  integer(c_int32_t), parameter :: vesica_outcome_miss = 0
  integer(c_int32_t), parameter :: vesica_outcome_hit = 1
  integer(c_int32_t), parameter :: vesica_outcome_ignored = 2
  integer(c_int32_t), parameter :: vesica_precision_voc_2007 = 0
  integer(c_int32_t), parameter :: vesica_precision_voc_2010 = 1
  integer(c_int32_t), parameter :: vesica_precision_coco = 2
  integer(c_int32_t), parameter :: vesica_gaussian_bhattacharyya = 0
  integer(c_int32_t), parameter :: vesica_gaussian_hellinger = 1
  integer(c_int32_t), parameter :: vesica_gaussian_kullback_leibler = 2
  integer(c_int32_t), parameter :: vesica_gaussian_wasserstein = 3
  integer(c_int32_t), parameter :: vesica_join_overlap = 0
  integer(c_int32_t), parameter :: vesica_join_bounds = 1
  integer(c_int32_t), parameter :: vesica_join_contains = 2
  integer(c_int32_t), parameter :: vesica_join_inside = 3
  integer(c_int32_t), parameter :: vesica_join_interiors = 4
  integer(c_int32_t), parameter :: vesica_ratio_over_union = 0
  integer(c_int32_t), parameter :: vesica_ratio_over_first = 1
  integer(c_int32_t), parameter :: vesica_ratio_over_second = 2
  integer(c_int32_t), parameter :: vesica_ratio_over_smaller = 3
  integer(c_int32_t), parameter :: vesica_ratio_generalized = 4
  integer(c_int32_t), parameter :: vesica_ratio_distance = 5
  integer(c_int32_t), parameter :: vesica_ratio_complete = 6
  integer(c_int32_t), parameter :: vesica_within_no = 0
  integer(c_int32_t), parameter :: vesica_within_yes = 1
  integer(c_int32_t), parameter :: vesica_within_nearly = 2
  integer(c_int32_t), parameter :: vesica_decay_linear = 0
  integer(c_int32_t), parameter :: vesica_decay_gaussian = 1
  integer(c_int32_t), parameter :: vesica_cast_miss = 0
  integer(c_int32_t), parameter :: vesica_cast_hit = 1
  integer(c_int32_t), parameter :: vesica_cast_start = 2
  integer(c_int32_t), parameter :: vesica_cast_near = 3
  integer(c_int32_t), parameter :: vesica_de9im_size = 10

  !> A location.
  type, bind(c) :: vesica_point_f64
    real(c_double) :: x
    real(c_double) :: y
  end type

  !> All points between two end points.
  type, bind(c) :: vesica_segment_f64
    real(c_double) :: x0
    real(c_double) :: y0
    real(c_double) :: x1
    real(c_double) :: y1
  end type

  !> A disc: centre and radius, r >= 0.
  type, bind(c) :: vesica_circle_f64
    real(c_double) :: cx
    real(c_double) :: cy
    real(c_double) :: r
  end type

  !> A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
  type, bind(c) :: vesica_aabb_f64
    real(c_double) :: min_x
    real(c_double) :: min_y
    real(c_double) :: max_x
    real(c_double) :: max_y
  end type

  !> All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
  type, bind(c) :: vesica_rect_f64
    real(c_double) :: cx
    real(c_double) :: cy
    real(c_double) :: ux
    real(c_double) :: uy
    real(c_double) :: hx
    real(c_double) :: hy
  end type

  !> All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
  type, bind(c) :: vesica_ellipse_f64
    real(c_double) :: cx
    real(c_double) :: cy
    real(c_double) :: ux
    real(c_double) :: uy
    real(c_double) :: a
    real(c_double) :: b
  end type

  !> All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
  type, bind(c) :: vesica_capsule_f64
    real(c_double) :: x0
    real(c_double) :: y0
    real(c_double) :: x1
    real(c_double) :: y1
    real(c_double) :: r
  end type

  !> All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are the
  !> rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
  type, bind(c) :: vesica_round_rect_f64
    real(c_double) :: cx
    real(c_double) :: cy
    real(c_double) :: ux
    real(c_double) :: uy
    real(c_double) :: hx
    real(c_double) :: hy
    real(c_double) :: r
  end type

  !> A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
  type, bind(c) :: vesica_polygon_f64
    type(c_ptr) :: x
    type(c_ptr) :: y
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: rings
    integer(c_int64_t) :: count
  end type

  !> A polyline.
  type, bind(c) :: vesica_polyline_f64
    type(c_ptr) :: x
    type(c_ptr) :: y
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: rings
    integer(c_int64_t) :: count
  end type

  !> Facts about a polygon, from vesica_polygon_facts_f64.
  type, bind(c) :: vesica_facts_f64
    integer(c_int64_t) :: vertices
    integer(c_int64_t) :: first_crossing
    integer(c_int64_t) :: second_crossing
    real(c_double) :: area
    integer(c_int32_t) :: orientation
    integer(c_int32_t) :: convex
    integer(c_int32_t) :: simple
    integer(c_int32_t) :: rings
  end type

  !> A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
  type, bind(c) :: vesica_closest_points_f64
    real(c_double) :: distance
    real(c_double) :: ax
    real(c_double) :: ay
    real(c_double) :: bx
    real(c_double) :: by
  end type

  !> The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
  type, bind(c) :: vesica_penetration_f64
    real(c_double) :: depth
    real(c_double) :: x
    real(c_double) :: y
  end type

  !> An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
  type, bind(c) :: vesica_shapes_f64
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: count
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: field(8)
    type(c_ptr) :: rings
    type(c_ptr) :: polygons
    integer(c_int64_t) :: each
  end type

  !> A location.
  type, bind(c) :: vesica_point_f32
    real(c_float) :: x
    real(c_float) :: y
  end type

  !> All points between two end points.
  type, bind(c) :: vesica_segment_f32
    real(c_float) :: x0
    real(c_float) :: y0
    real(c_float) :: x1
    real(c_float) :: y1
  end type

  !> A disc: centre and radius, r >= 0.
  type, bind(c) :: vesica_circle_f32
    real(c_float) :: cx
    real(c_float) :: cy
    real(c_float) :: r
  end type

  !> A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
  type, bind(c) :: vesica_aabb_f32
    real(c_float) :: min_x
    real(c_float) :: min_y
    real(c_float) :: max_x
    real(c_float) :: max_y
  end type

  !> All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
  type, bind(c) :: vesica_rect_f32
    real(c_float) :: cx
    real(c_float) :: cy
    real(c_float) :: ux
    real(c_float) :: uy
    real(c_float) :: hx
    real(c_float) :: hy
  end type

  !> All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
  type, bind(c) :: vesica_ellipse_f32
    real(c_float) :: cx
    real(c_float) :: cy
    real(c_float) :: ux
    real(c_float) :: uy
    real(c_float) :: a
    real(c_float) :: b
  end type

  !> All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
  type, bind(c) :: vesica_capsule_f32
    real(c_float) :: x0
    real(c_float) :: y0
    real(c_float) :: x1
    real(c_float) :: y1
    real(c_float) :: r
  end type

  !> All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are the
  !> rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
  type, bind(c) :: vesica_round_rect_f32
    real(c_float) :: cx
    real(c_float) :: cy
    real(c_float) :: ux
    real(c_float) :: uy
    real(c_float) :: hx
    real(c_float) :: hy
    real(c_float) :: r
  end type

  !> A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
  type, bind(c) :: vesica_polygon_f32
    type(c_ptr) :: x
    type(c_ptr) :: y
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: rings
    integer(c_int64_t) :: count
  end type

  !> A polyline.
  type, bind(c) :: vesica_polyline_f32
    type(c_ptr) :: x
    type(c_ptr) :: y
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: rings
    integer(c_int64_t) :: count
  end type

  !> Facts about a polygon, from vesica_polygon_facts_f32.
  type, bind(c) :: vesica_facts_f32
    integer(c_int64_t) :: vertices
    integer(c_int64_t) :: first_crossing
    integer(c_int64_t) :: second_crossing
    real(c_float) :: area
    integer(c_int32_t) :: orientation
    integer(c_int32_t) :: convex
    integer(c_int32_t) :: simple
    integer(c_int32_t) :: rings
  end type

  !> A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
  type, bind(c) :: vesica_closest_points_f32
    real(c_float) :: distance
    real(c_float) :: ax
    real(c_float) :: ay
    real(c_float) :: bx
    real(c_float) :: by
  end type

  !> The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
  type, bind(c) :: vesica_penetration_f32
    real(c_float) :: depth
    real(c_float) :: x
    real(c_float) :: y
  end type

  !> An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
  type, bind(c) :: vesica_shapes_f32
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: count
    integer(c_ptrdiff_t) :: stride
    type(c_ptr) :: field(8)
    type(c_ptr) :: rings
    type(c_ptr) :: polygons
    integer(c_int64_t) :: each
  end type

  !> All heights from low to high; low <= high, both finite.
  type, bind(c) :: vesica_span_f64
    real(c_double) :: low
    real(c_double) :: high
  end type

  !> All heights from low to high; low <= high, both finite.
  type, bind(c) :: vesica_span_f32
    real(c_float) :: low
    real(c_float) :: high
  end type

  !> A grid of cells, such as the pixels of a picture.
  type, bind(c) :: vesica_grid_f64
    real(c_double) :: x
    real(c_double) :: y
    real(c_double) :: dx
    real(c_double) :: dy
    integer(c_int64_t) :: columns
    integer(c_int64_t) :: rows
  end type

  !> A grid of cells, such as the pixels of a picture.
  type, bind(c) :: vesica_grid_f32
    real(c_float) :: x
    real(c_float) :: y
    real(c_float) :: dx
    real(c_float) :: dy
    integer(c_int64_t) :: columns
    integer(c_int64_t) :: rows
  end type

  !> A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
  type, bind(c) :: vesica_impact_f64
    real(c_double) :: t
    real(c_double) :: x
    real(c_double) :: y
    real(c_double) :: nx
    real(c_double) :: ny
  end type

  !> How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
  !> turns about its centre.
  type, bind(c) :: vesica_turn_f64
    real(c_double) :: vx
    real(c_double) :: vy
    real(c_double) :: angle
  end type

  !> The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
  type, bind(c) :: vesica_contacts_f64
    real(c_double) :: nx
    real(c_double) :: ny
    real(c_double) :: x0
    real(c_double) :: y0
    real(c_double) :: depth0
    real(c_double) :: x1
    real(c_double) :: y1
    real(c_double) :: depth1
    integer(c_int64_t) :: a0
    integer(c_int64_t) :: b0
    integer(c_int64_t) :: a1
    integer(c_int64_t) :: b1
    integer(c_int64_t) :: count
  end type

  !> A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
  type, bind(c) :: vesica_impact_f32
    real(c_float) :: t
    real(c_float) :: x
    real(c_float) :: y
    real(c_float) :: nx
    real(c_float) :: ny
  end type

  !> How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
  !> turns about its centre.
  type, bind(c) :: vesica_turn_f32
    real(c_float) :: vx
    real(c_float) :: vy
    real(c_float) :: angle
  end type

  !> The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
  type, bind(c) :: vesica_contacts_f32
    real(c_float) :: nx
    real(c_float) :: ny
    real(c_float) :: x0
    real(c_float) :: y0
    real(c_float) :: depth0
    real(c_float) :: x1
    real(c_float) :: y1
    real(c_float) :: depth1
    integer(c_int64_t) :: a0
    integer(c_int64_t) :: b0
    integer(c_int64_t) :: a1
    integer(c_int64_t) :: b1
    integer(c_int64_t) :: count
  end type

  interface
    !> Do two shapes share a point?
    integer(c_int32_t) function vesica_overlap_f64(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
    end function

    !> Do the insides of two shapes share a point?
    integer(c_int32_t) function vesica_interiors_overlap_f64(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
    end function

    !> Does a contain all of b?
    integer(c_int32_t) function vesica_contains_f64(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
    end function

    !> How does a relate to b?
    integer(c_int32_t) function vesica_relation_f64(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
    end function

    !> How far apart are two solid shapes, and which of their points are closest?
    integer(c_int32_t) function vesica_nearest_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_closest_points_f64), intent(out) :: out
    end function

    !> Penetration depth: how far and which way must b be moved until the two shapes only touch?
    integer(c_int32_t) function vesica_depth_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_penetration_f64), intent(out) :: out
    end function

    !> Area of the intersection of two shapes.
    integer(c_int32_t) function vesica_area_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    integer(c_int32_t) function vesica_iou_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Smallest box of representable numbers that contains a shape.
    integer(c_int32_t) function vesica_bounds_f64(kind, shape, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
      type(vesica_aabb_f64), intent(out) :: out
    end function

    !> Is a shape valid, and if not, which rule does it break?
    integer(c_int32_t) function vesica_check_f64(kind, shape) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
    end function

    !> The meaning of an error code, as one English phrase without a full stop.
    type(c_ptr) function vesica_strerror(code) bind(c)
      import
      integer(c_int32_t), value :: code
    end function

    !> Where do the outlines of two shapes meet?
    integer(c_int64_t) function vesica_crossings_f64(kind_a, a, kind_b, b, out, capacity, shared) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: shared
    end function

    !> How far apart are the outlines of two shapes, and where do they come closest?
    integer(c_int32_t) function vesica_boundary_distance_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_closest_points_f64), intent(out) :: out
    end function

    !> Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    integer(c_int32_t) function vesica_shape_area_f64(kind, shape, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
      type(c_ptr), value :: out
    end function

    !> States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    integer(c_int32_t) function vesica_polygon_facts_f64(polygon, out) bind(c)
      import
      type(vesica_polygon_f64), intent(in) :: polygon
      type(vesica_facts_f64), intent(out) :: out
    end function

    !> Are the two points the same?
    integer(c_int32_t) function vesica_overlap_point_point_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
    end function

    !> Does the point lie on the segment?
    integer(c_int32_t) function vesica_overlap_point_segment_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_segment_f64), intent(in) :: b
    end function

    !> Does the point lie in the disc or on its rim?
    integer(c_int32_t) function vesica_overlap_point_circle_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_circle_f64), intent(in) :: b
    end function

    !> Does the point lie in the box or on its outline?
    integer(c_int32_t) function vesica_overlap_point_aabb_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_aabb_f64), intent(in) :: b
    end function

    !> Does the point lie in the rectangle or on its outline?
    integer(c_int32_t) function vesica_overlap_point_rect_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
    end function

    !> Does the point lie in the ellipse or on its outline?
    integer(c_int32_t) function vesica_overlap_point_ellipse_f64(a, b) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Do the segments share a point?
    integer(c_int32_t) function vesica_overlap_segment_segment_f64(a, b) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_segment_f64), intent(in) :: b
    end function

    !> Does the segment meet the disc?
    integer(c_int32_t) function vesica_overlap_segment_circle_f64(a, b) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_circle_f64), intent(in) :: b
    end function

    !> Does the segment meet the box?
    integer(c_int32_t) function vesica_overlap_segment_aabb_f64(a, b) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_aabb_f64), intent(in) :: b
    end function

    !> Does the segment meet the rectangle?
    integer(c_int32_t) function vesica_overlap_segment_rect_f64(a, b) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
    end function

    !> Does the segment meet the ellipse?
    integer(c_int32_t) function vesica_overlap_segment_ellipse_f64(a, b) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Do the discs share a point?
    integer(c_int32_t) function vesica_overlap_circle_circle_f64(a, b) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_circle_f64), intent(in) :: b
    end function

    !> Do the disc and the box share a point?
    integer(c_int32_t) function vesica_overlap_circle_aabb_f64(a, b) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_aabb_f64), intent(in) :: b
    end function

    !> Do the disc and the rectangle share a point?
    integer(c_int32_t) function vesica_overlap_circle_rect_f64(a, b) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
    end function

    !> Do the disc and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_circle_ellipse_f64(a, b) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Do the boxes share a point?
    integer(c_int32_t) function vesica_overlap_aabb_aabb_f64(a, b) bind(c)
      import
      type(vesica_aabb_f64), intent(in) :: a
      type(vesica_aabb_f64), intent(in) :: b
    end function

    !> Do the box and the rectangle share a point?
    integer(c_int32_t) function vesica_overlap_aabb_rect_f64(a, b) bind(c)
      import
      type(vesica_aabb_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
    end function

    !> Do the box and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_aabb_ellipse_f64(a, b) bind(c)
      import
      type(vesica_aabb_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Do the rectangles share a point?
    integer(c_int32_t) function vesica_overlap_rect_rect_f64(a, b) bind(c)
      import
      type(vesica_rect_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
    end function

    !> Do the rectangle and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_rect_ellipse_f64(a, b) bind(c)
      import
      type(vesica_rect_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Do the ellipses share a point?
    integer(c_int32_t) function vesica_overlap_ellipse_ellipse_f64(a, b) bind(c)
      import
      type(vesica_ellipse_f64), intent(in) :: a
      type(vesica_ellipse_f64), intent(in) :: b
    end function

    !> Box with two opposite corners, in any order.
    integer(c_int32_t) function vesica_aabb_from_corners_f64(x0, y0, x1, y1, out) bind(c)
      import
      real(c_double), value :: x0
      real(c_double), value :: y0
      real(c_double), value :: x1
      real(c_double), value :: y1
      type(vesica_aabb_f64), intent(out) :: out
    end function

    !> Rectangle from centre, angle and full size: width along the angle, height across it.
    integer(c_int32_t) function vesica_rect_from_angle_f64(cx, cy, angle, width, height, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: angle
      real(c_double), value :: width
      real(c_double), value :: height
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    integer(c_int32_t) function vesica_rect_from_corners_f64(corners, out) bind(c)
      import
      real(c_double), intent(in) :: corners(*)
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> The largest distance from a given corner to the rectangle's corner that corresponds to it.
    integer(c_int32_t) function vesica_rect_corners_misfit_f64(corners, r, misfit) bind(c)
      import
      real(c_double), intent(in) :: corners(*)
      type(vesica_rect_f64), intent(in) :: r
      type(c_ptr), value :: misfit
    end function

    !> Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    !> across.
    integer(c_int32_t) function vesica_round_rect_from_angle_f64(cx, cy, angle, width, height, radius, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: angle
      real(c_double), value :: width
      real(c_double), value :: height
      real(c_double), value :: radius
      type(vesica_round_rect_f64), intent(out) :: out
    end function

    !> Capsule from centre, angle, the length between the ends of its segment, and radius.
    integer(c_int32_t) function vesica_capsule_from_angle_f64(cx, cy, angle, length, radius, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: angle
      real(c_double), value :: length
      real(c_double), value :: radius
      type(vesica_capsule_f64), intent(out) :: out
    end function

    !> Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    !> ends.
    integer(c_int32_t) function vesica_capsule_from_width_f64(x0, y0, x1, y1, width, out) bind(c)
      import
      real(c_double), value :: x0
      real(c_double), value :: y0
      real(c_double), value :: x1
      real(c_double), value :: y1
      real(c_double), value :: width
      type(vesica_capsule_f64), intent(out) :: out
    end function

    !> Ellipse from centre, angle and half lengths: a along the angle, b across it.
    integer(c_int32_t) function vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: angle
      real(c_double), value :: a
      real(c_double), value :: b
      type(vesica_ellipse_f64), intent(out) :: out
    end function

    !> Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx,
    !> wy).
    integer(c_int32_t) function vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: wx
      real(c_double), value :: wy
      real(c_double), value :: ratio
      type(vesica_ellipse_f64), intent(out) :: out
    end function

    !> Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    integer(c_int32_t) function vesica_ellipse_from_covariance_f64(mean_x, mean_y, cxx, cxy, cyy, k, out) bind(c)
      import
      real(c_double), value :: mean_x
      real(c_double), value :: mean_y
      real(c_double), value :: cxx
      real(c_double), value :: cxy
      real(c_double), value :: cyy
      real(c_double), value :: k
      type(vesica_ellipse_f64), intent(out) :: out
    end function

    !> Ellipse of the points X with (X - C) .
    integer(c_int32_t) function vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, out) bind(c)
      import
      real(c_double), value :: cx
      real(c_double), value :: cy
      real(c_double), value :: mxx
      real(c_double), value :: mxy
      real(c_double), value :: myy
      type(vesica_ellipse_f64), intent(out) :: out
    end function

    !> Describes an array of `count` records.
    integer(c_int32_t) function vesica_shapes_from_records_f64(kind, count, base, stride, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      integer(c_int64_t), value :: count
      type(c_ptr), value :: base
      integer(c_ptrdiff_t), value :: stride
      type(vesica_shapes_f64), intent(out) :: out
    end function

    !> Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
    integer(c_int64_t) function vesica_overlap_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
    integer(c_int64_t) function vesica_interiors_overlap_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
    integer(c_int64_t) function vesica_relation_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
    integer(c_int64_t) function vesica_contains_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> How far apart are a[i] and b[i], and where?
    integer(c_int64_t) function vesica_nearest_many_f64(a, b, distance, ax, ay, bx, by) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: distance
      type(c_ptr), value :: ax
      type(c_ptr), value :: ay
      type(c_ptr), value :: bx
      type(c_ptr), value :: by
    end function

    !> How far apart are the outlines of a[i] and b[i]?
    integer(c_int64_t) function vesica_boundary_distance_many_f64(a, b, distance, ax, ay, bx, by) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: distance
      type(c_ptr), value :: ax
      type(c_ptr), value :: ay
      type(c_ptr), value :: bx
      type(c_ptr), value :: by
    end function

    !> How deep do a[i] and b[i] overlap?
    integer(c_int64_t) function vesica_depth_many_f64(a, b, depth, x, y) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: depth
      type(c_ptr), value :: x
      type(c_ptr), value :: y
    end function

    !> The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
    integer(c_int64_t) function vesica_area_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
    integer(c_int64_t) function vesica_iou_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Do a[i] and b[j] share a point?
    integer(c_int64_t) function vesica_overlap_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Do the insides of a[i] and b[j] share a point?
    integer(c_int64_t) function vesica_interiors_overlap_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How does a[i] relate to b[j]?
    integer(c_int64_t) function vesica_relation_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Does a[i] contain all of b[j]?
    integer(c_int64_t) function vesica_contains_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> The area that a[i] and b[j] share.
    integer(c_int64_t) function vesica_area_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Intersection over union of a[i] and b[j].
    integer(c_int64_t) function vesica_iou_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Which of many shapes overlap one?
    integer(c_int64_t) function vesica_overlap_select_f64(one, many, out, capacity) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: one
      type(vesica_shapes_f64), intent(in) :: many
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> Which of many shapes share a point of their insides with that of one?
    integer(c_int64_t) function vesica_interiors_overlap_select_f64(one, many, out, capacity) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: one
      type(vesica_shapes_f64), intent(in) :: many
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count`
    !> shapes?
    integer(c_int64_t) function vesica_nms_scratch(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    !> whose vesica_iou_f64 with every shape kept before is at most the threshold.
    integer(c_int32_t) function vesica_nms_f64(shapes, scores, threshold, scratch, scratch_size, keep, kept) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: scores
      real(c_double), value :: threshold
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: kept
    end function

    !> Version of the loaded library.
    integer(c_int32_t) function vesica_version() bind(c)
      import
    end function

    !> VESICA_VERSION_MAJOR of the loaded library.
    integer(c_int32_t) function vesica_version_major() bind(c)
      import
    end function

    !> VESICA_VERSION_MINOR of the loaded library.
    integer(c_int32_t) function vesica_version_minor() bind(c)
      import
    end function

    !> VESICA_VERSION_PATCH of the loaded library.
    integer(c_int32_t) function vesica_version_patch() bind(c)
      import
    end function

    !> How many numbers does a shape of this kind have?
    integer(c_int32_t) function vesica_field_count(kind) bind(c)
      import
      integer(c_int32_t), value :: kind
    end function

    !> Name of a kind.
    type(c_ptr) function vesica_kind_name(kind) bind(c)
      import
      integer(c_int32_t), value :: kind
    end function

    !> Name of the instruction set that batches use: the best one of this processor.
    type(c_ptr) function vesica_isa_name() bind(c)
      import
    end function

    !> Is a shape valid, and if not, which rule does it break?
    integer(c_int32_t) function vesica_check_f32(kind, shape) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
    end function

    !> Do two shapes share a point?
    integer(c_int32_t) function vesica_overlap_f32(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
    end function

    !> Do the insides of two shapes share a point?
    integer(c_int32_t) function vesica_interiors_overlap_f32(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
    end function

    !> How does a relate to b?
    integer(c_int32_t) function vesica_relation_f32(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
    end function

    !> Does a contain all of b?
    integer(c_int32_t) function vesica_contains_f32(kind_a, a, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
    end function

    !> Where do the outlines of two shapes meet?
    integer(c_int64_t) function vesica_crossings_f32(kind_a, a, kind_b, b, out, capacity, shared) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: shared
    end function

    !> How far apart are two solid shapes, and which of their points are closest?
    integer(c_int32_t) function vesica_nearest_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_closest_points_f32), intent(out) :: out
    end function

    !> How far apart are the outlines of two shapes, and where do they come closest?
    integer(c_int32_t) function vesica_boundary_distance_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_closest_points_f32), intent(out) :: out
    end function

    !> Penetration depth: how far and which way must b be moved until the two shapes only touch?
    integer(c_int32_t) function vesica_depth_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_penetration_f32), intent(out) :: out
    end function

    !> Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    integer(c_int32_t) function vesica_shape_area_f32(kind, shape, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
      type(c_ptr), value :: out
    end function

    !> States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    integer(c_int32_t) function vesica_polygon_facts_f32(polygon, out) bind(c)
      import
      type(vesica_polygon_f32), intent(in) :: polygon
      type(vesica_facts_f32), intent(out) :: out
    end function

    !> Area of the intersection of two shapes.
    integer(c_int32_t) function vesica_area_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    integer(c_int32_t) function vesica_iou_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Smallest box of representable numbers that contains a shape.
    integer(c_int32_t) function vesica_bounds_f32(kind, shape, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
      type(vesica_aabb_f32), intent(out) :: out
    end function

    !> Are the two points the same?
    integer(c_int32_t) function vesica_overlap_point_point_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
    end function

    !> Does the point lie on the segment?
    integer(c_int32_t) function vesica_overlap_point_segment_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_segment_f32), intent(in) :: b
    end function

    !> Does the point lie in the disc or on its rim?
    integer(c_int32_t) function vesica_overlap_point_circle_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_circle_f32), intent(in) :: b
    end function

    !> Does the point lie in the box or on its outline?
    integer(c_int32_t) function vesica_overlap_point_aabb_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_aabb_f32), intent(in) :: b
    end function

    !> Does the point lie in the rectangle or on its outline?
    integer(c_int32_t) function vesica_overlap_point_rect_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
    end function

    !> Does the point lie in the ellipse or on its outline?
    integer(c_int32_t) function vesica_overlap_point_ellipse_f32(a, b) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Do the segments share a point?
    integer(c_int32_t) function vesica_overlap_segment_segment_f32(a, b) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_segment_f32), intent(in) :: b
    end function

    !> Does the segment meet the disc?
    integer(c_int32_t) function vesica_overlap_segment_circle_f32(a, b) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_circle_f32), intent(in) :: b
    end function

    !> Does the segment meet the box?
    integer(c_int32_t) function vesica_overlap_segment_aabb_f32(a, b) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_aabb_f32), intent(in) :: b
    end function

    !> Does the segment meet the rectangle?
    integer(c_int32_t) function vesica_overlap_segment_rect_f32(a, b) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
    end function

    !> Does the segment meet the ellipse?
    integer(c_int32_t) function vesica_overlap_segment_ellipse_f32(a, b) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Do the discs share a point?
    integer(c_int32_t) function vesica_overlap_circle_circle_f32(a, b) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_circle_f32), intent(in) :: b
    end function

    !> Do the disc and the box share a point?
    integer(c_int32_t) function vesica_overlap_circle_aabb_f32(a, b) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_aabb_f32), intent(in) :: b
    end function

    !> Do the disc and the rectangle share a point?
    integer(c_int32_t) function vesica_overlap_circle_rect_f32(a, b) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
    end function

    !> Do the disc and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_circle_ellipse_f32(a, b) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Do the boxes share a point?
    integer(c_int32_t) function vesica_overlap_aabb_aabb_f32(a, b) bind(c)
      import
      type(vesica_aabb_f32), intent(in) :: a
      type(vesica_aabb_f32), intent(in) :: b
    end function

    !> Do the box and the rectangle share a point?
    integer(c_int32_t) function vesica_overlap_aabb_rect_f32(a, b) bind(c)
      import
      type(vesica_aabb_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
    end function

    !> Do the box and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_aabb_ellipse_f32(a, b) bind(c)
      import
      type(vesica_aabb_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Do the rectangles share a point?
    integer(c_int32_t) function vesica_overlap_rect_rect_f32(a, b) bind(c)
      import
      type(vesica_rect_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
    end function

    !> Do the rectangle and the ellipse share a point?
    integer(c_int32_t) function vesica_overlap_rect_ellipse_f32(a, b) bind(c)
      import
      type(vesica_rect_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Do the ellipses share a point?
    integer(c_int32_t) function vesica_overlap_ellipse_ellipse_f32(a, b) bind(c)
      import
      type(vesica_ellipse_f32), intent(in) :: a
      type(vesica_ellipse_f32), intent(in) :: b
    end function

    !> Box with two opposite corners, in any order.
    integer(c_int32_t) function vesica_aabb_from_corners_f32(x0, y0, x1, y1, out) bind(c)
      import
      real(c_float), value :: x0
      real(c_float), value :: y0
      real(c_float), value :: x1
      real(c_float), value :: y1
      type(vesica_aabb_f32), intent(out) :: out
    end function

    !> Rectangle from centre, angle and full size: width along the angle, height across it.
    integer(c_int32_t) function vesica_rect_from_angle_f32(cx, cy, angle, width, height, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: angle
      real(c_float), value :: width
      real(c_float), value :: height
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    integer(c_int32_t) function vesica_rect_from_corners_f32(corners, out) bind(c)
      import
      real(c_float), intent(in) :: corners(*)
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> The largest distance from a given corner to the rectangle's corner that corresponds to it.
    integer(c_int32_t) function vesica_rect_corners_misfit_f32(corners, r, misfit) bind(c)
      import
      real(c_float), intent(in) :: corners(*)
      type(vesica_rect_f32), intent(in) :: r
      type(c_ptr), value :: misfit
    end function

    !> Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    !> across.
    integer(c_int32_t) function vesica_round_rect_from_angle_f32(cx, cy, angle, width, height, radius, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: angle
      real(c_float), value :: width
      real(c_float), value :: height
      real(c_float), value :: radius
      type(vesica_round_rect_f32), intent(out) :: out
    end function

    !> Capsule from centre, angle, the length between the ends of its segment, and radius.
    integer(c_int32_t) function vesica_capsule_from_angle_f32(cx, cy, angle, length, radius, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: angle
      real(c_float), value :: length
      real(c_float), value :: radius
      type(vesica_capsule_f32), intent(out) :: out
    end function

    !> Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    !> ends.
    integer(c_int32_t) function vesica_capsule_from_width_f32(x0, y0, x1, y1, width, out) bind(c)
      import
      real(c_float), value :: x0
      real(c_float), value :: y0
      real(c_float), value :: x1
      real(c_float), value :: y1
      real(c_float), value :: width
      type(vesica_capsule_f32), intent(out) :: out
    end function

    !> Ellipse from centre, angle and half lengths: a along the angle, b across it.
    integer(c_int32_t) function vesica_ellipse_from_angle_f32(cx, cy, angle, a, b, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: angle
      real(c_float), value :: a
      real(c_float), value :: b
      type(vesica_ellipse_f32), intent(out) :: out
    end function

    !> Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx,
    !> wy).
    integer(c_int32_t) function vesica_ellipse_from_radius_vector_f32(cx, cy, wx, wy, ratio, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: wx
      real(c_float), value :: wy
      real(c_float), value :: ratio
      type(vesica_ellipse_f32), intent(out) :: out
    end function

    !> Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    integer(c_int32_t) function vesica_ellipse_from_covariance_f32(mean_x, mean_y, cxx, cxy, cyy, k, out) bind(c)
      import
      real(c_float), value :: mean_x
      real(c_float), value :: mean_y
      real(c_float), value :: cxx
      real(c_float), value :: cxy
      real(c_float), value :: cyy
      real(c_float), value :: k
      type(vesica_ellipse_f32), intent(out) :: out
    end function

    !> Ellipse of the points X with (X - C) .
    integer(c_int32_t) function vesica_ellipse_from_matrix_f32(cx, cy, mxx, mxy, myy, out) bind(c)
      import
      real(c_float), value :: cx
      real(c_float), value :: cy
      real(c_float), value :: mxx
      real(c_float), value :: mxy
      real(c_float), value :: myy
      type(vesica_ellipse_f32), intent(out) :: out
    end function

    !> Describes an array of `count` records.
    integer(c_int32_t) function vesica_shapes_from_records_f32(kind, count, base, stride, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      integer(c_int64_t), value :: count
      type(c_ptr), value :: base
      integer(c_ptrdiff_t), value :: stride
      type(vesica_shapes_f32), intent(out) :: out
    end function

    !> Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
    integer(c_int64_t) function vesica_overlap_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
    integer(c_int64_t) function vesica_interiors_overlap_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
    integer(c_int64_t) function vesica_relation_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
    integer(c_int64_t) function vesica_contains_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> How far apart are a[i] and b[i], and where?
    integer(c_int64_t) function vesica_nearest_many_f32(a, b, distance, ax, ay, bx, by) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: distance
      type(c_ptr), value :: ax
      type(c_ptr), value :: ay
      type(c_ptr), value :: bx
      type(c_ptr), value :: by
    end function

    !> How far apart are the outlines of a[i] and b[i]?
    integer(c_int64_t) function vesica_boundary_distance_many_f32(a, b, distance, ax, ay, bx, by) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: distance
      type(c_ptr), value :: ax
      type(c_ptr), value :: ay
      type(c_ptr), value :: bx
      type(c_ptr), value :: by
    end function

    !> How deep do a[i] and b[i] overlap?
    integer(c_int64_t) function vesica_depth_many_f32(a, b, depth, x, y) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: depth
      type(c_ptr), value :: x
      type(c_ptr), value :: y
    end function

    !> The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
    integer(c_int64_t) function vesica_area_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
    integer(c_int64_t) function vesica_iou_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Do a[i] and b[j] share a point?
    integer(c_int64_t) function vesica_overlap_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Do the insides of a[i] and b[j] share a point?
    integer(c_int64_t) function vesica_interiors_overlap_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How does a[i] relate to b[j]?
    integer(c_int64_t) function vesica_relation_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Does a[i] contain all of b[j]?
    integer(c_int64_t) function vesica_contains_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> The area that a[i] and b[j] share.
    integer(c_int64_t) function vesica_area_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Intersection over union of a[i] and b[j].
    integer(c_int64_t) function vesica_iou_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Which of many shapes overlap one?
    integer(c_int64_t) function vesica_overlap_select_f32(one, many, out, capacity) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: one
      type(vesica_shapes_f32), intent(in) :: many
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> Which of many shapes share a point of their insides with that of one?
    integer(c_int64_t) function vesica_interiors_overlap_select_f32(one, many, out, capacity) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: one
      type(vesica_shapes_f32), intent(in) :: many
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    !> whose vesica_iou_f32 with every shape kept before is at most the threshold.
    integer(c_int32_t) function vesica_nms_f32(shapes, scores, threshold, scratch, scratch_size, keep, kept) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: scores
      real(c_float), value :: threshold
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: kept
    end function

    !> Rectangles from boxes.
    integer(c_int64_t) function vesica_rects_from_boxes_f64(boxes, count, stride, angle, out) bind(c)
      import
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: out
    end function

    !> Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    integer(c_int64_t) function vesica_ellipses_from_boxes_f64(boxes, count, stride, angle, out) bind(c)
      import
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: out
    end function

    !> Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
    integer(c_int64_t) function vesica_rects_from_corners_f64(corners, count, stride, out) bind(c)
      import
      type(c_ptr), value :: corners
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
    integer(c_int64_t) function vesica_rect_corners_misfit_many_f64(corners, stride, rects, misfit) bind(c)
      import
      type(c_ptr), value :: corners
      integer(c_ptrdiff_t), value :: stride
      type(vesica_shapes_f64), intent(in) :: rects
      type(c_ptr), value :: misfit
    end function

    !> Boxes from rectangles or from ellipses: the inverse of the first two functions.
    integer(c_int64_t) function vesica_boxes_from_shapes_f64(shapes, angle, boxes) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: boxes
    end function

    !> The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    integer(c_int64_t) function vesica_corners_of_shapes_f64(shapes, corners) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: corners
    end function

    !> Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
    integer(c_int64_t) function vesica_bounds_many_f64(shapes, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: out
    end function

    !> Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
    integer(c_int64_t) function vesica_shape_area_many_f64(shapes, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: out
    end function

    !> The convex hull of points: the smallest convex polygon that contains them.
    integer(c_int64_t) function vesica_convex_hull_f64(points, out, capacity) bind(c)
      import
      type(vesica_polygon_f64), intent(in) :: points
      type(vesica_point_f64), intent(out) :: out
      integer(c_int64_t), value :: capacity
    end function

    !> The rectangle of the least area that contains points.
    integer(c_int32_t) function vesica_min_area_rect_f64(points, out) bind(c)
      import
      type(vesica_polygon_f64), intent(in) :: points
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
    integer(c_int32_t) function vesica_min_perimeter_rect_f64(points, out) bind(c)
      import
      type(vesica_polygon_f64), intent(in) :: points
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> The rectangles of the least area about each polygon or polyline of an array.
    integer(c_int64_t) function vesica_min_area_rect_many_f64(points, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: points
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> The rectangles of the least perimeter about each polygon or polyline of an array.
    integer(c_int64_t) function vesica_min_perimeter_rect_many_f64(points, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: points
      type(vesica_rect_f64), intent(out) :: out
    end function

    !> Rectangles from boxes.
    integer(c_int64_t) function vesica_rects_from_boxes_f32(boxes, count, stride, angle, out) bind(c)
      import
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: out
    end function

    !> Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    integer(c_int64_t) function vesica_ellipses_from_boxes_f32(boxes, count, stride, angle, out) bind(c)
      import
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: out
    end function

    !> Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
    integer(c_int64_t) function vesica_rects_from_corners_f32(corners, count, stride, out) bind(c)
      import
      type(c_ptr), value :: corners
      integer(c_int64_t), value :: count
      integer(c_ptrdiff_t), value :: stride
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
    integer(c_int64_t) function vesica_rect_corners_misfit_many_f32(corners, stride, rects, misfit) bind(c)
      import
      type(c_ptr), value :: corners
      integer(c_ptrdiff_t), value :: stride
      type(vesica_shapes_f32), intent(in) :: rects
      type(c_ptr), value :: misfit
    end function

    !> Boxes from rectangles or from ellipses: the inverse of the first two functions.
    integer(c_int64_t) function vesica_boxes_from_shapes_f32(shapes, angle, boxes) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      integer(c_int32_t), value :: angle
      type(c_ptr), value :: boxes
    end function

    !> The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    integer(c_int64_t) function vesica_corners_of_shapes_f32(shapes, corners) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: corners
    end function

    !> Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
    integer(c_int64_t) function vesica_bounds_many_f32(shapes, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: out
    end function

    !> Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
    integer(c_int64_t) function vesica_shape_area_many_f32(shapes, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: out
    end function

    !> The convex hull of points: the smallest convex polygon that contains them.
    integer(c_int64_t) function vesica_convex_hull_f32(points, out, capacity) bind(c)
      import
      type(vesica_polygon_f32), intent(in) :: points
      type(vesica_point_f32), intent(out) :: out
      integer(c_int64_t), value :: capacity
    end function

    !> The rectangle of the least area that contains points.
    integer(c_int32_t) function vesica_min_area_rect_f32(points, out) bind(c)
      import
      type(vesica_polygon_f32), intent(in) :: points
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
    integer(c_int32_t) function vesica_min_perimeter_rect_f32(points, out) bind(c)
      import
      type(vesica_polygon_f32), intent(in) :: points
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> The rectangles of the least area about each polygon or polyline of an array.
    integer(c_int64_t) function vesica_min_area_rect_many_f32(points, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: points
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> The rectangles of the least perimeter about each polygon or polyline of an array.
    integer(c_int64_t) function vesica_min_perimeter_rect_many_f32(points, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: points
      type(vesica_rect_f32), intent(out) :: out
    end function

    !> All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    !> like.
    integer(c_int64_t) function vesica_join_ratio_f64(ratio, threshold, index_a, sets_a, set_count_a, index_b, &
      sets_b, set_count_b, part, parts, scratch, scratch_size, out_a, out_b, values, capacity, state) bind(c)
      import
      integer(c_int32_t), value :: ratio
      real(c_double), value :: threshold
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> How many bytes of scratch does greedy assignment of `count` pairs need?
    integer(c_int64_t) function vesica_assign_greedy_scratch(count, count_a, count_b) bind(c)
      import
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: count_a
      integer(c_int64_t), value :: count_b
    end function

    !> Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    !> free, until there is none.
    integer(c_int64_t) function vesica_assign_greedy_f64(a, b, values, count, count_a, count_b, scratch, &
      scratch_size, chosen) bind(c)
      import
      type(c_ptr), value :: a
      type(c_ptr), value :: b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: count_a
      integer(c_int64_t), value :: count_b
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: chosen
    end function

    !> How many bytes of scratch does the fusion of `count` boxes need?
    integer(c_int64_t) function vesica_fuse_scratch(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    !> mean.
    integer(c_int32_t) function vesica_fuse_f64(shapes, scores, weights, labels, threshold, fused_score, scratch, &
      scratch_size, fused, fused_scores, clusters, count) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: weights
      type(c_ptr), value :: labels
      real(c_double), value :: threshold
      integer(c_int32_t), value :: fused_score
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: fused
      type(c_ptr), value :: fused_scores
      type(c_ptr), value :: clusters
      type(c_ptr), value :: count
    end function

    !> A ratio of shared volume: IoU and its relatives of two upright prisms.
    integer(c_int32_t) function vesica_volume_ratio_f64(ratio, kind_a, a, span_a, kind_b, b, span_b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      type(vesica_span_f64), intent(in) :: span_a
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_span_f64), intent(in) :: span_b
      type(c_ptr), value :: out
    end function

    !> A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    integer(c_int64_t) function vesica_volume_ratio_many_f64(ratio, a, spans_a, b, spans_b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_span_f64), intent(in) :: spans_a
      type(vesica_shapes_f64), intent(in) :: b
      type(vesica_span_f64), intent(in) :: spans_b
      type(c_ptr), value :: out
    end function

    !> A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    integer(c_int64_t) function vesica_volume_ratio_matrix_f64(ratio, a, spans_a, b, spans_b, out, row_stride) &
      bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_span_f64), intent(in) :: spans_a
      type(vesica_shapes_f64), intent(in) :: b
      type(vesica_span_f64), intent(in) :: spans_b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How many bytes of scratch does matching by `count` pairs need?
    integer(c_int64_t) function vesica_match_truths_scratch(count, detections, truths) bind(c)
      import
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: detections
      integer(c_int64_t), value :: truths
    end function

    !> Which detections hit a truth, at each of some thresholds?
    integer(c_int32_t) function vesica_match_truths_f64(rule, a, b, values, count, scores, detections, flags, &
      truths, thresholds, threshold_count, scratch, scratch_size, outcomes, taken) bind(c)
      import
      integer(c_int32_t), value :: rule
      type(c_ptr), value :: a
      type(c_ptr), value :: b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: count
      type(c_ptr), value :: scores
      integer(c_int64_t), value :: detections
      type(c_ptr), value :: flags
      integer(c_int64_t), value :: truths
      type(c_ptr), value :: thresholds
      integer(c_int64_t), value :: threshold_count
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: outcomes
      type(c_ptr), value :: taken
    end function

    !> How many bytes of scratch does the average precision of `count` detections need?
    integer(c_int64_t) function vesica_average_precision_scratch(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> Average precision (AP) of detections of one class.
    integer(c_int32_t) function vesica_average_precision_f64(rule, scores, outcomes, count, truths, scratch, &
      scratch_size, out) bind(c)
      import
      integer(c_int32_t), value :: rule
      type(c_ptr), value :: scores
      type(c_ptr), value :: outcomes
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: truths
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out
    end function

    !> The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    integer(c_int32_t) function vesica_gaussian_distance_f64(which, kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: which
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
    integer(c_int64_t) function vesica_gaussian_distance_many_f64(which, a, b, out) bind(c)
      import
      integer(c_int32_t), value :: which
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
    integer(c_int64_t) function vesica_gaussian_distance_matrix_f64(which, a, b, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: which
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    !> like.
    integer(c_int64_t) function vesica_join_ratio_f32(ratio, threshold, index_a, sets_a, set_count_a, index_b, &
      sets_b, set_count_b, part, parts, scratch, scratch_size, out_a, out_b, values, capacity, state) bind(c)
      import
      integer(c_int32_t), value :: ratio
      real(c_float), value :: threshold
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    !> free, until there is none.
    integer(c_int64_t) function vesica_assign_greedy_f32(a, b, values, count, count_a, count_b, scratch, &
      scratch_size, chosen) bind(c)
      import
      type(c_ptr), value :: a
      type(c_ptr), value :: b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: count_a
      integer(c_int64_t), value :: count_b
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: chosen
    end function

    !> Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    !> mean.
    integer(c_int32_t) function vesica_fuse_f32(shapes, scores, weights, labels, threshold, fused_score, scratch, &
      scratch_size, fused, fused_scores, clusters, count) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: weights
      type(c_ptr), value :: labels
      real(c_float), value :: threshold
      integer(c_int32_t), value :: fused_score
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: fused
      type(c_ptr), value :: fused_scores
      type(c_ptr), value :: clusters
      type(c_ptr), value :: count
    end function

    !> Which detections hit a truth, at each of some thresholds?
    integer(c_int32_t) function vesica_match_truths_f32(rule, a, b, values, count, scores, detections, flags, &
      truths, thresholds, threshold_count, scratch, scratch_size, outcomes, taken) bind(c)
      import
      integer(c_int32_t), value :: rule
      type(c_ptr), value :: a
      type(c_ptr), value :: b
      type(c_ptr), value :: values
      integer(c_int64_t), value :: count
      type(c_ptr), value :: scores
      integer(c_int64_t), value :: detections
      type(c_ptr), value :: flags
      integer(c_int64_t), value :: truths
      type(c_ptr), value :: thresholds
      integer(c_int64_t), value :: threshold_count
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: outcomes
      type(c_ptr), value :: taken
    end function

    !> Average precision (AP) of detections of one class.
    integer(c_int32_t) function vesica_average_precision_f32(rule, scores, outcomes, count, truths, scratch, &
      scratch_size, out) bind(c)
      import
      integer(c_int32_t), value :: rule
      type(c_ptr), value :: scores
      type(c_ptr), value :: outcomes
      integer(c_int64_t), value :: count
      integer(c_int64_t), value :: truths
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out
    end function

    !> A ratio of shared volume: IoU and its relatives of two upright prisms.
    integer(c_int32_t) function vesica_volume_ratio_f32(ratio, kind_a, a, span_a, kind_b, b, span_b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      type(vesica_span_f32), intent(in) :: span_a
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_span_f32), intent(in) :: span_b
      type(c_ptr), value :: out
    end function

    !> A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    integer(c_int64_t) function vesica_volume_ratio_many_f32(ratio, a, spans_a, b, spans_b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_span_f32), intent(in) :: spans_a
      type(vesica_shapes_f32), intent(in) :: b
      type(vesica_span_f32), intent(in) :: spans_b
      type(c_ptr), value :: out
    end function

    !> A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    integer(c_int64_t) function vesica_volume_ratio_matrix_f32(ratio, a, spans_a, b, spans_b, out, row_stride) &
      bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_span_f32), intent(in) :: spans_a
      type(vesica_shapes_f32), intent(in) :: b
      type(vesica_span_f32), intent(in) :: spans_b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    integer(c_int32_t) function vesica_gaussian_distance_f32(which, kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: which
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
    integer(c_int64_t) function vesica_gaussian_distance_many_f32(which, a, b, out) bind(c)
      import
      integer(c_int32_t), value :: which
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
    integer(c_int64_t) function vesica_gaussian_distance_matrix_f32(which, a, b, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: which
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How many bytes suffice for an index of `count` shapes, of any kinds?
    integer(c_int64_t) function vesica_index_size(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> How many bytes of scratch does building an index of `count` shapes need?
    integer(c_int64_t) function vesica_index_scratch(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> How many bytes of scratch does a join need, whatever its indexes?
    integer(c_int64_t) function vesica_join_scratch() bind(c)
      import
    end function

    !> Are these bytes an index that is safe to read?
    integer(c_int32_t) function vesica_index_check(index, size) bind(c)
      import
      type(c_ptr), value :: index
      integer(c_int64_t), value :: size
    end function

    !> How many bytes does a built index take?
    integer(c_int64_t) function vesica_index_bytes(index) bind(c)
      import
      type(c_ptr), value :: index
    end function

    !> How many shapes was an index built from?
    integer(c_int64_t) function vesica_index_count(index) bind(c)
      import
      type(c_ptr), value :: index
    end function

    !> A box around all valid shapes of an index.
    integer(c_int32_t) function vesica_index_bounds(index, out) bind(c)
      import
      type(c_ptr), value :: index
      type(vesica_aabb_f64), intent(out) :: out
    end function

    !> The items of an index in spatial order: shapes near each other have nearby places in it.
    integer(c_int64_t) function vesica_index_order(index, out, capacity) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> Builds the index of some sets of shapes.
    integer(c_int64_t) function vesica_index_build_f64(sets, set_count, index, index_size, scratch, scratch_size) &
      bind(c)
      import
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(c_ptr), value :: index
      integer(c_int64_t), value :: index_size
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
    end function

    !> One part of a build by several threads, in five steps.
    integer(c_int64_t) function vesica_index_step_f64(step, part, parts, sets, set_count, index, index_size, &
      scratch, scratch_size) bind(c)
      import
      integer(c_int32_t), value :: step
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(c_ptr), value :: index
      integer(c_int64_t), value :: index_size
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
    end function

    !> Which items of an index does one shape overlap?
    integer(c_int64_t) function vesica_index_select_f64(index, sets, set_count, one, out, capacity, state) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f64), intent(in) :: one
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    integer(c_int64_t) function vesica_join_f64(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, &
      part, parts, scratch, scratch_size, out_a, out_b, capacity, state) bind(c)
      import
      integer(c_int32_t), value :: query
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once:
    !> those for which vesica_within_f64 is > 0.
    integer(c_int64_t) function vesica_join_within_f64(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, &
      distance, part, parts, out_a, out_b, capacity, state) bind(c)
      import
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      real(c_double), value :: distance
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Which items of an index are nearest to one shape?
    integer(c_int64_t) function vesica_index_nearest_f64(index, sets, set_count, one, k, within, out, distance) &
      bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f64), intent(in) :: one
      integer(c_int64_t), value :: k
      real(c_double), value :: within
      type(c_ptr), value :: out
      type(c_ptr), value :: distance
    end function

    !> Which items of index_b are nearest to each item of sets_a?
    integer(c_int64_t) function vesica_join_nearest_f64(sets_a, set_count_a, index_b, sets_b, set_count_b, k, &
      within, part, parts, out, distance) bind(c)
      import
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: k
      real(c_double), value :: within
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: out
      type(c_ptr), value :: distance
    end function

    !> How many bytes do the boxes of a polygon or a polyline take?
    integer(c_int64_t) function vesica_polygon_boxes_size(vertices) bind(c)
      import
      integer(c_int64_t), value :: vertices
    end function

    !> Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    !> zone.
    integer(c_int32_t) function vesica_polygon_boxes_f64(kind, path, boxes, size) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
    end function

    !> Does a path with boxes overlap another shape?
    integer(c_int32_t) function vesica_polygon_boxes_overlap_f64(kind, path, boxes, size, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
    end function

    !> The distance of a path with boxes and another shape, and where it is.
    integer(c_int32_t) function vesica_polygon_boxes_nearest_f64(kind, path, boxes, size, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_closest_points_f64), intent(out) :: out
    end function

    !> Are a path with boxes and another shape at most a distance apart?
    integer(c_int32_t) function vesica_polygon_boxes_within_f64(kind, path, boxes, size, kind_b, b, distance) &
      bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      real(c_double), value :: distance
    end function

    !> Builds the index of some sets of shapes.
    integer(c_int64_t) function vesica_index_build_f32(sets, set_count, index, index_size, scratch, scratch_size) &
      bind(c)
      import
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(c_ptr), value :: index
      integer(c_int64_t), value :: index_size
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
    end function

    !> One part of a build by several threads, in five steps.
    integer(c_int64_t) function vesica_index_step_f32(step, part, parts, sets, set_count, index, index_size, &
      scratch, scratch_size) bind(c)
      import
      integer(c_int32_t), value :: step
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(c_ptr), value :: index
      integer(c_int64_t), value :: index_size
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
    end function

    !> Which items of an index does one shape overlap?
    integer(c_int64_t) function vesica_index_select_f32(index, sets, set_count, one, out, capacity, state) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f32), intent(in) :: one
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    integer(c_int64_t) function vesica_join_f32(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, &
      part, parts, scratch, scratch_size, out_a, out_b, capacity, state) bind(c)
      import
      integer(c_int32_t), value :: query
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once:
    !> those for which vesica_within_f32 is > 0.
    integer(c_int64_t) function vesica_join_within_f32(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, &
      distance, part, parts, out_a, out_b, capacity, state) bind(c)
      import
      type(c_ptr), value :: index_a
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      real(c_float), value :: distance
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: out_a
      type(c_ptr), value :: out_b
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Which items of an index are nearest to one shape?
    integer(c_int64_t) function vesica_index_nearest_f32(index, sets, set_count, one, k, within, out, distance) &
      bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f32), intent(in) :: one
      integer(c_int64_t), value :: k
      real(c_float), value :: within
      type(c_ptr), value :: out
      type(c_ptr), value :: distance
    end function

    !> Which items of index_b are nearest to each item of sets_a?
    integer(c_int64_t) function vesica_join_nearest_f32(sets_a, set_count_a, index_b, sets_b, set_count_b, k, &
      within, part, parts, out, distance) bind(c)
      import
      type(c_ptr), value :: sets_a
      integer(c_int32_t), value :: set_count_a
      type(c_ptr), value :: index_b
      type(c_ptr), value :: sets_b
      integer(c_int32_t), value :: set_count_b
      integer(c_int64_t), value :: k
      real(c_float), value :: within
      integer(c_int64_t), value :: part
      integer(c_int64_t), value :: parts
      type(c_ptr), value :: out
      type(c_ptr), value :: distance
    end function

    !> Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    !> zone.
    integer(c_int32_t) function vesica_polygon_boxes_f32(kind, path, boxes, size) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
    end function

    !> Does a path with boxes overlap another shape?
    integer(c_int32_t) function vesica_polygon_boxes_overlap_f32(kind, path, boxes, size, kind_b, b) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
    end function

    !> The distance of a path with boxes and another shape, and where it is.
    integer(c_int32_t) function vesica_polygon_boxes_nearest_f32(kind, path, boxes, size, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_closest_points_f32), intent(out) :: out
    end function

    !> Are a path with boxes and another shape at most a distance apart?
    integer(c_int32_t) function vesica_polygon_boxes_within_f32(kind, path, boxes, size, kind_b, b, distance) &
      bind(c)
      import
      integer(c_int32_t), value :: kind
      type(c_ptr), value :: path
      type(c_ptr), value :: boxes
      integer(c_int64_t), value :: size
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      real(c_float), value :: distance
    end function

    !> A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    integer(c_int32_t) function vesica_ratio_f64(ratio, kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
    integer(c_int64_t) function vesica_ratio_many_f64(ratio, a, b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
    integer(c_int64_t) function vesica_ratio_matrix_f64(ratio, a, b, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How far apart are a[i] and b[j]?
    integer(c_int64_t) function vesica_nearest_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How far apart are the outlines of a[i] and b[j]?
    integer(c_int64_t) function vesica_boundary_distance_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How deep do a[i] and b[j] overlap?
    integer(c_int64_t) function vesica_depth_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    integer(c_int32_t) function vesica_signed_distance_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Signed distances of a[i] and b[i].
    integer(c_int64_t) function vesica_signed_distance_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Signed distances of a[i] and b[j].
    integer(c_int64_t) function vesica_signed_distance_matrix_f64(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Are two shapes at most `distance` apart?
    integer(c_int32_t) function vesica_within_f64(kind_a, a, kind_b, b, distance) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      real(c_double), value :: distance
    end function

    !> Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
    integer(c_int64_t) function vesica_within_many_f64(a, b, distance, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      real(c_double), value :: distance
      type(c_ptr), value :: out
    end function

    !> Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
    integer(c_int64_t) function vesica_within_matrix_f64(a, b, distance, out, row_stride) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      real(c_double), value :: distance
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
    integer(c_int32_t) function vesica_suppress_f64(shapes, scores, labels, ratio, threshold, least_score, most, &
      scratch, scratch_size, keep, kept) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: labels
      integer(c_int32_t), value :: ratio
      real(c_double), value :: threshold
      real(c_double), value :: least_score
      integer(c_int64_t), value :: most
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: kept
    end function

    !> How many bytes of scratch does soft suppression of `count` shapes need?
    integer(c_int64_t) function vesica_suppress_soft_scratch(count) bind(c)
      import
      integer(c_int64_t), value :: count
    end function

    !> Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    integer(c_int32_t) function vesica_suppress_soft_f64(shapes, scores, labels, ratio, decay, parameter, &
      least_score, most, scratch, scratch_size, keep, decayed, kept) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: labels
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: decay
      real(c_double), value :: parameter
      real(c_double), value :: least_score
      integer(c_int64_t), value :: most
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: decayed
      type(c_ptr), value :: kept
    end function

    !> The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    integer(c_int32_t) function vesica_coverage_f64(kind, shape, grid, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
      type(vesica_grid_f64), intent(in) :: grid
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
    integer(c_int64_t) function vesica_coverage_cells_f64(kind, shape, grid, cells, shares, capacity) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
      type(vesica_grid_f64), intent(in) :: grid
      type(c_ptr), value :: cells
      type(c_ptr), value :: shares
      integer(c_int64_t), value :: capacity
    end function

    !> A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    integer(c_int32_t) function vesica_ratio_f32(ratio, kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
    integer(c_int64_t) function vesica_ratio_many_f32(ratio, a, b, out) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
    integer(c_int64_t) function vesica_ratio_matrix_f32(ratio, a, b, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: ratio
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How far apart are a[i] and b[j]?
    integer(c_int64_t) function vesica_nearest_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How far apart are the outlines of a[i] and b[j]?
    integer(c_int64_t) function vesica_boundary_distance_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> How deep do a[i] and b[j] overlap?
    integer(c_int64_t) function vesica_depth_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
    integer(c_int32_t) function vesica_suppress_f32(shapes, scores, labels, ratio, threshold, least_score, most, &
      scratch, scratch_size, keep, kept) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: labels
      integer(c_int32_t), value :: ratio
      real(c_float), value :: threshold
      real(c_float), value :: least_score
      integer(c_int64_t), value :: most
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: kept
    end function

    !> Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    integer(c_int32_t) function vesica_signed_distance_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
    end function

    !> Signed distances of a[i] and b[i].
    integer(c_int64_t) function vesica_signed_distance_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
    end function

    !> Signed distances of a[i] and b[j].
    integer(c_int64_t) function vesica_signed_distance_matrix_f32(a, b, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Are two shapes at most `distance` apart?
    integer(c_int32_t) function vesica_within_f32(kind_a, a, kind_b, b, distance) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      real(c_float), value :: distance
    end function

    !> Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
    integer(c_int64_t) function vesica_within_many_f32(a, b, distance, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      real(c_float), value :: distance
      type(c_ptr), value :: out
    end function

    !> Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
    integer(c_int64_t) function vesica_within_matrix_f32(a, b, distance, out, row_stride) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      real(c_float), value :: distance
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    integer(c_int32_t) function vesica_suppress_soft_f32(shapes, scores, labels, ratio, decay, parameter, &
      least_score, most, scratch, scratch_size, keep, decayed, kept) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: shapes
      type(c_ptr), value :: scores
      type(c_ptr), value :: labels
      integer(c_int32_t), value :: ratio
      integer(c_int32_t), value :: decay
      real(c_float), value :: parameter
      real(c_float), value :: least_score
      integer(c_int64_t), value :: most
      type(c_ptr), value :: scratch
      integer(c_int64_t), value :: scratch_size
      type(c_ptr), value :: keep
      type(c_ptr), value :: decayed
      type(c_ptr), value :: kept
    end function

    !> The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    integer(c_int32_t) function vesica_coverage_f32(kind, shape, grid, out, row_stride) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
      type(vesica_grid_f32), intent(in) :: grid
      type(c_ptr), value :: out
      integer(c_ptrdiff_t), value :: row_stride
    end function

    !> The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
    integer(c_int64_t) function vesica_coverage_cells_f32(kind, shape, grid, cells, shares, capacity) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
      type(vesica_grid_f32), intent(in) :: grid
      type(c_ptr), value :: cells
      type(c_ptr), value :: shares
      integer(c_int64_t), value :: capacity
    end function

    !> Does b touch a while it moves, when first, and where?
    integer(c_int32_t) function vesica_cast_f64(kind_a, a, kind_b, b, vx, vy, t_end, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    integer(c_int64_t) function vesica_cast_many_f64(a, b, vx, vy, stride, t_end, t, x, y, nx, ny) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(c_ptr), value :: vx
      type(c_ptr), value :: vy
      integer(c_ptrdiff_t), value :: stride
      real(c_double), value :: t_end
      type(c_ptr), value :: t
      type(c_ptr), value :: x
      type(c_ptr), value :: y
      type(c_ptr), value :: nx
      type(c_ptr), value :: ny
    end function

    !> Which of many shapes at rest does one moving shape touch first?
    integer(c_int64_t) function vesica_cast_first_f64(one, many, vx, vy, t_end, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: one
      type(vesica_shapes_f64), intent(in) :: many
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A box that holds a shape throughout its motion, t from 0 to t_end.
    integer(c_int32_t) function vesica_sweep_bounds_f64(kind, shape, vx, vy, t_end, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_double), intent(in) :: shape(*)
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_aabb_f64), intent(out) :: out
    end function

    !> Which items of an index does one moving shape touch?
    integer(c_int64_t) function vesica_index_cast_f64(index, sets, set_count, one, vx, vy, t_end, out, capacity, &
      state) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f64), intent(in) :: one
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Which item of an index does one moving shape touch first?
    integer(c_int64_t) function vesica_index_cast_first_f64(index, sets, set_count, one, vx, vy, t_end, out) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f64), intent(in) :: one
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> When do two shapes that move and turn touch first?
    integer(c_int32_t) function vesica_impact_time_f64(kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap) &
      bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      type(vesica_turn_f64), intent(in) :: turn_a
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_turn_f64), intent(in) :: turn_b
      real(c_double), value :: tolerance
      type(vesica_impact_f64), intent(out) :: out
      type(c_ptr), value :: gap
    end function

    !> Which item of an index does a shape that moves and turns touch first?
    integer(c_int64_t) function vesica_index_impact_time_f64(index, sets, set_count, one, turn, tolerance, out, gap, &
      answer) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f64), intent(in) :: one
      type(vesica_turn_f64), intent(in) :: turn
      real(c_double), value :: tolerance
      type(vesica_impact_f64), intent(out) :: out
      type(c_ptr), value :: gap
      type(c_ptr), value :: answer
    end function

    !> Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    integer(c_int32_t) function vesica_manifold_f64(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(vesica_contacts_f64), intent(out) :: out
    end function

    !> The contacts of a[i] and b[i].
    integer(c_int64_t) function vesica_manifold_many_f64(a, b, out) bind(c)
      import
      type(vesica_shapes_f64), intent(in) :: a
      type(vesica_shapes_f64), intent(in) :: b
      type(vesica_contacts_f64), intent(out) :: out
    end function

    !> A ray at a point.
    integer(c_int32_t) function vesica_cast_point_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_point_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A ray at a segment.
    integer(c_int32_t) function vesica_cast_segment_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_segment_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A ray at a disc.
    integer(c_int32_t) function vesica_cast_circle_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A ray at an axis-aligned box.
    integer(c_int32_t) function vesica_cast_aabb_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_aabb_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A ray at a rectangle.
    integer(c_int32_t) function vesica_cast_rect_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_rect_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> A ray at an ellipse.
    integer(c_int32_t) function vesica_cast_ellipse_point_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_ellipse_f64), intent(in) :: a
      type(vesica_point_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> Two discs.
    integer(c_int32_t) function vesica_cast_circle_circle_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_circle_f64), intent(in) :: a
      type(vesica_circle_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> Two rectangles.
    integer(c_int32_t) function vesica_cast_rect_rect_f64(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_rect_f64), intent(in) :: a
      type(vesica_rect_f64), intent(in) :: b
      real(c_double), value :: vx
      real(c_double), value :: vy
      real(c_double), value :: t_end
      type(vesica_impact_f64), intent(out) :: out
    end function

    !> Does b touch a while it moves, when first, and where?
    integer(c_int32_t) function vesica_cast_f32(kind_a, a, kind_b, b, vx, vy, t_end, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    integer(c_int64_t) function vesica_cast_many_f32(a, b, vx, vy, stride, t_end, t, x, y, nx, ny) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(c_ptr), value :: vx
      type(c_ptr), value :: vy
      integer(c_ptrdiff_t), value :: stride
      real(c_float), value :: t_end
      type(c_ptr), value :: t
      type(c_ptr), value :: x
      type(c_ptr), value :: y
      type(c_ptr), value :: nx
      type(c_ptr), value :: ny
    end function

    !> Which of many shapes at rest does one moving shape touch first?
    integer(c_int64_t) function vesica_cast_first_f32(one, many, vx, vy, t_end, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: one
      type(vesica_shapes_f32), intent(in) :: many
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A box that holds a shape throughout its motion, t from 0 to t_end.
    integer(c_int32_t) function vesica_sweep_bounds_f32(kind, shape, vx, vy, t_end, out) bind(c)
      import
      integer(c_int32_t), value :: kind
      real(c_float), intent(in) :: shape(*)
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_aabb_f32), intent(out) :: out
    end function

    !> Which items of an index does one moving shape touch?
    integer(c_int64_t) function vesica_index_cast_f32(index, sets, set_count, one, vx, vy, t_end, out, capacity, &
      state) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f32), intent(in) :: one
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
      type(c_ptr), value :: state
    end function

    !> Which item of an index does one moving shape touch first?
    integer(c_int64_t) function vesica_index_cast_first_f32(index, sets, set_count, one, vx, vy, t_end, out) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f32), intent(in) :: one
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> As vesica_impact_time_f64.
    integer(c_int32_t) function vesica_impact_time_f32(kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap) &
      bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      type(vesica_turn_f32), intent(in) :: turn_a
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_turn_f32), intent(in) :: turn_b
      real(c_float), value :: tolerance
      type(vesica_impact_f32), intent(out) :: out
      type(c_ptr), value :: gap
    end function

    !> Which item of an index does a shape that moves and turns touch first?
    integer(c_int64_t) function vesica_index_impact_time_f32(index, sets, set_count, one, turn, tolerance, out, gap, &
      answer) bind(c)
      import
      type(c_ptr), value :: index
      type(c_ptr), value :: sets
      integer(c_int32_t), value :: set_count
      type(vesica_shapes_f32), intent(in) :: one
      type(vesica_turn_f32), intent(in) :: turn
      real(c_float), value :: tolerance
      type(vesica_impact_f32), intent(out) :: out
      type(c_ptr), value :: gap
      type(c_ptr), value :: answer
    end function

    !> Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    integer(c_int32_t) function vesica_manifold_f32(kind_a, a, kind_b, b, out) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(vesica_contacts_f32), intent(out) :: out
    end function

    !> The contacts of a[i] and b[i].
    integer(c_int64_t) function vesica_manifold_many_f32(a, b, out) bind(c)
      import
      type(vesica_shapes_f32), intent(in) :: a
      type(vesica_shapes_f32), intent(in) :: b
      type(vesica_contacts_f32), intent(out) :: out
    end function

    !> A ray at a point.
    integer(c_int32_t) function vesica_cast_point_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_point_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A ray at a segment.
    integer(c_int32_t) function vesica_cast_segment_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_segment_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A ray at a disc.
    integer(c_int32_t) function vesica_cast_circle_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A ray at an axis-aligned box.
    integer(c_int32_t) function vesica_cast_aabb_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_aabb_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A ray at a rectangle.
    integer(c_int32_t) function vesica_cast_rect_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_rect_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> A ray at an ellipse.
    integer(c_int32_t) function vesica_cast_ellipse_point_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_ellipse_f32), intent(in) :: a
      type(vesica_point_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> Two discs.
    integer(c_int32_t) function vesica_cast_circle_circle_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_circle_f32), intent(in) :: a
      type(vesica_circle_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> Two rectangles.
    integer(c_int32_t) function vesica_cast_rect_rect_f32(a, b, vx, vy, t_end, out) bind(c)
      import
      type(vesica_rect_f32), intent(in) :: a
      type(vesica_rect_f32), intent(in) :: b
      real(c_float), value :: vx
      real(c_float), value :: vy
      real(c_float), value :: t_end
      type(vesica_impact_f32), intent(out) :: out
    end function

    !> The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    integer(c_int32_t) function vesica_de9im_f64(kind_a, a, kind_b, b, matrix) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: matrix
    end function

    !> Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
    integer(c_int32_t) function vesica_de9im_match(matrix, pattern) bind(c)
      import
      type(c_ptr), value :: matrix
      type(c_ptr), value :: pattern
    end function

    !> The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    integer(c_int64_t) function vesica_intersection_f64(kind_a, a, kind_b, b, out, capacity) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_double), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_double), intent(in) :: b(*)
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function

    !> The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    integer(c_int32_t) function vesica_de9im_f32(kind_a, a, kind_b, b, matrix) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: matrix
    end function

    !> The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    integer(c_int64_t) function vesica_intersection_f32(kind_a, a, kind_b, b, out, capacity) bind(c)
      import
      integer(c_int32_t), value :: kind_a
      real(c_float), intent(in) :: a(*)
      integer(c_int32_t), value :: kind_b
      real(c_float), intent(in) :: b(*)
      type(c_ptr), value :: out
      integer(c_int64_t), value :: capacity
    end function
  end interface
end module
