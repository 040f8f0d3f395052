#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh MOVED WORK: the extension and pattern.sql in Debian's sqlite3: pairs, bad input, a killed writer.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/testing.sh"
# The extension remembers where the library was when it was built.
unset LD_LIBRARY_PATH
"$here/build.sh" "$work"

# sql [FILE.db]: the statements on standard input, with the extension.
sql() {
  { echo ".load $work/vesica_sqlite.so"; cat; } | sqlite3 -batch -bail "$@" 2>&1
}

# ---- Pairs ----
sql "$work/all.db" <<SQL
.read $here/pattern.sql
CREATE TABLE words (line TEXT);
.mode tabs
.import $data/a.csv words
INSERT INTO a SELECT rowid - 1, vs_shape(line) FROM words;
DELETE FROM words;
.import $data/b.csv words
INSERT INTO b SELECT rowid - 1, vs_shape(line) FROM words;
.separator ,
.once $work/pairs.csv
SELECT a, b FROM overlaps;
SQL
same_pairs 'the R*Tree and exact recheck' "$work/pairs.csv"
# The README's query of pairs within a distance, and all pairs of a few rows.
query=$(sed -n '/^```sql$/,/^```$/p' "$here/README.md" | grep -v '```')
check 'within 5' '1' "$(sql "$work/all.db" <<SQL
CREATE TABLE found AS ${query%;} AND b.id < 100;
SELECT (SELECT count(*) FROM found) > 100 AND NOT EXISTS (
  SELECT a.id, b.id FROM a, b WHERE b.id < 100 AND vs_distance(a.shape, b.shape) <= 5 EXCEPT SELECT * FROM found)
  AND NOT EXISTS (SELECT * FROM found EXCEPT SELECT a.id, b.id FROM a, b WHERE b.id < 100 AND vs_distance(a.shape, b.shape) <= 5);
SQL
)"
plan=$(sql "$work/all.db" <<<'EXPLAIN QUERY PLAN SELECT * FROM overlaps;')
contains 'the plan' 'VIRTUAL TABLE INDEX' "$plan"

# ---- Answers, words that keep every bit, NULL ----
check 'answers' "touch|5.0|1|0|0.5|4.0" "$(sql <<'SQL'
SELECT vs_relation('circle 0 0 1', 'circle 2 0 1'), vs_distance(vs_point(3, 4), 'point 0 0'),
  vs_overlap(vs_rect(0, 0, 0.6, 0.8, 1, 2), vs_ellipse(0, 0, 1, 0, 1, 1)), vs_contains('point 0 0', 'circle 0 0 1'),
  vs_iou('aabb 0 0 2 2', 'aabb 1 0 2 2'), vs_area(vs_aabb(0, 0, 2, 2));
SQL
)"
check 'words' 'ellipse 0.1 -0 1e-300 4.94065645841247e-324 1.7976931348623157e+308 0.30000000000000004' \
  "$(sql <<<"SELECT vs_text('ellipse 0.1,-0 1e-300 4.9406564584124654e-324	1.7976931348623157e308 0.30000000000000004');")"
check 'a radius' 'round_rect 0 0 1 0 1 2 0.5|1|0.5|1' "$(sql <<'SQL'
SELECT vs_text(vs_round_rect(0, 0, 1, 0, 1, 2, 0.5)), vs_overlap('round_rect 0 0 1 0 1 2 0.5', 'point 1.5 0'),
  vs_distance(vs_capsule(0, 0, 1, 0, 0.5), 'point 2 0'), vs_valid('round_rect 0 0 1 0 1 2 0.5');
SQL
)"
check 'polygons' 'POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))|0|1.0|48.0|POLYGON ((0 0, 4 0, 0 0.1, 0 0))|1|inside' "$(sql <<'SQL'
CREATE TABLE zones (shape BLOB CHECK (vs_valid(shape)));
INSERT INTO zones VALUES (vs_shape('POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))'));
SELECT vs_text(shape), vs_overlap(shape, 'point 4 4'), vs_distance(shape, 'circle 4 4 1'), vs_area(shape),
  vs_text('MultiPolygon Z (((0 0 1,4 0 1,0 0.1 1,0 0 1)))'), vs_max_x(shape) >= 8, vs_relation('POINT (1 1)', shape) FROM zones;
