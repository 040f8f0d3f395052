--  SPDX-License-Identifier: Apache-2.0
with Interfaces.C; use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System.Storage_Elements; use System.Storage_Elements;
with Vesica_C; use Vesica_C;

package body Vesica is

   function Checked (Answer : Integer_64) return Natural is
   begin
      if Answer < 0 then
         raise Error with Answer'Image & ": " & Value (Vesica_Strerror (Integer_32 (Answer)));
      end if;
      return Natural (Answer);
   end Checked;

   procedure Need (Of_Kind : Kind; Length : Natural) is
   begin
      if Length < Checked (Integer_64 (Vesica_Field_Count (Of_Kind))) then
         raise Constraint_Error with "too few numbers for a shape";
      end if;
   end Need;

   function Overlap (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Boolean is
   begin
      Need (Kind_A, A'Length);
      Need (Kind_B, B'Length);
      return Checked (Integer_64 (Vesica_Overlap_F64 (Kind_A, A'Address, Kind_B, B'Address))) = 1;
   end Overlap;

   function Overlap (Kind_A : Kind; A : Floats; Kind_B : Kind; B : Floats) return Boolean is
   begin
      Need (Kind_A, A'Length);
      Need (Kind_B, B'Length);
      return Checked (Integer_64 (Vesica_Overlap_F32 (Kind_A, A'Address, Kind_B, B'Address))) = 1;
   end Overlap;

   function Nearest (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Closest_Points is
      Result : aliased Closest_Points;
      Answer : Natural;
   begin
      Need (Kind_A, A'Length);
      Need (Kind_B, B'Length);
      Answer := Checked (Integer_64 (Vesica_Nearest_F64 (Kind_A, A'Address, Kind_B, B'Address, Result'Address)));
      pragma Assert (Answer = 0);
      return Result;
   end Nearest;

   function View_Of (Elements : Shapes) return View is
      Result : View;
   begin
      Result.Of_C :=
        (Of_Kind, 0, Elements'Length, 0, (others => System.Null_Address), System.Null_Address, System.Null_Address, 0);
      if Result.Of_C.Count > 0 then
         Result.Of_C.Stride := Shapes'Component_Size / 8;
         for I in Result.Of_C.Field'Range loop
            Result.Of_C.Field (I) := Elements'Address + Storage_Offset (8 * (I - 1));
         end loop;
      end if;
      return Result;
   end View_Of;

   function Overlap_Many (A, B : View; Hits : in out Flags) return Natural is
      Count : constant Integer_64 :=
        (if A.Of_C.Count = 0 or B.Of_C.Count = 0 then 0 else Integer_64'Max (A.Of_C.Count, B.Of_C.Count));
   begin
      if Hits'Length < Count then
         raise Constraint_Error with "Hits is too short";
      end if;
      return Checked (Vesica_Overlap_Many_F64 (A.Of_C'Address, B.Of_C'Address, Hits'Address));
   end Overlap_Many;

begin
   if Vesica_Version < Version then
      raise Program_Error with "vesica" & Vesica_Version'Image & " is older than" & Integer'Image (Version);
   end if;
end Vesica;
