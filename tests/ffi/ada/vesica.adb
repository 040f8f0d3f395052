--  SPDX-License-Identifier: Apache-2.0
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System.Storage_Elements; use System.Storage_Elements;

package body Vesica is

   function C_Version return Integer_32 with Import, Convention => C, External_Name => "vesica_version";

   function C_Strerror (Code : Integer_32) return chars_ptr
     with Import, Convention => C, External_Name => "vesica_strerror";

   function C_Field_Count (Of_Kind : Kind) return Integer_32
     with Import, Convention => C, External_Name => "vesica_field_count";

   function C_Overlap (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_f64";

   function C_Overlap (Kind_A : Kind; A : Floats; Kind_B : Kind; B : Floats) return Integer_32
     with Import, Convention => C, External_Name => "vesica_overlap_f32";

   function C_Overlap_Many (A, B : View; Hits : in out Flags) return Integer_64
     with Import, Convention => C, External_Name => "vesica_overlap_many_f64";

   function Checked (Answer : Integer_64) return Natural is
   begin
      if Answer < 0 then
         raise Error with Answer'Image & ": " & Value (C_Strerror (Integer_32 (Answer)));
      end if;
      return Natural (Answer);
   end Checked;

   procedure Need (Of_Kind : Kind; Length : Natural) is
   begin
      if Length < Checked (Integer_64 (C_Field_Count (Of_Kind))) then
         raise Constraint_Error with "too few numbers for a shape";
      end if;
   end Need;

   function Overlap (Kind_A : Kind; A : Doubles; Kind_B : Kind; B : Doubles) return Boolean is
   begin
      Need (Kind_A, A'Length);
      Need (Kind_B, B'Length);
      return Checked (Integer_64 (C_Overlap (Kind_A, A, Kind_B, B))) = 1;
   end Overlap;

   function Overlap (Kind_A : Kind; A : Floats; Kind_B : Kind; B : Floats) return Boolean is
   begin
      Need (Kind_A, A'Length);
      Need (Kind_B, B'Length);
      return Checked (Integer_64 (C_Overlap (Kind_A, A, Kind_B, B))) = 1;
   end Overlap;

   function View_Of (Elements : Shapes) return View is
      Result : View := (Of_Kind => Of_Kind, Count => Elements'Length, others => <>);
   begin
      if Result.Count > 0 then
         Result.Stride := Shapes'Component_Size / 8;
         for I in Result.Field'Range loop
            Result.Field (I) := Elements'Address + Storage_Offset (8 * (I - 1));
         end loop;
      end if;
      return Result;
   end View_Of;

   function Overlap_Many (A, B : View; Hits : in out Flags) return Natural is
      Count : constant Integer_64 := (if A.Count = 0 or B.Count = 0 then 0 else Integer_64'Max (A.Count, B.Count));
   begin
      if Hits'Length < Count then
         raise Constraint_Error with "Hits is too short";
      end if;
      return Checked (C_Overlap_Many (A, B, Hits));
   end Overlap_Many;

begin
   if C_Version < Version then
      raise Program_Error with "vesica" & C_Version'Image & " is older than" & Integer'Image (Version);
   end if;
end Vesica;
