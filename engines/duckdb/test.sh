#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh MOVED WORK: the extension and pattern.sql in npm's DuckDB: pairs, bad input, a process that is killed.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/testing.sh"
# The extension remembers where the library was when it was built.
unset LD_LIBRARY_PATH
. "$here/load.sh"
"$here/build.sh" "$work"
cd "$work"

# ---- Pairs ----
{ load && join one_thread.csv; } | sql database=all.db threads=1 >/dev/null
same_pairs 'one thread' one_thread.csv
join two_threads.csv | sql database=all.db threads=2 >/dev/null
same_pairs 'two threads' two_threads.csv
join little_memory.csv | sql database=all.db memory_limit=30MB >/dev/null
same_pairs 'little memory' little_memory.csv

# ---- Answers, words that keep every bit, NULL ----
check 'answers' '["touch",5,true,false,0.5,4,2]' "$(sql <<'SQL'
SELECT vs_relation(vs_circle(0, 0, 1), vs_circle(2, 0, 1)), vs_distance(vs_point(3, 4), vs_point(0, 0)),
  vs_overlap(vs_rect(0, 0, 0.6, 0.8, 1, 2), vs_shape('ellipse 0 0 1 0 1 1')), vs_contains(vs_point(0, 0), vs_circle(0, 0, 1)),
  vs_iou(vs_aabb(0, 0, 2, 2), vs_aabb(1, 0, 2, 2)), vs_area(vs_aabb(0, 0, 2, 2)),
  vs_shared_area(vs_aabb(0, 0, 2, 2), vs_aabb(1, 0, 5, 5)) + vs_min_x(vs_point(0, 0)) + vs_max_y(vs_segment(0, 0, 1, 0));
SQL
)"
check 'words' '["ellipse 0.1 -0 1e-300 4.94065645841247e-324 1.7976931348623157e+308 0.30000000000000004"]' \
  "$(sql <<<"SELECT vs_text(vs_shape('ellipse 0.1,-0 1e-300 4.94065645841247e-324 1.7976931348623157e308 0.30000000000000004'));")"
check 'a radius' '["round_rect 0 0 1 0 1 2 0.5",true,0.5]' "$(sql <<'SQL'
SELECT vs_text(vs_round_rect(0, 0, 1, 0, 1, 2, 0.5)), vs_overlap(vs_shape('round_rect 0 0 1 0 1 2 0.5'), vs_point(1.5, 0)),
  vs_distance(vs_capsule(0, 0, 1, 0, 0.5), vs_point(2, 0));
SQL
)"
check 'polygons' '["1"]
["POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))",false,1,48,true]' "$(sql <<'SQL'
CREATE TABLE zones AS SELECT vs_shape('POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))') AS shape;
SELECT vs_text(shape), vs_overlap(shape, vs_point(4, 4)), vs_distance(shape, vs_circle(4, 4, 1)), vs_area(shape),
  vs_text(vs_shape(vs_text(shape))) = vs_text(shape) FROM zones;
SQL
)"
# At a height of 0.5, 5 of 8 quarters of two teeth are inside.
check 'well-known binary' '["POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 4 6, 2 2))","point 1 2"]' "$(sql <<'SQL'
SELECT vs_text(vs_from_wkb(unhex('0103000000020000000500000000000000000000000000000000000000000000000000204000000000000000000000000000002040000000000000204000000000000000000000000000002040000000000000000000000000000000000400000000000000000000400000000000000040000000000000184000000000000000400000000000001040000000000000184000000000000000400000000000000040'))), vs_text(vs_from_wkb(unhex('00a0000001000010e63ff000000000000040000000000000004022000000000000')));
SQL
)"
check 'long ones' '["1"]
["POLYGON","5004","12501",true]' "$(sql <<'SQL'
CREATE TABLE coast AS SELECT vs_shape('POLYGON ((' || string_agg(i || ' ' || i % 2, ', ' ORDER BY i) || ', 5000 9, 0 9, 0 0))') AS shape
  FROM range(5001) r (i);