SQL
)"
check 'lines' 'LINESTRING (0 0, 4 0, 4 4)|MULTILINESTRING ((0 0, 1 0.1), (2 2, 3 3, 4 5))|MULTIPOINT ((1 2), (3 4))|segment 0 0 1 1|aabb 0 0 2 3|1' "$(sql <<'SQL'
SELECT vs_text('LINESTRING(0 0,4 0,4 4)'), vs_text('MULTILINESTRING((0 0,1 0.1),(2 2,3 3,4 5))'), vs_text('MULTIPOINT(1 2,3 4)'),
  vs_text('LINESTRING (0 0, 1 1)'), vs_text('POLYGON ((0 0, 0 3, 2 3, 2 0, 0 0))'),
  vs_shape(vs_text(vs_shape('LINESTRING (0.1 0.2, 1e-320 7, 3 3)'))) = vs_shape('LINESTRING (0.1 0.2, 1e-320 7, 3 3)');
SQL
)"
check 'well-known binary' 'point 1 2|point 1 2|POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 4 6, 2 2))|POLYGON ((0 0, 1 0, 0 1, 0 0), (5 5, 6 5, 5 6.1, 5 5))|LINESTRING (0 0, 4 0, 4 4)|MULTIPOINT ((1 2), (3 4))' "$(sql <<'SQL'
SELECT vs_text(vs_from_wkb(x'0101000000000000000000f03f0000000000000040')),
  vs_text(vs_from_wkb(x'00a0000001000010e63ff000000000000040000000000000004022000000000000')),
  vs_text(vs_from_wkb(x'0103000000020000000500000000000000000000000000000000000000000000000000204000000000000000000000000000002040000000000000204000000000000000000000000000002040000000000000000000000000000000000400000000000000000000400000000000000040000000000000184000000000000000400000000000001040000000000000184000000000000000400000000000000040')),
  vs_text(vs_from_wkb(x'00000000060000000200000000030000000100000004000000000000000000000000000000003ff0000000000000000000000000000000000000000000003ff0000000000000000000000000000000000000000000000000000003000000010000000440140000000000004014000000000000401800000000000040140000000000004014000000000000401866666666666640140000000000004014000000000000')),
  vs_text(vs_from_wkb(x'01ed0300000100000001ea03000003000000000000000000000000000000000000000000000000001c40000000000000104000000000000000000000000000001c40000000000000104000000000000010400000000000001c40')),
  vs_text(vs_from_wkb(x'0104000000020000000101000000000000000000f03f0000000000000040010100000000000000000008400000000000001040'));
SQL
)"
for length in $(seq 0 2 324); do
  echo "SELECT vs_from_wkb(substr(x'00000000060000000200000000030000000100000004000000000000000000000000000000003ff0000000000000000000000000000000000000000000003ff0000000000000000000000000000000000000000000000000000003000000010000000440140000000000004014000000000000401800000000000040140000000000004014000000000000401866666666666640140000000000004014000000000000', 1, $((length / 2))));"
done >"$work/cut.sql"
check 'cut off anywhere' '163' "$({ echo ".load $work/vesica_sqlite.so"; cat "$work/cut.sql"; } | sqlite3 2>&1 | grep -c 'no well-known binary')"
check 'every bit' '0' "$(sql "$work/all.db" <<<'SELECT count(*) FROM a WHERE vs_shape(vs_text(shape)) <> shape;')"
check 'NULL' '1|1|1|1|1' "$(sql <<<"SELECT vs_overlap(NULL, 'point 0 0') IS NULL, vs_valid(NULL) IS NULL,
  vs_point(NULL, 0) IS NULL, vs_area(NULL) IS NULL, vs_iou('point 0 0', 'point 0 0') IS NULL;")"

