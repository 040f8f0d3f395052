// SPDX-License-Identifier: Apache-2.0
// vectors FILE: the shared vectors (bindings/vectors) by unit vesica. Exit status 0 when all answers are right.
program vectors;

{$mode objfpc}{$H+}

uses
  SysUtils, Math, vesica;

type
  TNumbers = array[0..5] of Double;
  TVector = record
    what: String;
    line, expected, kindA, kindB: Integer;
    a, b: TNumbers;
  end;

var
  batch: array of TVector = nil;
  rects: array of TRect = nil;
  ellipses: array of TEllipse = nil;
  hits: array of Boolean = nil;

procedure Check(line, answer, expected: Integer);
begin
  if answer = expected then Exit;
  WriteLn('line ', line, ': ', answer, ', not ', expected);
  ExitCode := 1;
end;

function Parsed(const text: String): TVector;
var
  words: array of String;
  bits: QWord;
  i: Integer;
begin
  words := text.Split(' ');
  Result.what := words[0];
  Result.expected := StrToInt(words[1]);
  Result.kindA := StrToInt(words[2]);
  Result.kindB := StrToInt(words[9]);
  for i := 0 to 5 do
  begin
    bits := StrToQWord('$' + words[3 + i]);
    Result.a[i] := PDouble(@bits)^;
    bits := StrToQWord('$' + words[10 + i]);
    Result.b[i] := PDouble(@bits)^;
  end;
end;

function Narrow(number: Double): Single;
var
  traps: TFPUExceptionMask;
begin
  traps := SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);
  Result := number;
  SetExceptionMask(traps);
end;

// What the call answers, or the code of its error.
function Scalar(const v: TVector): Integer;
var
  a, b: array[0..5] of Single;
  i: Integer;
begin
  try
    if v.what = 'f64' then Exit(Ord(Overlap(v.kindA, v.a, v.kindB, v.b)));
    for i := 0 to 5 do
    begin
      a[i] := Narrow(v.a[i]);
      b[i] := Narrow(v.b[i]);
    end;
    Result := Ord(Overlap(v.kindA, a, v.kindB, b));
  except
    on e: EVesica do Result := e.Code;
  end;
end;

function Many(count: Integer): Integer;
begin
  try
    Result := OverlapMany(Shapes(rects[0..count - 1]), Shapes(ellipses[0..count - 1]), hits);
  except
    on e: EVesica do Result := e.Code;
  end;
end;

procedure CheckBatch;
var
  i, valid, expectedHits: Integer;
begin
  SetLength(rects, Length(batch));
  SetLength(ellipses, Length(batch));
  SetLength(hits, Length(batch));
  for i := 0 to High(batch) do
  begin
    Move(batch[i].a, rects[i], SizeOf(TRect));
    Move(batch[i].b, ellipses[i], SizeOf(TEllipse));
  end;
  valid := 0;
  expectedHits := 0;
  while batch[valid].expected >= 0 do
  begin
    expectedHits += batch[valid].expected;
    valid += 1;
  end;
  if Many(valid) <> expectedHits then ExitCode := 1;
  // With an invalid element, an error: and yet every valid one has its answer.
  if Many(Length(batch)) <> -2 then ExitCode := 1;
  for i := 0 to High(batch) do Check(batch[i].line, Ord(hits[i]), Max(batch[i].expected, 0));
end;

var
  source: TextFile;
  text: String;
  vector: TVector;
  line: Integer = 0;
  calls: Integer = 0;
  closest: TClosestPoints;

begin
  AssignFile(source, ParamStr(1));
  Reset(source);
  while not Eof(source) do
  begin
    ReadLn(source, text);
    line += 1;
    if text[1] = '#' then Continue;
    vector := Parsed(text);
    vector.line := line;
    if vector.what = 'many' then
      Insert(vector, batch, Length(batch))
    else
    begin
      Check(line, Scalar(vector), vector.expected);
      calls += 1;
    end;
  end;
  CheckBatch;
  try
    Overlap(KindPoint, [NaN, 0], KindCircle, [0, 0, 1]);
  except
    on e: EVesica do WriteLn('NaN: ', e.Message);
  end;
  closest := Nearest(KindAabb, [0, 0, 2, 2], KindCircle, [6, 1, 1]);
  with closest do
    if (distance = 3) and (ax = 2) and (ay = 1) and (bx = 5) and (by = 1) then WriteLn('nearest: as in C');
  WriteLn(calls, ' calls, ', Length(batch), ' in a batch');
end.