SELECT vs_text(shape)[:7], octet_length(shape) // 16, (SELECT count(*) FROM coast, range(20001) r (i) WHERE vs_overlap(shape, vs_point(i / 4, 0.5))),
  vs_shape(vs_text(shape)) = shape FROM coast;
SQL
)"
check 'every bit' '["0"]' "$(sql database=all.db <<<'SELECT count(*) FROM a WHERE vs_shape(vs_text(shape)) <> shape;')"
check 'NULL' '[true,true,true,true]' "$(sql <<<"SELECT vs_overlap(NULL, vs_point(0, 0)) IS NULL, vs_valid(NULL) IS NULL,
  vs_point(NULL, 0) IS NULL, vs_iou(vs_point(0, 0), vs_point(0, 0)) IS NULL;")"

# ---- Bad input: errors of SQL, and no other row lost ----
bad() {
  check "$1" "Invalid Input Error: $2" "$(sql <<<"SELECT $1;")"
}
bad "vs_shape('circle nan 0 1')" 'invalid circle: a number is NaN or infinite'
bad "vs_shape('round_rect 0 0 1 0 1 2')" 'round_rect: number 7 of 7 is missing'
bad "vs_circle(0, 0, -1)" 'invalid circle: a size is negative'
bad "vs_shape('square 1 2')" "unknown kind 'square'"
bad "vs_shape('')" "unknown kind ''"
bad "vs_shape('point 0 0' || chr(0))" "unknown kind ''"
bad "vs_shape('POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))')" 'invalid polygon: edges of a polygon cross or overlap'
bad "vs_from_wkb('\\x01\\x07'::BLOB)" 'no well-known binary of points, lines or polygons'
bad "vs_text('\\x08\\x01'::BLOB)" "not a shape: a BLOB of vs_shape's, or words as 'circle 0 0 1'"
bad "vs_shape('point 1')" 'point: number 2 of 2 is missing'
bad "vs_shape('point 1 2 3')" "'3' after the shape"
bad "vs_text('\\x00'::BLOB)" "not a shape: a BLOB of vs_shape's, or words as 'circle 0 0 1'"
bad "vs_overlap('point 0 0', 'point 0 0')" "not a shape: a BLOB of vs_shape's, or words as 'circle 0 0 1'"
bad "vs_distance(vs_point(1e308, 0), vs_point(-1e308, 0))" 'the result is out of the range of its type'
check 'good rows among bad ones' '["4"]
["1","point 1 2",true]
["2",null,false]
["3",null,null]
["4","point 3 4",true]' "$(sql <<'SQL'
CREATE TABLE words AS SELECT * FROM (VALUES (1::BIGINT, 'point 1 2'), (2, 'point nan 2'), (3, NULL), (4, 'point 3 4')) w (id, line);
SELECT id, vs_text(TRY(vs_shape(line))), vs_valid(line) FROM words ORDER BY id;
SQL
)"

# ---- A process killed while it inserts: what was committed is there, all of it and no more ----
{
  echo 'CREATE TABLE killed (id BIGINT, shape BLOB);'
  for i in $(seq 2000); do
    echo "INSERT INTO killed SELECT 1000 * $i + k, vs_circle($i, k, 1) FROM range(1000) r (k);"
  done
} >inserts.sql
: >written
node "$here/sql.mjs" database=all.db <inserts.sql >written &
writer=$!
trap 'kill -9 "$writer" 2>/dev/null || true' EXIT
until [ "$(wc -l <written)" -gt 20 ] || ! kill -0 "$writer"; do sleep 0.02; done
kill -9 "$writer"
wait "$writer" 2>/dev/null || true
check 'after a kill' '[true,true,true]' "$(sql database=all.db <<<"SELECT count(*) >= 20000 AND count(*) < 2000000,
  count(*) % 1000 = 0, count(DISTINCT id) = count(*) FROM killed WHERE vs_text(shape) LIKE 'circle%';")"
join after.csv | sql database=all.db >/dev/null
same_pairs 'after the kill' after.csv
finish
