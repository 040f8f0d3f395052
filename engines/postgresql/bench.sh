#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: rows of the join by the index and by vesica_join, and what the server's own types and PostGIS take
# for the same query over other shapes: bounding boxes, circles around them, and the boxes as polygons.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
. "$here/server.sh"
. "$here/load.sh"
make_server -c shared_buffers=512MB -c jit=off
createdb bench
load bench

# timed NAME QUERY: its row. Memory is the most of the session's process, with the shared pages that it touched.
timed() {
  local begin memory seconds
  begin=$(date +%s.%N)
  memory=$(sql bench -F, <<SQL
SELECT pg_backend_pid() AS pid \\gset
\\setenv PID :pid
\\o $work/pairs.csv
$2;
\\o
\\! awk '/VmHWM/ { print int(\$2 / 1024) }' "/proc/\$PID/status"
SQL
  )
  seconds=$(awk "BEGIN { print $(date +%s.%N) - $begin }")
  row "$1" "$seconds" "$memory" "$work/pairs.csv"
}

timed 'PostgreSQL: GiST, `a.shape && b.shape`' "$by_index"
timed 'PostgreSQL: `vesica_join`' "$by_join"

# ---- Peers: boxes and rectangles, as shapes, as bounding boxes, as polygons of PostGIS ----
sql bench >/dev/null <<'SQL'
CREATE FUNCTION corner(n float8[], s float8, t float8) RETURNS text LANGUAGE sql IMMUTABLE AS
  $$SELECT (n[1] + s * n[5] * n[3] - t * n[6] * n[4]) || ' ' || (n[2] + s * n[5] * n[4] + t * n[6] * n[3])$$;
CREATE VIEW rects AS
  SELECT side, id, shape, vs_bounds(shape) AS bounds,
    format('POLYGON((%s,%s,%s,%s,%1$s))', corner(n, -1, -1), corner(n, 1, -1), corner(n, 1, 1), corner(n, -1, 1)) AS words
  FROM (SELECT side, id, shape, (string_to_array(shape::text, ' '))[2:]::float8[] AS n
        FROM (SELECT 'a' AS side, * FROM a UNION ALL SELECT 'b', * FROM b) every
        WHERE shape::text LIKE 'rect%' AND vs_area(shape) > 0) numbers;
CREATE TABLE ra AS SELECT id, shape, bounds, words FROM rects WHERE side = 'a';
CREATE TABLE rb AS SELECT id, shape, bounds, words FROM rects WHERE side = 'b';
CREATE INDEX ON ra USING gist (shape);
CREATE INDEX ON ra USING gist (bounds);
VACUUM ANALYZE ra;
VACUUM ANALYZE rb;
SQL
shapes=$(sql bench <<<'SELECT count(*) FROM ra')
timed 'rectangles with an area alone' 'SELECT ra.id, rb.id FROM rb JOIN ra ON ra.shape && rb.shape'
timed 'their bounding boxes by the built-in type `box`' 'SELECT ra.id, rb.id FROM rb JOIN ra ON ra.bounds && rb.bounds'
if sql bench <<<'CREATE EXTENSION postgis' >/dev/null && sql bench <<<'SELECT postgis_version()' | grep -q '^3'; then
  sql bench >/dev/null <<'SQL'
ALTER TABLE ra ADD polygon geometry;
ALTER TABLE rb ADD polygon geometry;
UPDATE ra SET polygon = ST_GeomFromText(words);
UPDATE rb SET polygon = ST_GeomFromText(words);
CREATE INDEX ON ra USING gist (polygon);
VACUUM FULL ANALYZE ra;
VACUUM FULL ANALYZE rb;
SQL
  timed 'as polygons of PostGIS, `ST_Intersects`' \
    'SELECT ra.id, rb.id FROM rb JOIN ra ON ST_Intersects(ra.polygon, rb.polygon)'
fi
