--  SPDX-License-Identifier: Apache-2.0
--  vectors FILE: the shared vectors (bindings/vectors) by package Vesica. Exit status 0 when all answers are right.
with Ada.Command_Line; use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Strings.Fixed;
with Ada.Text_IO; use Ada.Text_IO;
with Ada.Unchecked_Conversion;
with Interfaces; use Interfaces;
with Vesica; use Vesica;

procedure Vectors is

   subtype Six is Doubles (1 .. 6);
   function To_Double is new Ada.Unchecked_Conversion (Unsigned_64, Double);
   function To_Rect is new Ada.Unchecked_Conversion (Six, Rect);
   function To_Ellipse is new Ada.Unchecked_Conversion (Six, Ellipse);

   type Rects is array (Positive range <>) of Rect;
   type Ellipses is array (Positive range <>) of Ellipse;
   function View_Of_Rects is new View_Of (Rect_Kind, Rect, Rects);
   function View_Of_Ellipses is new View_Of (Ellipse_Kind, Ellipse, Ellipses);

   Batch_Limit : constant := 64;
   A           : Rects (1 .. Batch_Limit);
   B           : Ellipses (1 .. Batch_Limit);
   Lines, Codes : array (1 .. Batch_Limit) of Integer;
   Batch       : Natural := 0;
   Calls       : Natural := 0;
   Line        : Natural := 0;
   File        : File_Type;

   function Trimmed (I : Integer) return String is (Ada.Strings.Fixed.Trim (I'Image, Ada.Strings.Left));

   procedure Check (Line, Answer, Expected : Integer) is
   begin
      if Answer /= Expected then
         Put_Line ("line " & Trimmed (Line) & ": " & Trimmed (Answer) & ", not " & Trimmed (Expected));
         Set_Exit_Status (Failure);
      end if;
   end Check;

   --  What the call answers, or the code of its error.
   function Code_Of (E : Ada.Exceptions.Exception_Occurrence) return Integer is
     (Integer'Value (Ada.Exceptions.Exception_Message (E) (1 .. 2)));

   function Scalar (What : String; Kind_A : Kind; A : Six; Kind_B : Kind; B : Six) return Integer is
      Floats_A, Floats_B : Floats (Six'Range);
   begin
      if What = "f64" then
         return Boolean'Pos (Overlap (Kind_A, A, Kind_B, B));
      end if;
      for I in Six'Range loop
         Floats_A (I) := IEEE_Float_32 (A (I));
         Floats_B (I) := IEEE_Float_32 (B (I));
      end loop;
      return Boolean'Pos (Overlap (Kind_A, Floats_A, Kind_B, Floats_B));
   exception
      when E : Error => return Code_Of (E);
   end Scalar;

   procedure Read_Vector (Text : String) is
      From : Positive := Text'First;

      function Word return String is
         First : constant Positive := From;
         Space : constant Natural := Ada.Strings.Fixed.Index (Text, " ", First);
         Last  : constant Natural := (if Space = 0 then Text'Last else Space - 1);
      begin
         From := Last + 2;
         return Text (First .. Last);
      end Word;

      procedure Read_Shape (Of_Kind : out Kind; Numbers : out Six) is
      begin
         Of_Kind := Kind'Value (Word);
         for Number of Numbers loop
            Number := To_Double (Unsigned_64'Value ("16#" & Word & "#"));
         end loop;
      end Read_Shape;

      What               : constant String := Word;
      Expected           : constant Integer := Integer'Value (Word);
      Kind_A, Kind_B     : Kind;
      Numbers_A, Numbers_B : Six;
   begin
      Read_Shape (Kind_A, Numbers_A);
      Read_Shape (Kind_B, Numbers_B);
      if What = "many" then
         Batch := Batch + 1;
         Lines (Batch) := Line;
         Codes (Batch) := Expected;
         A (Batch) := To_Rect (Numbers_A);
         B (Batch) := To_Ellipse (Numbers_B);
      else
         Check (Line, Scalar (What, Kind_A, Numbers_A, Kind_B, Numbers_B), Expected);
         Calls := Calls + 1;
      end if;
   end Read_Vector;

   Hits : Flags (1 .. Batch_Limit);

   function Many (Count : Natural) return Integer is
     (Overlap_Many (View_Of_Rects (A (1 .. Count)), View_Of_Ellipses (B (1 .. Count)), Hits));

   procedure Check_Batch is
      Valid, Expected_Hits : Natural := 0;
   begin
      while Codes (Valid + 1) >= 0 loop
         Valid := Valid + 1;
         Expected_Hits := Expected_Hits + Codes (Valid);
      end loop;
      if Many (Valid) /= Expected_Hits then
         Set_Exit_Status (Failure);
      end if;
      begin
         --  With an invalid element, an error: and yet every valid one has its answer.
         Calls := Calls + Many (Batch);
         Set_Exit_Status (Failure);
      exception
         when E : Error => Check (0, Code_Of (E), -2);
      end;
      for I in 1 .. Batch loop
         Check (Lines (I), Boolean'Pos (Hits (I)), Integer'Max (Codes (I), 0));
      end loop;
   end Check_Batch;

   NaN : constant Double := To_Double (16#7FF8_0000_0000_0000#);

begin
   Open (File, In_File, Argument (1));
   while not End_Of_File (File) loop
      Line := Line + 1;
      declare
         Text : constant String := Get_Line (File);
      begin
         if Text (Text'First) /= '#' then
            Read_Vector (Text);
         end if;
      end;
   end loop;
   Check_Batch;
   begin
      Check (0, Boolean'Pos (Overlap (Point_Kind, Doubles'(NaN, 0.0), Circle_Kind, (0.0, 0.0, 1.0))), -2);
   exception
      when E : Error => Put_Line ("NaN: " & Ada.Exceptions.Exception_Message (E));
   end;
   if Nearest (AABB_Kind, (0.0, 0.0, 2.0, 2.0), Circle_Kind, (6.0, 1.0, 1.0)) = (3.0, 2.0, 1.0, 5.0, 1.0) then
      Put_Line ("nearest: as in C");
   end if;
   Put_Line (Trimmed (Calls) & " calls, " & Trimmed (Batch) & " in a batch");
end Vectors;
