--  SPDX-License-Identifier: Apache-2.0
--  Exact overlap queries between plain 2D shapes. Touching counts. Vesica_C has every function and constant.
with Interfaces; use Interfaces;
with Vesica_C;

package Vesica is

   --  Of these declarations. Elaboration raises Program_Error where the library is older.
   Version : constant := Vesica_C.Vesica_Declared_Version;

   --  An error of the library. The exception's message begins with its code, and says what it means.
   Error : exception;

   subtype Kind is Integer_32;
   Point_Kind   : constant Kind := Vesica_C.Vesica_Point;
   Segment_Kind : constant Kind := Vesica_C.Vesica_Segment;
   Circle_Kind  : constant Kind := Vesica_C.Vesica_Circle;
   AABB_Kind    : constant Kind := Vesica_C.Vesica_Aabb;
   Rect_Kind    : constant Kind := Vesica_C.Vesica_Rect;
   Ellipse_Kind : constant Kind := Vesica_C.Vesica_Ellipse;

   subtype Double is IEEE_Float_64;
   type Doubles is array (Positive range <>) of aliased Double with Convention => C;
   type Floats is array (Positive range <>) of aliased IEEE_Float_32 with Convention => C;

   --  Do two shapes, given by their numbers, share a point?
   function Overlap (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Boolean;
   function Overlap (Kind_A : Kind; A : Floats; Kind_B : Kind; B : Floats) return Boolean;

   --  How far apart are two shapes, and which of their points are closest? A distance, (Ax, Ay) of A and (Bx, By) of B.
   subtype Closest_Points is Vesica_C.Vesica_Closest_Points_F64;
   function "=" (A, B : Closest_Points) return Boolean renames Vesica_C."=";
   function Nearest (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Closest_Points;

   --  The shapes, laid out as the library's structs. Axes are the cosine and sine of the angle.
   type Point is record
      X, Y : Double;
   end record with Convention => C;
   type Segment is record
      X0, Y0, X1, Y1 : Double;
   end record with Convention => C;
   type Circle is record
      CX, CY, R : Double;
   end record with Convention => C;
   type AABB is record
      Min_X, Min_Y, Max_X, Max_Y : Double;
   end record with Convention => C;
   type Rect is record
      CX, CY, UX, UY, HX, HY : Double;
   end record with Convention => C;
   type Ellipse is record
      CX, CY, UX, UY, A, B : Double;
   end record with Convention => C;

   --  What the library sees of an array: nothing is copied, and the array must live as long.
   type View is private;

   --  Shape begins with the record of that kind; it may have more components.
   generic
      Of_Kind : Kind;
      type Shape is private;
      type Shapes is array (Positive range <>) of Shape;
   function View_Of (Elements : Shapes) return View;

   type Flags is array (Positive range <>) of Boolean with Component_Size => 8;

   --  Two arrays in step; one of a single shape is repeated. Hits says for each whether they overlap; the result is how
   --  many do. Where a shape is invalid, Hits has False for it and every other answer, and Error is raised.
   function Overlap_Many (A, B : View; Hits : in out Flags) return Natural;

private

   type View is record
      Of_C : Vesica_C.Vesica_Shapes_F64;
   end record;

end Vesica;
