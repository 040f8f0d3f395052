// SPDX-License-Identifier: Apache-2.0
// Exact overlap queries between plain 2D shapes. Touching counts. vesica_c has every function and constant. An older
// library raises an exception at start.
unit vesica;

{$mode objfpc}{$H+}

interface

uses
  SysUtils, vesica_c;

const
  KindPoint = vesica_point;
  KindSegment = vesica_segment;
  KindCircle = vesica_circle;
  KindAabb = vesica_aabb;
  KindRect = vesica_rect;
  KindEllipse = vesica_ellipse;

type
  // Axes are the cosine and sine of the angle.
  TPoint = TVesicaPointF64;
  TSegment = TVesicaSegmentF64;
  TCircle = TVesicaCircleF64;
  TAabb = TVesicaAabbF64;
  TRect = TVesicaRectF64;
  TEllipse = TVesicaEllipseF64;

  // A distance, and two points that are that far apart: (ax, ay) of a and (bx, by) of b.
  TClosestPoints = TVesicaClosestPointsF64;

  // What the library sees of an array: nothing is copied, and the array must live as long.
  TShapes = TVesicaShapesF64;

  EVesica = class(Exception)
    Code: Integer;
    constructor Create(aCode: Integer);
  end;

// Do two shapes, given by their numbers, share a point?
function Overlap(kindA: Integer; const a: array of Double; kindB: Integer; const b: array of Double): Boolean;
function Overlap(kindA: Integer; const a: array of Single; kindB: Integer; const b: array of Single): Boolean;

// How far apart are two shapes, and which of their points are closest?
function Nearest(kindA: Integer; const a: array of Double; kindB: Integer; const b: array of Double): TClosestPoints;

// `count` shapes, the first at `first`, the next `size` bytes on: records that begin with a shape are as good.
function Shapes(kind: Integer; count: Int64; first: Pointer; size: PtrInt): TShapes;
function Shapes(const a: array of TPoint): TShapes;
function Shapes(const a: array of TSegment): TShapes;
function Shapes(const a: array of TCircle): TShapes;
function Shapes(const a: array of TAabb): TShapes;
function Shapes(const a: array of TRect): TShapes;
function Shapes(const a: array of TEllipse): TShapes;

// Two arrays in step; one of a single shape is repeated. hits says for each whether they overlap; the result is how
// many do. Where a shape is invalid, hits has False for it and every other answer, and EVesica is raised.
function OverlapMany(const a, b: TShapes; var hits: array of Boolean): Int64;

implementation

uses
  Math;

constructor EVesica.Create(aCode: Integer);
begin
  inherited Create(vesica_strerror(aCode));
  Code := aCode;
end;

function Checked(answer: Int64): Int64;
begin
  if answer < 0 then raise EVesica.Create(answer);
  Result := answer;
end;

procedure Need(kind, length: Integer);
begin
  if length < Checked(vesica_field_count(kind)) then raise EArgumentException.Create('too few numbers for a shape');
end;

// Pascal, unlike C, traps overflow and the like, which are nothing unusual inside the library.
function Untrapped: TFPUExceptionMask;
begin
  Result := SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);
end;

function Overlap(kindA: Integer; const a: array of Double; kindB: Integer; const b: array of Double): Boolean;
var
  answer: Int32;
  traps: TFPUExceptionMask;
begin
  Need(kindA, Length(a));
  Need(kindB, Length(b));
  traps := Untrapped;
  answer := vesica_overlap_f64(kindA, @a[0], kindB, @b[0]);
  SetExceptionMask(traps);
  Result := Checked(answer) = 1;
end;

function Overlap(kindA: Integer; const a: array of Single; kindB: Integer; const b: array of Single): Boolean;
var
  answer: Int32;
  traps: TFPUExceptionMask;
begin
  Need(kindA, Length(a));
  Need(kindB, Length(b));
  traps := Untrapped;
  answer := vesica_overlap_f32(kindA, @a[0], kindB, @b[0]);
  SetExceptionMask(traps);
  Result := Checked(answer) = 1;
end;

function Nearest(kindA: Integer; const a: array of Double; kindB: Integer; const b: array of Double): TClosestPoints;
var
  answer: Int32;
  traps: TFPUExceptionMask;
begin
  Need(kindA, Length(a));
  Need(kindB, Length(b));
  traps := Untrapped;
  answer := vesica_nearest_f64(kindA, @a[0], kindB, @b[0], @Result);
  SetExceptionMask(traps);
  Checked(answer);
end;

function Shapes(kind: Integer; count: Int64; first: Pointer; size: PtrInt): TShapes;
begin
  Checked(vesica_shapes_from_records_f64(kind, count, first, size, @Result));
end;

function Shapes(const a: array of TPoint): TShapes;
begin
  Result := Shapes(KindPoint, Length(a), @a[0], SizeOf(TPoint));
end;

function Shapes(const a: array of TSegment): TShapes;
begin
  Result := Shapes(KindSegment, Length(a), @a[0], SizeOf(TSegment));
end;

function Shapes(const a: array of TCircle): TShapes;
begin
  Result := Shapes(KindCircle, Length(a), @a[0], SizeOf(TCircle));
end;

function Shapes(const a: array of TAabb): TShapes;
begin
  Result := Shapes(KindAabb, Length(a), @a[0], SizeOf(TAabb));
end;

function Shapes(const a: array of TRect): TShapes;
begin
  Result := Shapes(KindRect, Length(a), @a[0], SizeOf(TRect));
end;

function Shapes(const a: array of TEllipse): TShapes;
begin
  Result := Shapes(KindEllipse, Length(a), @a[0], SizeOf(TEllipse));
end;

function OverlapMany(const a, b: TShapes; var hits: array of Boolean): Int64;
var
  answer: Int64;
  traps: TFPUExceptionMask;
begin
  if (a.count > 0) and (b.count > 0) and (Length(hits) < Max(a.count, b.count)) then
    raise EArgumentException.Create('hits is too short');
  traps := Untrapped;
  answer := vesica_overlap_many_f64(@a, @b, @hits[0]);
  SetExceptionMask(traps);
  Result := Checked(answer);
end;

initialization
  if vesica_version < vesica_declared_version then
    raise Exception.CreateFmt('vesica %d is older than %d', [vesica_version, vesica_declared_version]);
end.