# ---- Bad input: errors of SQL, and no other row lost ----
bad() {
  contains "$1" "$2" "$(sql <<<"SELECT $1;" || true)"
}
bad "vs_shape('circle nan 0 1')" 'invalid circle: a number is NaN or infinite'
bad "vs_shape('round_rect 0 0 1 0 1 2')" 'round_rect: number 7 of 7 is missing'
bad "vs_shape('capsule 0 0 1 0 -1')" 'invalid capsule: a size is negative'
bad "vs_overlap('circle 0 0 -1', 'point 0 0')" 'invalid circle: a size is negative'
bad "vs_shape('rect 0 0 0 0 1 1')" 'invalid rect: the axis is (0, 0)'
bad "vs_shape('square 1 2')" "unknown kind 'square'"
bad "vs_shape('')" "unknown kind ''"
bad "vs_shape('point 1')" 'point: number 2 of 2 is missing'
bad "vs_shape('point 1 2x')" "'2x' is not a number"
bad "vs_shape('point 1 2 3')" "'3' after the shape"
bad "vs_shape('POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))')" 'invalid polygon: edges of a polygon cross or overlap'
bad "vs_shape('POLYGON ((0 0, 2 2, 2 0)')" "')' is missing"
bad "vs_shape('POLYGON ((0 0, 2 nan, 2 0))')" 'invalid polygon: a number is NaN or infinite'
bad "vs_shape('CURVE (0 0, 2 2)')" 'is no POINT, LINESTRING or POLYGON'
bad "vs_text(x'08')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'0800000000')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'08ffffffff')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'080100000001000000')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'0802000000ffffffff00000000')" 'not a shape: a BLOB of vs_shape'
bad "vs_overlap('point 0 0', x'080100000001000000000000000000f87f0000000000000000')" 'a shape is invalid'
bad "vs_from_wkb(x'0107000000')" 'no well-known binary of points, lines or polygons'
bad "vs_from_wkb(x'01030000ffffffffff')" 'no well-known binary'
bad "vs_from_wkb(x'0102000000ffffffff')" 'no well-known binary'
bad "vs_from_wkb(x'010200000000000000')" 'an empty geometry'
bad "vs_from_wkb('0101000000000000000000f03f000000000000004000')" 'no well-known binary'
bad "vs_overlap(3, 'point 0 0')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'00')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'')" 'not a shape: a BLOB of vs_shape'
bad "vs_text(x'00000000000000f87f0000000000000000')" 'invalid point: a number is NaN or infinite'
bad "vs_point('one', 2)" 'not a number'
bad "vs_distance('point 1e308 0', 'point -1e308 0')" 'the result is out of the range'
check 'good rows among bad ones' '1|point 1 2
2|
3|
4|point 3 4' "$(sql <<'SQL'
CREATE TABLE words (line TEXT);
INSERT INTO words VALUES ('point 1 2'), ('point nan 2'), (NULL), ('point 3 4');
SELECT rowid, vs_text(CASE WHEN vs_valid(line) THEN vs_shape(line) END) FROM words;
SQL
)"
contains 'a bad shape for the table' 'CHECK constraint failed' \
  "$(sql "$work/all.db" <<<"INSERT INTO a VALUES (-1, x'00');" || true)"
# Where bounds are beyond the floats, or between them, the R*Tree finds them as well.
check 'extremes' '3' "$(sql <<SQL
.read $here/pattern.sql
INSERT INTO a VALUES (1, vs_point(1e300, 0)), (2, vs_point(0.1, 1e-310)), (3, vs_circle(-1e308, 0, 1.7e308)), (4, NULL);
INSERT INTO b VALUES (1, vs_point(1e300, 0)), (2, vs_point(0.1, 1e-310)), (3, vs_point(-1e306, 1e307)), (4, NULL);
SELECT count(*) FROM overlaps WHERE a = b;
SQL
)"
check 'bounds are rounded outward' '1|1|1|1' "$(sql <<'SQL'
SELECT vs_min_x(vs_point(0.3, 0)) < 0.3, vs_max_x(vs_point(0.7, 0)) > 0.7, vs_min_y(vs_point(0, -0.7)) < -0.7,
  vs_max_y(vs_point(0, 1e-310)) > 1e-310;
SQL
)"

# ---- A writer killed in the middle: the R*Tree is that of the table ----
sql "$work/killed.db" <"$here/pattern.sql"
{
  echo ".load $work/vesica_sqlite.so"
  for i in $(seq 0 19999); do echo "INSERT INTO a VALUES ($i, vs_circle($i, 0, 0.5)) RETURNING id;"; done
} | sqlite3 "$work/killed.db" >"$work/written" &
writer=$!
trap 'kill -9 "$writer" 2>/dev/null || true' EXIT
until [ -s "$work/written" ] || ! kill -0 "$writer"; do sleep 0.02; done
sleep 0.3
kill -9 "$writer"
wait "$writer" 2>/dev/null || true
check 'after a kill' 'ok|ok|1' "$(sql "$work/killed.db" <<'SQL'
SELECT (SELECT * FROM pragma_integrity_check), rtreecheck('a_bounds'), count(*) BETWEEN 1 AND 19999 FROM a;
SQL
)"
check 'rows without bounds, and bounds without rows' '0|0' "$(sql "$work/killed.db" <<'SQL'
SELECT (SELECT count(*) FROM a WHERE id NOT IN (SELECT id FROM a_bounds)),
  (SELECT count(*) FROM a_bounds WHERE id NOT IN (SELECT id FROM a));
SQL
)"
finish
