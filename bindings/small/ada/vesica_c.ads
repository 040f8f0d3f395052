--  SPDX-License-Identifier: Apache-2.0
--  Written by bindings/declare from capi/vesica.json: not to be edited.
--  The constants, records and functions of libvesica. A pointer is an address: Null_Address where
--  the header allows NULL.
with Interfaces; use Interfaces;
with Interfaces.C; use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System;

package Vesica_C is

   Vesica_Declared_Version_Major : constant := 0;
   Vesica_Declared_Version_Minor : constant := 1;
   Vesica_Declared_Version_Patch : constant := 0;
   Vesica_Declared_Version : constant := 100;
   Vesica_Point : constant := 0;
   Vesica_Segment : constant := 1;
   Vesica_Circle : constant := 2;
   Vesica_Aabb : constant := 3;
   Vesica_Rect : constant := 4;
   Vesica_Ellipse : constant := 5;
   Vesica_Capsule : constant := 6;
   Vesica_Round_Rect : constant := 7;
   Vesica_Polygon : constant := 8;
   Vesica_Polyline : constant := 9;
   Vesica_Disjoint : constant := 0;
   Vesica_Touch : constant := 1;
   Vesica_Cross : constant := 2;
   Vesica_Inside : constant := 3;
   Vesica_Inside_Touch : constant := 4;
   Vesica_Contains : constant := 5;
   Vesica_Contains_Touch : constant := 6;
   Vesica_Equal : constant := 7;
   Vesica_E_Null : constant := -1;
   Vesica_E_Shape : constant := -2;
   Vesica_E_Kind : constant := -3;
   Vesica_E_Argument : constant := -4;
   Vesica_E_Not_Finite : constant := -5;
   Vesica_E_Negative_Size : constant := -6;
   Vesica_E_Zero_Axis : constant := -7;
   Vesica_E_Inverted : constant := -8;
   Vesica_E_Range : constant := -9;
   Vesica_E_Index : constant := -10;
   Vesica_E_Rings : constant := -11;
   Vesica_E_Not_Simple : constant := -12;
   Vesica_E_Not_Convex : constant := -13;
   Vesica_Angle_Radians : constant := 0;
   Vesica_Angle_Degrees : constant := 1;
   Vesica_Angle_Quarters : constant := 2;
   Vesica_Angle_Reversed : constant := 4;
   Vesica_Fused_Mean : constant := 0;
   Vesica_Fused_Max : constant := 1;
   Vesica_Match_Voc : constant := 0;
   Vesica_Match_Coco : constant := 1;
   Vesica_Truth_Counts : constant := 0;
   Vesica_Truth_Crowd : constant := 1;
   Vesica_Truth_Ignored : constant := 2;
   Vesica_Outcome_Miss : constant := 0;
   Vesica_Outcome_Hit : constant := 1;
   Vesica_Outcome_Ignored : constant := 2;
   Vesica_Precision_Voc_2007 : constant := 0;
   Vesica_Precision_Voc_2010 : constant := 1;
   Vesica_Precision_Coco : constant := 2;
   Vesica_Gaussian_Bhattacharyya : constant := 0;
   Vesica_Gaussian_Hellinger : constant := 1;
   Vesica_Gaussian_Kullback_Leibler : constant := 2;
   Vesica_Gaussian_Wasserstein : constant := 3;
   Vesica_Join_Overlap : constant := 0;
   Vesica_Join_Bounds : constant := 1;
   Vesica_Join_Contains : constant := 2;
   Vesica_Join_Inside : constant := 3;
   Vesica_Join_Interiors : constant := 4;
   Vesica_Ratio_Over_Union : constant := 0;
   Vesica_Ratio_Over_First : constant := 1;
   Vesica_Ratio_Over_Second : constant := 2;
   Vesica_Ratio_Over_Smaller : constant := 3;
   Vesica_Ratio_Generalized : constant := 4;
   Vesica_Ratio_Distance : constant := 5;
   Vesica_Ratio_Complete : constant := 6;
   Vesica_Within_No : constant := 0;
   Vesica_Within_Yes : constant := 1;
   Vesica_Within_Nearly : constant := 2;
   Vesica_Decay_Linear : constant := 0;
   Vesica_Decay_Gaussian : constant := 1;
   Vesica_Cast_Miss : constant := 0;
   Vesica_Cast_Hit : constant := 1;
   Vesica_Cast_Start : constant := 2;
   Vesica_Cast_Near : constant := 3;
   Vesica_De9im_Size : constant := 10;

   type Doubles_8 is array (1 .. 8) of IEEE_Float_64 with Convention => C;
   type Floats_8 is array (1 .. 8) of IEEE_Float_32 with Convention => C;
   type Addresses_8 is array (1 .. 8) of System.Address with Convention => C;

   --  A location.
   type Vesica_Point_F64 is record
      X : IEEE_Float_64;
      Y : IEEE_Float_64;
   end record with Convention => C;

   --  All points between two end points.
   type Vesica_Segment_F64 is record
      X0 : IEEE_Float_64;
      Y0 : IEEE_Float_64;
      X1 : IEEE_Float_64;
      Y1 : IEEE_Float_64;
   end record with Convention => C;

   --  A disc: centre and radius, r >= 0.
   type Vesica_Circle_F64 is record
      Cx : IEEE_Float_64;
      Cy : IEEE_Float_64;
      R : IEEE_Float_64;
   end record with Convention => C;

   --  A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
   type Vesica_Aabb_F64 is record
      Min_X : IEEE_Float_64;
      Min_Y : IEEE_Float_64;
      Max_X : IEEE_Float_64;
      Max_Y : IEEE_Float_64;
   end record with Convention => C;

   --  All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
   type Vesica_Rect_F64 is record
      Cx : IEEE_Float_64;
      Cy : IEEE_Float_64;
      Ux : IEEE_Float_64;
      Uy : IEEE_Float_64;
      Hx : IEEE_Float_64;
      Hy : IEEE_Float_64;
   end record with Convention => C;

   --  All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
   type Vesica_Ellipse_F64 is record
      Cx : IEEE_Float_64;
      Cy : IEEE_Float_64;
      Ux : IEEE_Float_64;
      Uy : IEEE_Float_64;
      A : IEEE_Float_64;
      B : IEEE_Float_64;
   end record with Convention => C;

   --  All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
   type Vesica_Capsule_F64 is record
      X0 : IEEE_Float_64;
      Y0 : IEEE_Float_64;
      X1 : IEEE_Float_64;
      Y1 : IEEE_Float_64;
      R : IEEE_Float_64;
   end record with Convention => C;

   --  All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are
   --  the rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
   type Vesica_Round_Rect_F64 is record
      Cx : IEEE_Float_64;
      Cy : IEEE_Float_64;
      Ux : IEEE_Float_64;
      Uy : IEEE_Float_64;
      Hx : IEEE_Float_64;
      Hy : IEEE_Float_64;
      R : IEEE_Float_64;
   end record with Convention => C;

   --  A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
   type Vesica_Polygon_F64 is record
      X : System.Address;
      Y : System.Address;
      Stride : ptrdiff_t;
      Rings : System.Address;
      Count : Integer_64;
   end record with Convention => C;

   --  A polyline.
   type Vesica_Polyline_F64 is record
      X : System.Address;
      Y : System.Address;
      Stride : ptrdiff_t;
      Rings : System.Address;
      Count : Integer_64;
   end record with Convention => C;

   --  Facts about a polygon, from vesica_polygon_facts_f64.
   type Vesica_Facts_F64 is record
      Vertices : Integer_64;
      First_Crossing : Integer_64;
      Second_Crossing : Integer_64;
      Area : IEEE_Float_64;
      Orientation : Integer_32;
      Convex : Integer_32;
      Simple : Integer_32;
      Rings : Integer_32;
   end record with Convention => C;

   --  A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
   type Vesica_Closest_Points_F64 is record
      Distance : IEEE_Float_64;
      Ax : IEEE_Float_64;
      Ay : IEEE_Float_64;
      Bx : IEEE_Float_64;
      By : IEEE_Float_64;
   end record with Convention => C;

   --  The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
   type Vesica_Penetration_F64 is record
      Depth : IEEE_Float_64;
      X : IEEE_Float_64;
      Y : IEEE_Float_64;
   end record with Convention => C;

   --  An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
   type Vesica_Shapes_F64 is record
      Kind : Integer_32;
      Reserved : Integer_32;
      Count : Integer_64;
      Stride : ptrdiff_t;
      Field : Addresses_8;
      Rings : System.Address;
      Polygons : System.Address;
      Each : Integer_64;
   end record with Convention => C;

   --  A location.
   type Vesica_Point_F32 is record
      X : IEEE_Float_32;
      Y : IEEE_Float_32;
   end record with Convention => C;

   --  All points between two end points.
   type Vesica_Segment_F32 is record
      X0 : IEEE_Float_32;
      Y0 : IEEE_Float_32;
      X1 : IEEE_Float_32;
      Y1 : IEEE_Float_32;
   end record with Convention => C;

   --  A disc: centre and radius, r >= 0.
   type Vesica_Circle_F32 is record
      Cx : IEEE_Float_32;
      Cy : IEEE_Float_32;
      R : IEEE_Float_32;
   end record with Convention => C;

   --  A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
   type Vesica_Aabb_F32 is record
      Min_X : IEEE_Float_32;
      Min_Y : IEEE_Float_32;
      Max_X : IEEE_Float_32;
      Max_Y : IEEE_Float_32;
   end record with Convention => C;

   --  All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
   type Vesica_Rect_F32 is record
      Cx : IEEE_Float_32;
      Cy : IEEE_Float_32;
      Ux : IEEE_Float_32;
      Uy : IEEE_Float_32;
      Hx : IEEE_Float_32;
      Hy : IEEE_Float_32;
   end record with Convention => C;

   --  All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
   type Vesica_Ellipse_F32 is record
      Cx : IEEE_Float_32;
      Cy : IEEE_Float_32;
      Ux : IEEE_Float_32;
      Uy : IEEE_Float_32;
      A : IEEE_Float_32;
      B : IEEE_Float_32;
   end record with Convention => C;

   --  All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
   type Vesica_Capsule_F32 is record
      X0 : IEEE_Float_32;
      Y0 : IEEE_Float_32;
      X1 : IEEE_Float_32;
      Y1 : IEEE_Float_32;
      R : IEEE_Float_32;
   end record with Convention => C;

   --  All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are
   --  the rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
   type Vesica_Round_Rect_F32 is record
      Cx : IEEE_Float_32;
      Cy : IEEE_Float_32;
      Ux : IEEE_Float_32;
      Uy : IEEE_Float_32;
      Hx : IEEE_Float_32;
      Hy : IEEE_Float_32;
      R : IEEE_Float_32;
   end record with Convention => C;

   --  A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
   type Vesica_Polygon_F32 is record
      X : System.Address;
      Y : System.Address;
      Stride : ptrdiff_t;
      Rings : System.Address;
      Count : Integer_64;
   end record with Convention => C;

   --  A polyline.
   type Vesica_Polyline_F32 is record
      X : System.Address;
      Y : System.Address;
      Stride : ptrdiff_t;
      Rings : System.Address;
      Count : Integer_64;
   end record with Convention => C;

   --  Facts about a polygon, from vesica_polygon_facts_f32.
   type Vesica_Facts_F32 is record
      Vertices : Integer_64;
      First_Crossing : Integer_64;
      Second_Crossing : Integer_64;
      Area : IEEE_Float_32;
      Orientation : Integer_32;
      Convex : Integer_32;
      Simple : Integer_32;
      Rings : Integer_32;
   end record with Convention => C;

   --  A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
   type Vesica_Closest_Points_F32 is record
      Distance : IEEE_Float_32;
      Ax : IEEE_Float_32;
      Ay : IEEE_Float_32;
      Bx : IEEE_Float_32;
      By : IEEE_Float_32;
   end record with Convention => C;

   --  The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
   type Vesica_Penetration_F32 is record
      Depth : IEEE_Float_32;
      X : IEEE_Float_32;
      Y : IEEE_Float_32;
   end record with Convention => C;

   --  An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
   type Vesica_Shapes_F32 is record
      Kind : Integer_32;
      Reserved : Integer_32;
      Count : Integer_64;
      Stride : ptrdiff_t;
      Field : Addresses_8;
      Rings : System.Address;
      Polygons : System.Address;
      Each : Integer_64;
   end record with Convention => C;

   --  All heights from low to high; low <= high, both finite.
   type Vesica_Span_F64 is record
      Low : IEEE_Float_64;
      High : IEEE_Float_64;
   end record with Convention => C;

   --  All heights from low to high; low <= high, both finite.
   type Vesica_Span_F32 is record
      Low : IEEE_Float_32;
      High : IEEE_Float_32;
   end record with Convention => C;

   --  A grid of cells, such as the pixels of a picture.
   type Vesica_Grid_F64 is record
      X : IEEE_Float_64;
      Y : IEEE_Float_64;
      Dx : IEEE_Float_64;
      Dy : IEEE_Float_64;
      Columns : Integer_64;
      Rows : Integer_64;
   end record with Convention => C;

   --  A grid of cells, such as the pixels of a picture.
   type Vesica_Grid_F32 is record
      X : IEEE_Float_32;
      Y : IEEE_Float_32;
      Dx : IEEE_Float_32;
      Dy : IEEE_Float_32;
      Columns : Integer_64;
      Rows : Integer_64;
   end record with Convention => C;

   --  A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
   type Vesica_Impact_F64 is record
      T : IEEE_Float_64;
      X : IEEE_Float_64;
      Y : IEEE_Float_64;
      Nx : IEEE_Float_64;
      Ny : IEEE_Float_64;
   end record with Convention => C;

   --  How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which
   --  it turns about its centre.
   type Vesica_Turn_F64 is record
      Vx : IEEE_Float_64;
      Vy : IEEE_Float_64;
      Angle : IEEE_Float_64;
   end record with Convention => C;

   --  The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
   type Vesica_Contacts_F64 is record
      Nx : IEEE_Float_64;
      Ny : IEEE_Float_64;
      X0 : IEEE_Float_64;
      Y0 : IEEE_Float_64;
      Depth0 : IEEE_Float_64;
      X1 : IEEE_Float_64;
      Y1 : IEEE_Float_64;
      Depth1 : IEEE_Float_64;
      A0 : Integer_64;
      B0 : Integer_64;
      A1 : Integer_64;
      B1 : Integer_64;
      Count : Integer_64;
   end record with Convention => C;

   --  A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
   type Vesica_Impact_F32 is record
      T : IEEE_Float_32;
      X : IEEE_Float_32;
      Y : IEEE_Float_32;
      Nx : IEEE_Float_32;
      Ny : IEEE_Float_32;
   end record with Convention => C;

   --  How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which
   --  it turns about its centre.
   type Vesica_Turn_F32 is record
      Vx : IEEE_Float_32;
      Vy : IEEE_Float_32;
      Angle : IEEE_Float_32;
   end record with Convention => C;

   --  The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
   type Vesica_Contacts_F32 is record
      Nx : IEEE_Float_32;
      Ny : IEEE_Float_32;
      X0 : IEEE_Float_32;
      Y0 : IEEE_Float_32;
      Depth0 : IEEE_Float_32;
      X1 : IEEE_Float_32;
      Y1 : IEEE_Float_32;
      Depth1 : IEEE_Float_32;
      A0 : Integer_64;
      B0 : Integer_64;
      A1 : Integer_64;
      B1 : Integer_64;
      Count : Integer_64;
   end record with Convention => C;

   --  Do two shapes share a point?
   function Vesica_Overlap_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address)
      return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_f64";

   --  Do the insides of two shapes share a point?
   function Vesica_Interiors_Overlap_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_f64";

   --  Does a contain all of b?
   function Vesica_Contains_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_contains_f64";

   --  How does a relate to b?
   function Vesica_Relation_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_relation_f64";

   --  How far apart are two solid shapes, and which of their points are closest?
   function Vesica_Nearest_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_nearest_f64";

   --  Penetration depth: how far and which way must b be moved until the two shapes only touch?
   function Vesica_Depth_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_depth_f64";

   --  Area of the intersection of two shapes.
   function Vesica_Area_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_area_f64";

   --  Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
   function Vesica_Iou_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_iou_f64";

   --  Smallest box of representable numbers that contains a shape.
   function Vesica_Bounds_F64 (Kind : Integer_32; Shape : System.Address; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_bounds_f64";

   --  Is a shape valid, and if not, which rule does it break?
   function Vesica_Check_F64 (Kind : Integer_32; Shape : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_check_f64";

   --  The meaning of an error code, as one English phrase without a full stop.
   function Vesica_Strerror (Code : Integer_32) return chars_ptr
     with Import, Convention => C, External_Name => "vesica_strerror";

   --  Where do the outlines of two shapes meet?
   function Vesica_Crossings_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address; Capacity : Integer_64; Shared : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_crossings_f64";

   --  How far apart are the outlines of two shapes, and where do they come closest?
   function Vesica_Boundary_Distance_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_boundary_distance_f64";

   --  Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
   function Vesica_Shape_Area_F64 (Kind : Integer_32; Shape : System.Address; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_shape_area_f64";

   --  States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
   function Vesica_Polygon_Facts_F64 (Polygon : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_facts_f64";

   --  Are the two points the same?
   function Vesica_Overlap_Point_Point_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_point_f64";

   --  Does the point lie on the segment?
   function Vesica_Overlap_Point_Segment_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_segment_f64";

   --  Does the point lie in the disc or on its rim?
   function Vesica_Overlap_Point_Circle_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_circle_f64";

   --  Does the point lie in the box or on its outline?
   function Vesica_Overlap_Point_Aabb_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_aabb_f64";

   --  Does the point lie in the rectangle or on its outline?
   function Vesica_Overlap_Point_Rect_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_rect_f64";

   --  Does the point lie in the ellipse or on its outline?
   function Vesica_Overlap_Point_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_ellipse_f64";

   --  Do the segments share a point?
   function Vesica_Overlap_Segment_Segment_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_segment_f64";

   --  Does the segment meet the disc?
   function Vesica_Overlap_Segment_Circle_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_circle_f64";

   --  Does the segment meet the box?
   function Vesica_Overlap_Segment_Aabb_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_aabb_f64";

   --  Does the segment meet the rectangle?
   function Vesica_Overlap_Segment_Rect_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_rect_f64";

   --  Does the segment meet the ellipse?
   function Vesica_Overlap_Segment_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_ellipse_f64";

   --  Do the discs share a point?
   function Vesica_Overlap_Circle_Circle_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_circle_f64";

   --  Do the disc and the box share a point?
   function Vesica_Overlap_Circle_Aabb_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_aabb_f64";

   --  Do the disc and the rectangle share a point?
   function Vesica_Overlap_Circle_Rect_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_rect_f64";

   --  Do the disc and the ellipse share a point?
   function Vesica_Overlap_Circle_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_ellipse_f64";

   --  Do the boxes share a point?
   function Vesica_Overlap_Aabb_Aabb_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_aabb_f64";

   --  Do the box and the rectangle share a point?
   function Vesica_Overlap_Aabb_Rect_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_rect_f64";

   --  Do the box and the ellipse share a point?
   function Vesica_Overlap_Aabb_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_ellipse_f64";

   --  Do the rectangles share a point?
   function Vesica_Overlap_Rect_Rect_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_rect_rect_f64";

   --  Do the rectangle and the ellipse share a point?
   function Vesica_Overlap_Rect_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_rect_ellipse_f64";

   --  Do the ellipses share a point?
   function Vesica_Overlap_Ellipse_Ellipse_F64 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_ellipse_ellipse_f64";

   --  Box with two opposite corners, in any order.
   function Vesica_Aabb_From_Corners_F64 (X0 : IEEE_Float_64; Y0 : IEEE_Float_64; X1 : IEEE_Float_64; Y1 :
      IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_aabb_from_corners_f64";

   --  Rectangle from centre, angle and full size: width along the angle, height across it.
   function Vesica_Rect_From_Angle_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Angle : IEEE_Float_64; Width :
      IEEE_Float_64; Height : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_from_angle_f64";

   --  Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
   function Vesica_Rect_From_Corners_F64 (Corners : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_from_corners_f64";

   --  The largest distance from a given corner to the rectangle's corner that corresponds to it.
   function Vesica_Rect_Corners_Misfit_F64 (Corners : System.Address; R : System.Address; Misfit :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_corners_misfit_f64";

   --  Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
   --  across.
   function Vesica_Round_Rect_From_Angle_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Angle : IEEE_Float_64;
      Width : IEEE_Float_64; Height : IEEE_Float_64; Radius : IEEE_Float_64; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_round_rect_from_angle_f64";

   --  Capsule from centre, angle, the length between the ends of its segment, and radius.
   function Vesica_Capsule_From_Angle_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Angle : IEEE_Float_64; Length
      : IEEE_Float_64; Radius : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_capsule_from_angle_f64";

   --  Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
   --  ends.
   function Vesica_Capsule_From_Width_F64 (X0 : IEEE_Float_64; Y0 : IEEE_Float_64; X1 : IEEE_Float_64; Y1 :
      IEEE_Float_64; Width : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_capsule_from_width_f64";

   --  Ellipse from centre, angle and half lengths: a along the angle, b across it.
   function Vesica_Ellipse_From_Angle_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Angle : IEEE_Float_64; A :
      IEEE_Float_64; B : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_angle_f64";

   --  Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx,
   --  wy).
   function Vesica_Ellipse_From_Radius_Vector_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Wx : IEEE_Float_64; Wy
      : IEEE_Float_64; Ratio : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_radius_vector_f64";

   --  Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
   function Vesica_Ellipse_From_Covariance_F64 (Mean_X : IEEE_Float_64; Mean_Y : IEEE_Float_64; Cxx :
      IEEE_Float_64; Cxy : IEEE_Float_64; Cyy : IEEE_Float_64; K : IEEE_Float_64; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_covariance_f64";

   --  Ellipse of the points X with (X - C) .
   function Vesica_Ellipse_From_Matrix_F64 (Cx : IEEE_Float_64; Cy : IEEE_Float_64; Mxx : IEEE_Float_64; Mxy :
      IEEE_Float_64; Myy : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_matrix_f64";

   --  Describes an array of `count` records.
   function Vesica_Shapes_From_Records_F64 (Kind : Integer_32; Count : Integer_64; Base : System.Address; Stride
      : ptrdiff_t; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_shapes_from_records_f64";

   --  Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
   function Vesica_Overlap_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_many_f64";

   --  Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
   function Vesica_Interiors_Overlap_Many_F64 (A : System.Address; B : System.Address; Output : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_many_f64";

   --  How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
   function Vesica_Relation_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_relation_many_f64";

   --  Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
   function Vesica_Contains_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_contains_many_f64";

   --  How far apart are a[i] and b[i], and where?
   function Vesica_Nearest_Many_F64 (A : System.Address; B : System.Address; Distance : System.Address; Ax :
      System.Address; Ay : System.Address; Bx : System.Address; By : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_nearest_many_f64";

   --  How far apart are the outlines of a[i] and b[i]?
   function Vesica_Boundary_Distance_Many_F64 (A : System.Address; B : System.Address; Distance : System.Address;
      Ax : System.Address; Ay : System.Address; Bx : System.Address; By : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_boundary_distance_many_f64";

   --  How deep do a[i] and b[i] overlap?
   function Vesica_Depth_Many_F64 (A : System.Address; B : System.Address; Depth : System.Address; X :
      System.Address; Y : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_depth_many_f64";

   --  The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
   function Vesica_Area_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_area_many_f64";

   --  Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
   function Vesica_Iou_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_iou_many_f64";

   --  Do a[i] and b[j] share a point?
   function Vesica_Overlap_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_matrix_f64";

   --  Do the insides of a[i] and b[j] share a point?
   function Vesica_Interiors_Overlap_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_matrix_f64";

   --  How does a[i] relate to b[j]?
   function Vesica_Relation_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_relation_matrix_f64";

   --  Does a[i] contain all of b[j]?
   function Vesica_Contains_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_contains_matrix_f64";

   --  The area that a[i] and b[j] share.
   function Vesica_Area_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride :
      ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_area_matrix_f64";

   --  Intersection over union of a[i] and b[j].
   function Vesica_Iou_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride :
      ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_iou_matrix_f64";

   --  Which of many shapes overlap one?
   function Vesica_Overlap_Select_F64 (One : System.Address; Many : System.Address; Output : System.Address;
      Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_select_f64";

   --  Which of many shapes share a point of their insides with that of one?
   function Vesica_Interiors_Overlap_Select_F64 (One : System.Address; Many : System.Address; Output :
      System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_select_f64";

   --  How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count`
   --  shapes?
   function Vesica_Nms_Scratch (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_nms_scratch";

   --  Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
   --  whose vesica_iou_f64 with every shape kept before is at most the threshold.
   function Vesica_Nms_F64 (Shapes : System.Address; Scores : System.Address; Threshold : IEEE_Float_64; Scratch
      : System.Address; Scratch_Size : Integer_64; Keep : System.Address; Kept : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_nms_f64";

   --  Version of the loaded library.
   function Vesica_Version return Integer_32
     with Import, Convention => C, External_Name => "vesica_version";

   --  VESICA_VERSION_MAJOR of the loaded library.
   function Vesica_Version_Major return Integer_32
     with Import, Convention => C, External_Name => "vesica_version_major";

   --  VESICA_VERSION_MINOR of the loaded library.
   function Vesica_Version_Minor return Integer_32
     with Import, Convention => C, External_Name => "vesica_version_minor";

   --  VESICA_VERSION_PATCH of the loaded library.
   function Vesica_Version_Patch return Integer_32
     with Import, Convention => C, External_Name => "vesica_version_patch";

   --  How many numbers does a shape of this kind have?
   function Vesica_Field_Count (Kind : Integer_32) return Integer_32
     with Import, Convention => C, External_Name => "vesica_field_count";

   --  Name of a kind.
   function Vesica_Kind_Name (Kind : Integer_32) return chars_ptr
     with Import, Convention => C, External_Name => "vesica_kind_name";

   --  Name of the instruction set that batches use: the best one of this processor.
   function Vesica_Isa_Name return chars_ptr
     with Import, Convention => C, External_Name => "vesica_isa_name";

   --  Is a shape valid, and if not, which rule does it break?
   function Vesica_Check_F32 (Kind : Integer_32; Shape : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_check_f32";

   --  Do two shapes share a point?
   function Vesica_Overlap_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address)
      return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_f32";

   --  Do the insides of two shapes share a point?
   function Vesica_Interiors_Overlap_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_f32";

   --  How does a relate to b?
   function Vesica_Relation_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_relation_f32";

   --  Does a contain all of b?
   function Vesica_Contains_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_contains_f32";

   --  Where do the outlines of two shapes meet?
   function Vesica_Crossings_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address; Capacity : Integer_64; Shared : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_crossings_f32";

   --  How far apart are two solid shapes, and which of their points are closest?
   function Vesica_Nearest_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_nearest_f32";

   --  How far apart are the outlines of two shapes, and where do they come closest?
   function Vesica_Boundary_Distance_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_boundary_distance_f32";

   --  Penetration depth: how far and which way must b be moved until the two shapes only touch?
   function Vesica_Depth_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_depth_f32";

   --  Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
   function Vesica_Shape_Area_F32 (Kind : Integer_32; Shape : System.Address; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_shape_area_f32";

   --  States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
   function Vesica_Polygon_Facts_F32 (Polygon : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_facts_f32";

   --  Area of the intersection of two shapes.
   function Vesica_Area_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_area_f32";

   --  Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
   function Vesica_Iou_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_iou_f32";

   --  Smallest box of representable numbers that contains a shape.
   function Vesica_Bounds_F32 (Kind : Integer_32; Shape : System.Address; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_bounds_f32";

   --  Are the two points the same?
   function Vesica_Overlap_Point_Point_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_point_f32";

   --  Does the point lie on the segment?
   function Vesica_Overlap_Point_Segment_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_segment_f32";

   --  Does the point lie in the disc or on its rim?
   function Vesica_Overlap_Point_Circle_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_circle_f32";

   --  Does the point lie in the box or on its outline?
   function Vesica_Overlap_Point_Aabb_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_aabb_f32";

   --  Does the point lie in the rectangle or on its outline?
   function Vesica_Overlap_Point_Rect_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_rect_f32";

   --  Does the point lie in the ellipse or on its outline?
   function Vesica_Overlap_Point_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_point_ellipse_f32";

   --  Do the segments share a point?
   function Vesica_Overlap_Segment_Segment_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_segment_f32";

   --  Does the segment meet the disc?
   function Vesica_Overlap_Segment_Circle_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_circle_f32";

   --  Does the segment meet the box?
   function Vesica_Overlap_Segment_Aabb_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_aabb_f32";

   --  Does the segment meet the rectangle?
   function Vesica_Overlap_Segment_Rect_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_rect_f32";

   --  Does the segment meet the ellipse?
   function Vesica_Overlap_Segment_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_segment_ellipse_f32";

   --  Do the discs share a point?
   function Vesica_Overlap_Circle_Circle_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_circle_f32";

   --  Do the disc and the box share a point?
   function Vesica_Overlap_Circle_Aabb_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_aabb_f32";

   --  Do the disc and the rectangle share a point?
   function Vesica_Overlap_Circle_Rect_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_rect_f32";

   --  Do the disc and the ellipse share a point?
   function Vesica_Overlap_Circle_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_circle_ellipse_f32";

   --  Do the boxes share a point?
   function Vesica_Overlap_Aabb_Aabb_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_aabb_f32";

   --  Do the box and the rectangle share a point?
   function Vesica_Overlap_Aabb_Rect_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_rect_f32";

   --  Do the box and the ellipse share a point?
   function Vesica_Overlap_Aabb_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_aabb_ellipse_f32";

   --  Do the rectangles share a point?
   function Vesica_Overlap_Rect_Rect_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_rect_rect_f32";

   --  Do the rectangle and the ellipse share a point?
   function Vesica_Overlap_Rect_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_rect_ellipse_f32";

   --  Do the ellipses share a point?
   function Vesica_Overlap_Ellipse_Ellipse_F32 (A : System.Address; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_ellipse_ellipse_f32";

   --  Box with two opposite corners, in any order.
   function Vesica_Aabb_From_Corners_F32 (X0 : IEEE_Float_32; Y0 : IEEE_Float_32; X1 : IEEE_Float_32; Y1 :
      IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_aabb_from_corners_f32";

   --  Rectangle from centre, angle and full size: width along the angle, height across it.
   function Vesica_Rect_From_Angle_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Angle : IEEE_Float_32; Width :
      IEEE_Float_32; Height : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_from_angle_f32";

   --  Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
   function Vesica_Rect_From_Corners_F32 (Corners : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_from_corners_f32";

   --  The largest distance from a given corner to the rectangle's corner that corresponds to it.
   function Vesica_Rect_Corners_Misfit_F32 (Corners : System.Address; R : System.Address; Misfit :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_rect_corners_misfit_f32";

   --  Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
   --  across.
   function Vesica_Round_Rect_From_Angle_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Angle : IEEE_Float_32;
      Width : IEEE_Float_32; Height : IEEE_Float_32; Radius : IEEE_Float_32; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_round_rect_from_angle_f32";

   --  Capsule from centre, angle, the length between the ends of its segment, and radius.
   function Vesica_Capsule_From_Angle_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Angle : IEEE_Float_32; Length
      : IEEE_Float_32; Radius : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_capsule_from_angle_f32";

   --  Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
   --  ends.
   function Vesica_Capsule_From_Width_F32 (X0 : IEEE_Float_32; Y0 : IEEE_Float_32; X1 : IEEE_Float_32; Y1 :
      IEEE_Float_32; Width : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_capsule_from_width_f32";

   --  Ellipse from centre, angle and half lengths: a along the angle, b across it.
   function Vesica_Ellipse_From_Angle_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Angle : IEEE_Float_32; A :
      IEEE_Float_32; B : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_angle_f32";

   --  Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx,
   --  wy).
   function Vesica_Ellipse_From_Radius_Vector_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Wx : IEEE_Float_32; Wy
      : IEEE_Float_32; Ratio : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_radius_vector_f32";

   --  Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
   function Vesica_Ellipse_From_Covariance_F32 (Mean_X : IEEE_Float_32; Mean_Y : IEEE_Float_32; Cxx :
      IEEE_Float_32; Cxy : IEEE_Float_32; Cyy : IEEE_Float_32; K : IEEE_Float_32; Output : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_covariance_f32";

   --  Ellipse of the points X with (X - C) .
   function Vesica_Ellipse_From_Matrix_F32 (Cx : IEEE_Float_32; Cy : IEEE_Float_32; Mxx : IEEE_Float_32; Mxy :
      IEEE_Float_32; Myy : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ellipse_from_matrix_f32";

   --  Describes an array of `count` records.
   function Vesica_Shapes_From_Records_F32 (Kind : Integer_32; Count : Integer_64; Base : System.Address; Stride
      : ptrdiff_t; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_shapes_from_records_f32";

   --  Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
   function Vesica_Overlap_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_many_f32";

   --  Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
   function Vesica_Interiors_Overlap_Many_F32 (A : System.Address; B : System.Address; Output : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_many_f32";

   --  How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
   function Vesica_Relation_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_relation_many_f32";

   --  Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
   function Vesica_Contains_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_contains_many_f32";

   --  How far apart are a[i] and b[i], and where?
   function Vesica_Nearest_Many_F32 (A : System.Address; B : System.Address; Distance : System.Address; Ax :
      System.Address; Ay : System.Address; Bx : System.Address; By : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_nearest_many_f32";

   --  How far apart are the outlines of a[i] and b[i]?
   function Vesica_Boundary_Distance_Many_F32 (A : System.Address; B : System.Address; Distance : System.Address;
      Ax : System.Address; Ay : System.Address; Bx : System.Address; By : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_boundary_distance_many_f32";

   --  How deep do a[i] and b[i] overlap?
   function Vesica_Depth_Many_F32 (A : System.Address; B : System.Address; Depth : System.Address; X :
      System.Address; Y : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_depth_many_f32";

   --  The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
   function Vesica_Area_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_area_many_f32";

   --  Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
   function Vesica_Iou_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_iou_many_f32";

   --  Do a[i] and b[j] share a point?
   function Vesica_Overlap_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_matrix_f32";

   --  Do the insides of a[i] and b[j] share a point?
   function Vesica_Interiors_Overlap_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_matrix_f32";

   --  How does a[i] relate to b[j]?
   function Vesica_Relation_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_relation_matrix_f32";

   --  Does a[i] contain all of b[j]?
   function Vesica_Contains_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_contains_matrix_f32";

   --  The area that a[i] and b[j] share.
   function Vesica_Area_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride :
      ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_area_matrix_f32";

   --  Intersection over union of a[i] and b[j].
   function Vesica_Iou_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride :
      ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_iou_matrix_f32";

   --  Which of many shapes overlap one?
   function Vesica_Overlap_Select_F32 (One : System.Address; Many : System.Address; Output : System.Address;
      Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_select_f32";

   --  Which of many shapes share a point of their insides with that of one?
   function Vesica_Interiors_Overlap_Select_F32 (One : System.Address; Many : System.Address; Output :
      System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_interiors_overlap_select_f32";

   --  Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
   --  whose vesica_iou_f32 with every shape kept before is at most the threshold.
   function Vesica_Nms_F32 (Shapes : System.Address; Scores : System.Address; Threshold : IEEE_Float_32; Scratch
      : System.Address; Scratch_Size : Integer_64; Keep : System.Address; Kept : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_nms_f32";

   --  Rectangles from boxes.
   function Vesica_Rects_From_Boxes_F64 (Boxes : System.Address; Count : Integer_64; Stride : ptrdiff_t; Angle :
      Integer_32; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rects_from_boxes_f64";

   --  Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
   function Vesica_Ellipses_From_Boxes_F64 (Boxes : System.Address; Count : Integer_64; Stride : ptrdiff_t; Angle
      : Integer_32; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ellipses_from_boxes_f64";

   --  Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
   function Vesica_Rects_From_Corners_F64 (Corners : System.Address; Count : Integer_64; Stride : ptrdiff_t;
      Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rects_from_corners_f64";

   --  How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
   function Vesica_Rect_Corners_Misfit_Many_F64 (Corners : System.Address; Stride : ptrdiff_t; Rects :
      System.Address; Misfit : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rect_corners_misfit_many_f64";

   --  Boxes from rectangles or from ellipses: the inverse of the first two functions.
   function Vesica_Boxes_From_Shapes_F64 (Shapes : System.Address; Angle : Integer_32; Boxes : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_boxes_from_shapes_f64";

   --  The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
   function Vesica_Corners_Of_Shapes_F64 (Shapes : System.Address; Corners : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_corners_of_shapes_f64";

   --  Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
   function Vesica_Bounds_Many_F64 (Shapes : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_bounds_many_f64";

   --  Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
   function Vesica_Shape_Area_Many_F64 (Shapes : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_shape_area_many_f64";

   --  The convex hull of points: the smallest convex polygon that contains them.
   function Vesica_Convex_Hull_F64 (Points : System.Address; Output : System.Address; Capacity : Integer_64)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_convex_hull_f64";

   --  The rectangle of the least area that contains points.
   function Vesica_Min_Area_Rect_F64 (Points : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_min_area_rect_f64";

   --  The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
   function Vesica_Min_Perimeter_Rect_F64 (Points : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_min_perimeter_rect_f64";

   --  The rectangles of the least area about each polygon or polyline of an array.
   function Vesica_Min_Area_Rect_Many_F64 (Points : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_min_area_rect_many_f64";

   --  The rectangles of the least perimeter about each polygon or polyline of an array.
   function Vesica_Min_Perimeter_Rect_Many_F64 (Points : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_min_perimeter_rect_many_f64";

   --  Rectangles from boxes.
   function Vesica_Rects_From_Boxes_F32 (Boxes : System.Address; Count : Integer_64; Stride : ptrdiff_t; Angle :
      Integer_32; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rects_from_boxes_f32";

   --  Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
   function Vesica_Ellipses_From_Boxes_F32 (Boxes : System.Address; Count : Integer_64; Stride : ptrdiff_t; Angle
      : Integer_32; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ellipses_from_boxes_f32";

   --  Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
   function Vesica_Rects_From_Corners_F32 (Corners : System.Address; Count : Integer_64; Stride : ptrdiff_t;
      Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rects_from_corners_f32";

   --  How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
   function Vesica_Rect_Corners_Misfit_Many_F32 (Corners : System.Address; Stride : ptrdiff_t; Rects :
      System.Address; Misfit : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_rect_corners_misfit_many_f32";

   --  Boxes from rectangles or from ellipses: the inverse of the first two functions.
   function Vesica_Boxes_From_Shapes_F32 (Shapes : System.Address; Angle : Integer_32; Boxes : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_boxes_from_shapes_f32";

   --  The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
   function Vesica_Corners_Of_Shapes_F32 (Shapes : System.Address; Corners : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_corners_of_shapes_f32";

   --  Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
   function Vesica_Bounds_Many_F32 (Shapes : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_bounds_many_f32";

   --  Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
   function Vesica_Shape_Area_Many_F32 (Shapes : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_shape_area_many_f32";

   --  The convex hull of points: the smallest convex polygon that contains them.
   function Vesica_Convex_Hull_F32 (Points : System.Address; Output : System.Address; Capacity : Integer_64)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_convex_hull_f32";

   --  The rectangle of the least area that contains points.
   function Vesica_Min_Area_Rect_F32 (Points : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_min_area_rect_f32";

   --  The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
   function Vesica_Min_Perimeter_Rect_F32 (Points : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_min_perimeter_rect_f32";

   --  The rectangles of the least area about each polygon or polyline of an array.
   function Vesica_Min_Area_Rect_Many_F32 (Points : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_min_area_rect_many_f32";

   --  The rectangles of the least perimeter about each polygon or polyline of an array.
   function Vesica_Min_Perimeter_Rect_Many_F32 (Points : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_min_perimeter_rect_many_f32";

   --  All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
   --  like.
   function Vesica_Join_Ratio_F64 (Ratio : Integer_32; Threshold : IEEE_Float_64; Index_A : System.Address;
      Sets_A : System.Address; Set_Count_A : Integer_32; Index_B : System.Address; Sets_B : System.Address;
      Set_Count_B : Integer_32; Part : Integer_64; Parts : Integer_64; Scratch : System.Address; Scratch_Size :
      Integer_64; Out_A : System.Address; Out_B : System.Address; Values : System.Address; Capacity : Integer_64;
      State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_ratio_f64";

   --  How many bytes of scratch does greedy assignment of `count` pairs need?
   function Vesica_Assign_Greedy_Scratch (Count : Integer_64; Count_A : Integer_64; Count_B : Integer_64) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_assign_greedy_scratch";

   --  Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
   --  free, until there is none.
   function Vesica_Assign_Greedy_F64 (A : System.Address; B : System.Address; Values : System.Address; Count :
      Integer_64; Count_A : Integer_64; Count_B : Integer_64; Scratch : System.Address; Scratch_Size :
      Integer_64; Chosen : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_assign_greedy_f64";

   --  How many bytes of scratch does the fusion of `count` boxes need?
   function Vesica_Fuse_Scratch (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_fuse_scratch";

   --  Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
   --  mean.
   function Vesica_Fuse_F64 (Shapes : System.Address; Scores : System.Address; Weights : System.Address; Labels :
      System.Address; Threshold : IEEE_Float_64; Fused_Score : Integer_32; Scratch : System.Address; Scratch_Size
      : Integer_64; Fused : System.Address; Fused_Scores : System.Address; Clusters : System.Address; Count :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_fuse_f64";

   --  A ratio of shared volume: IoU and its relatives of two upright prisms.
   function Vesica_Volume_Ratio_F64 (Ratio : Integer_32; Kind_A : Integer_32; A : System.Address; Span_A :
      System.Address; Kind_B : Integer_32; B : System.Address; Span_B : System.Address; Output : System.Address)
      return Integer_32
     with Import, Convention => C, External_Name => "vesica_volume_ratio_f64";

   --  A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
   function Vesica_Volume_Ratio_Many_F64 (Ratio : Integer_32; A : System.Address; Spans_A : System.Address; B :
      System.Address; Spans_B : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_volume_ratio_many_f64";

   --  A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
   function Vesica_Volume_Ratio_Matrix_F64 (Ratio : Integer_32; A : System.Address; Spans_A : System.Address; B :
      System.Address; Spans_B : System.Address; Output : System.Address; Row_Stride : ptrdiff_t) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_volume_ratio_matrix_f64";

   --  How many bytes of scratch does matching by `count` pairs need?
   function Vesica_Match_Truths_Scratch (Count : Integer_64; Detections : Integer_64; Truths : Integer_64) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_match_truths_scratch";

   --  Which detections hit a truth, at each of some thresholds?
   function Vesica_Match_Truths_F64 (Rule : Integer_32; A : System.Address; B : System.Address; Values :
      System.Address; Count : Integer_64; Scores : System.Address; Detections : Integer_64; Flags :
      System.Address; Truths : Integer_64; Thresholds : System.Address; Threshold_Count : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64; Outcomes : System.Address; Taken : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_match_truths_f64";

   --  How many bytes of scratch does the average precision of `count` detections need?
   function Vesica_Average_Precision_Scratch (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_average_precision_scratch";

   --  Average precision (AP) of detections of one class.
   function Vesica_Average_Precision_F64 (Rule : Integer_32; Scores : System.Address; Outcomes : System.Address;
      Count : Integer_64; Truths : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Output :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_average_precision_f64";

   --  The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
   function Vesica_Gaussian_Distance_F64 (Which : Integer_32; Kind_A : Integer_32; A : System.Address; Kind_B :
      Integer_32; B : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_f64";

   --  The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
   function Vesica_Gaussian_Distance_Many_F64 (Which : Integer_32; A : System.Address; B : System.Address; Output
      : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_many_f64";

   --  The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
   function Vesica_Gaussian_Distance_Matrix_F64 (Which : Integer_32; A : System.Address; B : System.Address;
      Output : System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_matrix_f64";

   --  All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
   --  like.
   function Vesica_Join_Ratio_F32 (Ratio : Integer_32; Threshold : IEEE_Float_32; Index_A : System.Address;
      Sets_A : System.Address; Set_Count_A : Integer_32; Index_B : System.Address; Sets_B : System.Address;
      Set_Count_B : Integer_32; Part : Integer_64; Parts : Integer_64; Scratch : System.Address; Scratch_Size :
      Integer_64; Out_A : System.Address; Out_B : System.Address; Values : System.Address; Capacity : Integer_64;
      State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_ratio_f32";

   --  Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
   --  free, until there is none.
   function Vesica_Assign_Greedy_F32 (A : System.Address; B : System.Address; Values : System.Address; Count :
      Integer_64; Count_A : Integer_64; Count_B : Integer_64; Scratch : System.Address; Scratch_Size :
      Integer_64; Chosen : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_assign_greedy_f32";

   --  Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
   --  mean.
   function Vesica_Fuse_F32 (Shapes : System.Address; Scores : System.Address; Weights : System.Address; Labels :
      System.Address; Threshold : IEEE_Float_32; Fused_Score : Integer_32; Scratch : System.Address; Scratch_Size
      : Integer_64; Fused : System.Address; Fused_Scores : System.Address; Clusters : System.Address; Count :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_fuse_f32";

   --  Which detections hit a truth, at each of some thresholds?
   function Vesica_Match_Truths_F32 (Rule : Integer_32; A : System.Address; B : System.Address; Values :
      System.Address; Count : Integer_64; Scores : System.Address; Detections : Integer_64; Flags :
      System.Address; Truths : Integer_64; Thresholds : System.Address; Threshold_Count : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64; Outcomes : System.Address; Taken : System.Address) return
      Integer_32
     with Import, Convention => C, External_Name => "vesica_match_truths_f32";

   --  Average precision (AP) of detections of one class.
   function Vesica_Average_Precision_F32 (Rule : Integer_32; Scores : System.Address; Outcomes : System.Address;
      Count : Integer_64; Truths : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Output :
      System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_average_precision_f32";

   --  A ratio of shared volume: IoU and its relatives of two upright prisms.
   function Vesica_Volume_Ratio_F32 (Ratio : Integer_32; Kind_A : Integer_32; A : System.Address; Span_A :
      System.Address; Kind_B : Integer_32; B : System.Address; Span_B : System.Address; Output : System.Address)
      return Integer_32
     with Import, Convention => C, External_Name => "vesica_volume_ratio_f32";

   --  A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
   function Vesica_Volume_Ratio_Many_F32 (Ratio : Integer_32; A : System.Address; Spans_A : System.Address; B :
      System.Address; Spans_B : System.Address; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_volume_ratio_many_f32";

   --  A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
   function Vesica_Volume_Ratio_Matrix_F32 (Ratio : Integer_32; A : System.Address; Spans_A : System.Address; B :
      System.Address; Spans_B : System.Address; Output : System.Address; Row_Stride : ptrdiff_t) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_volume_ratio_matrix_f32";

   --  The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
   function Vesica_Gaussian_Distance_F32 (Which : Integer_32; Kind_A : Integer_32; A : System.Address; Kind_B :
      Integer_32; B : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_f32";

   --  The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
   function Vesica_Gaussian_Distance_Many_F32 (Which : Integer_32; A : System.Address; B : System.Address; Output
      : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_many_f32";

   --  The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
   function Vesica_Gaussian_Distance_Matrix_F32 (Which : Integer_32; A : System.Address; B : System.Address;
      Output : System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_gaussian_distance_matrix_f32";

   --  How many bytes suffice for an index of `count` shapes, of any kinds?
   function Vesica_Index_Size (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_size";

   --  How many bytes of scratch does building an index of `count` shapes need?
   function Vesica_Index_Scratch (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_scratch";

   --  How many bytes of scratch does a join need, whatever its indexes?
   function Vesica_Join_Scratch return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_scratch";

   --  Are these bytes an index that is safe to read?
   function Vesica_Index_Check (Index : System.Address; Size : Integer_64) return Integer_32
     with Import, Convention => C, External_Name => "vesica_index_check";

   --  How many bytes does a built index take?
   function Vesica_Index_Bytes (Index : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_bytes";

   --  How many shapes was an index built from?
   function Vesica_Index_Count (Index : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_count";

   --  A box around all valid shapes of an index.
   function Vesica_Index_Bounds (Index : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_index_bounds";

   --  The items of an index in spatial order: shapes near each other have nearby places in it.
   function Vesica_Index_Order (Index : System.Address; Output : System.Address; Capacity : Integer_64) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_index_order";

   --  Builds the index of some sets of shapes.
   function Vesica_Index_Build_F64 (Sets : System.Address; Set_Count : Integer_32; Index : System.Address;
      Index_Size : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_build_f64";

   --  One part of a build by several threads, in five steps.
   function Vesica_Index_Step_F64 (Step : Integer_32; Part : Integer_64; Parts : Integer_64; Sets :
      System.Address; Set_Count : Integer_32; Index : System.Address; Index_Size : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_step_f64";

   --  Which items of an index does one shape overlap?
   function Vesica_Index_Select_F64 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One :
      System.Address; Output : System.Address; Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_select_f64";

   --  Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
   function Vesica_Join_F64 (Query : Integer_32; Index_A : System.Address; Sets_A : System.Address; Set_Count_A :
      Integer_32; Index_B : System.Address; Sets_B : System.Address; Set_Count_B : Integer_32; Part : Integer_64;
      Parts : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Out_A : System.Address; Out_B :
      System.Address; Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_f64";

   --  All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once:
   --  those for which vesica_within_f64 is > 0.
   function Vesica_Join_Within_F64 (Index_A : System.Address; Sets_A : System.Address; Set_Count_A : Integer_32;
      Index_B : System.Address; Sets_B : System.Address; Set_Count_B : Integer_32; Distance : IEEE_Float_64; Part
      : Integer_64; Parts : Integer_64; Out_A : System.Address; Out_B : System.Address; Capacity : Integer_64;
      State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_within_f64";

   --  Which items of an index are nearest to one shape?
   function Vesica_Index_Nearest_F64 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One
      : System.Address; K : Integer_64; Within : IEEE_Float_64; Output : System.Address; Distance :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_nearest_f64";

   --  Which items of index_b are nearest to each item of sets_a?
   function Vesica_Join_Nearest_F64 (Sets_A : System.Address; Set_Count_A : Integer_32; Index_B : System.Address;
      Sets_B : System.Address; Set_Count_B : Integer_32; K : Integer_64; Within : IEEE_Float_64; Part :
      Integer_64; Parts : Integer_64; Output : System.Address; Distance : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_nearest_f64";

   --  How many bytes do the boxes of a polygon or a polyline take?
   function Vesica_Polygon_Boxes_Size (Vertices : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_size";

   --  Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
   --  zone.
   function Vesica_Polygon_Boxes_F64 (Kind : Integer_32; Path : System.Address; Boxes : System.Address; Size :
      Integer_64) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_f64";

   --  Does a path with boxes overlap another shape?
   function Vesica_Polygon_Boxes_Overlap_F64 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_overlap_f64";

   --  The distance of a path with boxes and another shape, and where it is.
   function Vesica_Polygon_Boxes_Nearest_F64 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_nearest_f64";

   --  Are a path with boxes and another shape at most a distance apart?
   function Vesica_Polygon_Boxes_Within_F64 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address; Distance : IEEE_Float_64) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_within_f64";

   --  Builds the index of some sets of shapes.
   function Vesica_Index_Build_F32 (Sets : System.Address; Set_Count : Integer_32; Index : System.Address;
      Index_Size : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_build_f32";

   --  One part of a build by several threads, in five steps.
   function Vesica_Index_Step_F32 (Step : Integer_32; Part : Integer_64; Parts : Integer_64; Sets :
      System.Address; Set_Count : Integer_32; Index : System.Address; Index_Size : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_step_f32";

   --  Which items of an index does one shape overlap?
   function Vesica_Index_Select_F32 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One :
      System.Address; Output : System.Address; Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_select_f32";

   --  Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
   function Vesica_Join_F32 (Query : Integer_32; Index_A : System.Address; Sets_A : System.Address; Set_Count_A :
      Integer_32; Index_B : System.Address; Sets_B : System.Address; Set_Count_B : Integer_32; Part : Integer_64;
      Parts : Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Out_A : System.Address; Out_B :
      System.Address; Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_f32";

   --  All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once:
   --  those for which vesica_within_f32 is > 0.
   function Vesica_Join_Within_F32 (Index_A : System.Address; Sets_A : System.Address; Set_Count_A : Integer_32;
      Index_B : System.Address; Sets_B : System.Address; Set_Count_B : Integer_32; Distance : IEEE_Float_32; Part
      : Integer_64; Parts : Integer_64; Out_A : System.Address; Out_B : System.Address; Capacity : Integer_64;
      State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_within_f32";

   --  Which items of an index are nearest to one shape?
   function Vesica_Index_Nearest_F32 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One
      : System.Address; K : Integer_64; Within : IEEE_Float_32; Output : System.Address; Distance :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_nearest_f32";

   --  Which items of index_b are nearest to each item of sets_a?
   function Vesica_Join_Nearest_F32 (Sets_A : System.Address; Set_Count_A : Integer_32; Index_B : System.Address;
      Sets_B : System.Address; Set_Count_B : Integer_32; K : Integer_64; Within : IEEE_Float_32; Part :
      Integer_64; Parts : Integer_64; Output : System.Address; Distance : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_join_nearest_f32";

   --  Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
   --  zone.
   function Vesica_Polygon_Boxes_F32 (Kind : Integer_32; Path : System.Address; Boxes : System.Address; Size :
      Integer_64) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_f32";

   --  Does a path with boxes overlap another shape?
   function Vesica_Polygon_Boxes_Overlap_F32 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_overlap_f32";

   --  The distance of a path with boxes and another shape, and where it is.
   function Vesica_Polygon_Boxes_Nearest_F32 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_nearest_f32";

   --  Are a path with boxes and another shape at most a distance apart?
   function Vesica_Polygon_Boxes_Within_F32 (Kind : Integer_32; Path : System.Address; Boxes : System.Address;
      Size : Integer_64; Kind_B : Integer_32; B : System.Address; Distance : IEEE_Float_32) return Integer_32
     with Import, Convention => C, External_Name => "vesica_polygon_boxes_within_f32";

   --  A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
   function Vesica_Ratio_F64 (Ratio : Integer_32; Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B
      : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ratio_f64";

   --  A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
   function Vesica_Ratio_Many_F64 (Ratio : Integer_32; A : System.Address; B : System.Address; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ratio_many_f64";

   --  A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
   function Vesica_Ratio_Matrix_F64 (Ratio : Integer_32; A : System.Address; B : System.Address; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ratio_matrix_f64";

   --  How far apart are a[i] and b[j]?
   function Vesica_Nearest_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_nearest_matrix_f64";

   --  How far apart are the outlines of a[i] and b[j]?
   function Vesica_Boundary_Distance_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_boundary_distance_matrix_f64";

   --  How deep do a[i] and b[j] overlap?
   function Vesica_Depth_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride
      : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_depth_matrix_f64";

   --  Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
   function Vesica_Signed_Distance_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_signed_distance_f64";

   --  Signed distances of a[i] and b[i].
   function Vesica_Signed_Distance_Many_F64 (A : System.Address; B : System.Address; Output : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_signed_distance_many_f64";

   --  Signed distances of a[i] and b[j].
   function Vesica_Signed_Distance_Matrix_F64 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_signed_distance_matrix_f64";

   --  Are two shapes at most `distance` apart?
   function Vesica_Within_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Distance : IEEE_Float_64) return Integer_32
     with Import, Convention => C, External_Name => "vesica_within_f64";

   --  Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
   function Vesica_Within_Many_F64 (A : System.Address; B : System.Address; Distance : IEEE_Float_64; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_within_many_f64";

   --  Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
   function Vesica_Within_Matrix_F64 (A : System.Address; B : System.Address; Distance : IEEE_Float_64; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_within_matrix_f64";

   --  Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
   function Vesica_Suppress_F64 (Shapes : System.Address; Scores : System.Address; Labels : System.Address; Ratio
      : Integer_32; Threshold : IEEE_Float_64; Least_Score : IEEE_Float_64; Most : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64; Keep : System.Address; Kept : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_suppress_f64";

   --  How many bytes of scratch does soft suppression of `count` shapes need?
   function Vesica_Suppress_Soft_Scratch (Count : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_suppress_soft_scratch";

   --  Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
   function Vesica_Suppress_Soft_F64 (Shapes : System.Address; Scores : System.Address; Labels : System.Address;
      Ratio : Integer_32; Decay : Integer_32; Parameter : IEEE_Float_64; Least_Score : IEEE_Float_64; Most :
      Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Keep : System.Address; Decayed :
      System.Address; Kept : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_suppress_soft_f64";

   --  The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
   function Vesica_Coverage_F64 (Kind : Integer_32; Shape : System.Address; Grid : System.Address; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_32
     with Import, Convention => C, External_Name => "vesica_coverage_f64";

   --  The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
   function Vesica_Coverage_Cells_F64 (Kind : Integer_32; Shape : System.Address; Grid : System.Address; Cells :
      System.Address; Shares : System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_coverage_cells_f64";

   --  A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
   function Vesica_Ratio_F32 (Ratio : Integer_32; Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B
      : System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_ratio_f32";

   --  A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
   function Vesica_Ratio_Many_F32 (Ratio : Integer_32; A : System.Address; B : System.Address; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ratio_many_f32";

   --  A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
   function Vesica_Ratio_Matrix_F32 (Ratio : Integer_32; A : System.Address; B : System.Address; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_ratio_matrix_f32";

   --  How far apart are a[i] and b[j]?
   function Vesica_Nearest_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_nearest_matrix_f32";

   --  How far apart are the outlines of a[i] and b[j]?
   function Vesica_Boundary_Distance_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_boundary_distance_matrix_f32";

   --  How deep do a[i] and b[j] overlap?
   function Vesica_Depth_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address; Row_Stride
      : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_depth_matrix_f32";

   --  Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
   function Vesica_Suppress_F32 (Shapes : System.Address; Scores : System.Address; Labels : System.Address; Ratio
      : Integer_32; Threshold : IEEE_Float_32; Least_Score : IEEE_Float_32; Most : Integer_64; Scratch :
      System.Address; Scratch_Size : Integer_64; Keep : System.Address; Kept : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_suppress_f32";

   --  Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
   function Vesica_Signed_Distance_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_signed_distance_f32";

   --  Signed distances of a[i] and b[i].
   function Vesica_Signed_Distance_Many_F32 (A : System.Address; B : System.Address; Output : System.Address)
      return Integer_64
     with Import, Convention => C, External_Name => "vesica_signed_distance_many_f32";

   --  Signed distances of a[i] and b[j].
   function Vesica_Signed_Distance_Matrix_F32 (A : System.Address; B : System.Address; Output : System.Address;
      Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_signed_distance_matrix_f32";

   --  Are two shapes at most `distance` apart?
   function Vesica_Within_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Distance : IEEE_Float_32) return Integer_32
     with Import, Convention => C, External_Name => "vesica_within_f32";

   --  Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
   function Vesica_Within_Many_F32 (A : System.Address; B : System.Address; Distance : IEEE_Float_32; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_within_many_f32";

   --  Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
   function Vesica_Within_Matrix_F32 (A : System.Address; B : System.Address; Distance : IEEE_Float_32; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_64
     with Import, Convention => C, External_Name => "vesica_within_matrix_f32";

   --  Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
   function Vesica_Suppress_Soft_F32 (Shapes : System.Address; Scores : System.Address; Labels : System.Address;
      Ratio : Integer_32; Decay : Integer_32; Parameter : IEEE_Float_32; Least_Score : IEEE_Float_32; Most :
      Integer_64; Scratch : System.Address; Scratch_Size : Integer_64; Keep : System.Address; Decayed :
      System.Address; Kept : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_suppress_soft_f32";

   --  The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
   function Vesica_Coverage_F32 (Kind : Integer_32; Shape : System.Address; Grid : System.Address; Output :
      System.Address; Row_Stride : ptrdiff_t) return Integer_32
     with Import, Convention => C, External_Name => "vesica_coverage_f32";

   --  The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
   function Vesica_Coverage_Cells_F32 (Kind : Integer_32; Shape : System.Address; Grid : System.Address; Cells :
      System.Address; Shares : System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_coverage_cells_f32";

   --  Does b touch a while it moves, when first, and where?
   function Vesica_Cast_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address; Vx
      : IEEE_Float_64; Vy : IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_f64";

   --  When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
   function Vesica_Cast_Many_F64 (A : System.Address; B : System.Address; Vx : System.Address; Vy :
      System.Address; Stride : ptrdiff_t; T_End : IEEE_Float_64; T : System.Address; X : System.Address; Y :
      System.Address; Nx : System.Address; Ny : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_cast_many_f64";

   --  Which of many shapes at rest does one moving shape touch first?
   function Vesica_Cast_First_F64 (One : System.Address; Many : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_cast_first_f64";

   --  A box that holds a shape throughout its motion, t from 0 to t_end.
   function Vesica_Sweep_Bounds_F64 (Kind : Integer_32; Shape : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_sweep_bounds_f64";

   --  Which items of an index does one moving shape touch?
   function Vesica_Index_Cast_F64 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One :
      System.Address; Vx : IEEE_Float_64; Vy : IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address;
      Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_cast_f64";

   --  Which item of an index does one moving shape touch first?
   function Vesica_Index_Cast_First_F64 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32;
      One : System.Address; Vx : IEEE_Float_64; Vy : IEEE_Float_64; T_End : IEEE_Float_64; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_cast_first_f64";

   --  When do two shapes that move and turn touch first?
   function Vesica_Impact_Time_F64 (Kind_A : Integer_32; A : System.Address; Turn_A : System.Address; Kind_B :
      Integer_32; B : System.Address; Turn_B : System.Address; Tolerance : IEEE_Float_64; Output :
      System.Address; Gap : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_impact_time_f64";

   --  Which item of an index does a shape that moves and turns touch first?
   function Vesica_Index_Impact_Time_F64 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32;
      One : System.Address; Turn : System.Address; Tolerance : IEEE_Float_64; Output : System.Address; Gap :
      System.Address; Answer : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_impact_time_f64";

   --  Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
   function Vesica_Manifold_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_manifold_f64";

   --  The contacts of a[i] and b[i].
   function Vesica_Manifold_Many_F64 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_manifold_many_f64";

   --  A ray at a point.
   function Vesica_Cast_Point_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_point_point_f64";

   --  A ray at a segment.
   function Vesica_Cast_Segment_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_segment_point_f64";

   --  A ray at a disc.
   function Vesica_Cast_Circle_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_circle_point_f64";

   --  A ray at an axis-aligned box.
   function Vesica_Cast_Aabb_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_aabb_point_f64";

   --  A ray at a rectangle.
   function Vesica_Cast_Rect_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_rect_point_f64";

   --  A ray at an ellipse.
   function Vesica_Cast_Ellipse_Point_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_ellipse_point_f64";

   --  Two discs.
   function Vesica_Cast_Circle_Circle_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_circle_circle_f64";

   --  Two rectangles.
   function Vesica_Cast_Rect_Rect_F64 (A : System.Address; B : System.Address; Vx : IEEE_Float_64; Vy :
      IEEE_Float_64; T_End : IEEE_Float_64; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_rect_rect_f64";

   --  Does b touch a while it moves, when first, and where?
   function Vesica_Cast_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address; Vx
      : IEEE_Float_32; Vy : IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_f32";

   --  When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
   function Vesica_Cast_Many_F32 (A : System.Address; B : System.Address; Vx : System.Address; Vy :
      System.Address; Stride : ptrdiff_t; T_End : IEEE_Float_32; T : System.Address; X : System.Address; Y :
      System.Address; Nx : System.Address; Ny : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_cast_many_f32";

   --  Which of many shapes at rest does one moving shape touch first?
   function Vesica_Cast_First_F32 (One : System.Address; Many : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_cast_first_f32";

   --  A box that holds a shape throughout its motion, t from 0 to t_end.
   function Vesica_Sweep_Bounds_F32 (Kind : Integer_32; Shape : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_sweep_bounds_f32";

   --  Which items of an index does one moving shape touch?
   function Vesica_Index_Cast_F32 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32; One :
      System.Address; Vx : IEEE_Float_32; Vy : IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address;
      Capacity : Integer_64; State : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_cast_f32";

   --  Which item of an index does one moving shape touch first?
   function Vesica_Index_Cast_First_F32 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32;
      One : System.Address; Vx : IEEE_Float_32; Vy : IEEE_Float_32; T_End : IEEE_Float_32; Output :
      System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_cast_first_f32";

   --  As vesica_impact_time_f64.
   function Vesica_Impact_Time_F32 (Kind_A : Integer_32; A : System.Address; Turn_A : System.Address; Kind_B :
      Integer_32; B : System.Address; Turn_B : System.Address; Tolerance : IEEE_Float_32; Output :
      System.Address; Gap : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_impact_time_f32";

   --  Which item of an index does a shape that moves and turns touch first?
   function Vesica_Index_Impact_Time_F32 (Index : System.Address; Sets : System.Address; Set_Count : Integer_32;
      One : System.Address; Turn : System.Address; Tolerance : IEEE_Float_32; Output : System.Address; Gap :
      System.Address; Answer : System.Address) return Integer_64
     with Import, Convention => C, External_Name => "vesica_index_impact_time_f32";

   --  Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
   function Vesica_Manifold_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_manifold_f32";

   --  The contacts of a[i] and b[i].
   function Vesica_Manifold_Many_F32 (A : System.Address; B : System.Address; Output : System.Address) return
      Integer_64
     with Import, Convention => C, External_Name => "vesica_manifold_many_f32";

   --  A ray at a point.
   function Vesica_Cast_Point_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_point_point_f32";

   --  A ray at a segment.
   function Vesica_Cast_Segment_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_segment_point_f32";

   --  A ray at a disc.
   function Vesica_Cast_Circle_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_circle_point_f32";

   --  A ray at an axis-aligned box.
   function Vesica_Cast_Aabb_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_aabb_point_f32";

   --  A ray at a rectangle.
   function Vesica_Cast_Rect_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_rect_point_f32";

   --  A ray at an ellipse.
   function Vesica_Cast_Ellipse_Point_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_ellipse_point_f32";

   --  Two discs.
   function Vesica_Cast_Circle_Circle_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_circle_circle_f32";

   --  Two rectangles.
   function Vesica_Cast_Rect_Rect_F32 (A : System.Address; B : System.Address; Vx : IEEE_Float_32; Vy :
      IEEE_Float_32; T_End : IEEE_Float_32; Output : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_cast_rect_rect_f32";

   --  The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
   function Vesica_De9im_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Matrix : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_de9im_f64";

   --  Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
   function Vesica_De9im_Match (Matrix : chars_ptr; Pattern : chars_ptr) return Integer_32
     with Import, Convention => C, External_Name => "vesica_de9im_match";

   --  The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
   function Vesica_Intersection_F64 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_intersection_f64";

   --  The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
   function Vesica_De9im_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B : System.Address;
      Matrix : System.Address) return Integer_32
     with Import, Convention => C, External_Name => "vesica_de9im_f32";

   --  The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
   function Vesica_Intersection_F32 (Kind_A : Integer_32; A : System.Address; Kind_B : Integer_32; B :
      System.Address; Output : System.Address; Capacity : Integer_64) return Integer_64
     with Import, Convention => C, External_Name => "vesica_intersection_f32";

end Vesica_C;
