#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh MOVED WORK: the extension in a server of its own: expected output, pairs, extremes, dump and restore, kill -9.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/testing.sh"
. "$here/server.sh"
. "$here/load.sh"
make_server

# ---- Answers, plans, errors ----
createdb answers
psql -X -q -a -d answers <"$here/sql/vesica.sql" >"$work/vesica.out" 2>&1
diff -u "$here/expected/vesica.out" "$work/vesica.out" || failures=$((failures + 1))

# ---- Pairs ----
createdb pairs
load pairs
contains 'the plan' 'Index Scan using a_shape_idx' "$(sql pairs <<<"EXPLAIN $by_index")"
sql pairs -F, <<<"$by_index" >"$work/by_index.csv"
same_pairs 'GiST and exact recheck' "$work/by_index.csv"
sql pairs -F, <<<"$by_join" >"$work/by_join.csv"
same_pairs 'vesica_join' "$work/by_join.csv"
sql pairs -F, <<<"SET work_mem = '64kB'; $by_join" >"$work/by_join.csv"
same_pairs 'vesica_join with little memory' "$work/by_join.csv"

# ---- Of all magnitudes: what the index answers is what the rows answer ----
sql pairs <<'SQL'
CREATE TABLE extremes (id serial, shape vshape);
SELECT setseed(0.5);
INSERT INTO extremes (shape)
  SELECT vs_ellipse(x * s, y * s, 1, k, abs(x) * s / 8, abs(y) * s / 64)
  FROM (SELECT random() - 0.5 AS x, random() - 0.5 AS y, random() AS k, 2.0 ^ (10 * (i % 200 - 100))::float8 AS s
        FROM generate_series(1, 3000) i) r;
INSERT INTO extremes (shape) VALUES ('circle -1e308 0 1.7e308'), ('point 1.7e308 1'), ('segment 0 0 5e-324 0'), (NULL);
CREATE INDEX ON extremes USING gist (shape);
ANALYZE extremes;
SQL
windows="SELECT w.id, e.id FROM extremes w JOIN extremes e ON e.shape && w.shape WHERE w.id % 40 < 2 ORDER BY 1, 2"
nearest="SELECT w.id, (SELECT array_agg(d) FROM (SELECT e.shape <-> w.shape AS d FROM extremes e WHERE e.shape IS NOT NULL
  AND e.id <= 3000 ORDER BY e.shape <-> w.shape LIMIT 5) n) FROM extremes w WHERE w.id % 40 = 0 ORDER BY 1"
tight="SELECT b.id, (SELECT array_agg(d) FROM (SELECT a.shape <-> b.shape AS d FROM a ORDER BY a.shape <-> b.shape LIMIT 9) n)
  FROM b WHERE b.id % 500 = 0 ORDER BY 1"
for question in "$windows" "$nearest" "$tight"; do
  with=$(sql pairs <<<"SET enable_seqscan = off; SET enable_sort = off; $question")
  without=$(sql pairs <<<"SET enable_indexscan = off; SET enable_bitmapscan = off; $question")
  check 'by index' "$without" "$with"
done
contains 'nearest by index' 'Order By: (shape <-> w.shape)' "$(sql pairs <<<"SET enable_seqscan = off; EXPLAIN $nearest")"

# ---- Bad input: COPY refuses as a whole, with the line; other rows stay ----
contains 'a bad line of COPY' 'ERROR:  vshape: invalid point: a number is NaN or infinite' \
  "$(printf 'point 0 0\npoint nan 0\n' | sql pairs -c 'COPY b (shape) FROM STDIN')"
contains 'and its number' 'line 2' "$(printf 'point 0 0\npoint nan 0\n' | sql pairs -c 'COPY b (shape) FROM STDIN')"
contains 'bad bytes' 'ERROR:' "$(printf 'PGCOPY\n\377\r\n\0\0\0\0\0\0\0\0\0\0\1\0\0\0\24\0\0\0\0\177\370\0\0\0\0\0\0\0\0\0\0\0\0\0\0\377\377' |
  sql pairs -c 'COPY b (shape) FROM STDIN (FORMAT binary)')"
check 'rows left' '20000' "$(sql pairs <<<'SELECT count(*) FROM b')"

# ---- Dump and restore, in words and in bytes, keep every bit ----
bits="SELECT md5(string_agg(coalesce(vshape_send(shape), ''), '' ORDER BY id)) FROM"
createdb restored
pg_dump pairs | sql restored >/dev/null
for table in a b extremes; do
  check "$table, restored" "$(sql pairs <<<"$bits $table")" "$(sql restored <<<"$bits $table")"
done
sql restored <<<"TRUNCATE extremes"
psql -X -q -d pairs -c 'COPY extremes TO STDOUT (FORMAT binary)' >"$work/extremes.bin"
psql -X -q -d restored -c 'COPY extremes FROM STDIN (FORMAT binary)' <"$work/extremes.bin"
check 'in bytes' "$(sql pairs <<<"$bits extremes")" "$(sql restored <<<"$bits extremes")"
sql restored -F, <<<"$by_index" >"$work/restored.csv"
same_pairs 'GiST, restored' "$work/restored.csv"

sql answers <<<"CREATE TABLE copied (id int, shape vshape)"
psql -X -q -d answers -c 'COPY zones TO STDOUT (FORMAT binary)' >"$work/zones.bin"
psql -X -q -d answers -c 'COPY copied FROM STDIN (FORMAT binary)' <"$work/zones.bin"
check 'polygons in bytes' "$(sql answers <<<"$bits zones")" "$(sql answers <<<"$bits copied")"
for byte in $(seq 30 40 400); do
  { head -c "$byte" "$work/zones.bin" && printf '\377\377' && tail -c +"$((byte + 3))" "$work/zones.bin"; } >"$work/bent.bin"
  psql -X -q -d answers -c 'COPY copied FROM STDIN (FORMAT binary)' <"$work/bent.bin" >/dev/null 2>&1 || true
done
check 'after bent bytes' 't' "$(sql answers <<<'SELECT count(*) >= 9 FROM copied WHERE shape IS NOT NULL')"

# ---- kill -9 of the whole server while rows are inserted ----
sql pairs <<<'CREATE TABLE killed (id int, shape vshape); CREATE INDEX ON killed USING gist (shape);'
for i in $(seq 100000); do echo "INSERT INTO killed VALUES ($i, vs_circle($i % 317, $i % 211, 0.6));"; done |
  sql pairs >/dev/null &
sql pairs <<<"INSERT INTO killed SELECT -i, vs_circle(i % 317, 0, 1) FROM generate_series(1, 10000000) i" >/dev/null &
until [ "$(sql pairs <<<'SELECT count(*) > 500 FROM killed')" = t ]; do sleep 0.1; done
kill_server
wait
(cd "$stage" && start_server)
check 'rows of the finished statements alone' 't|t|t' \
  "$(sql pairs <<<'SELECT count(*) > 500, count(*) = max(id), min(id) = 1 FROM killed')"
held="SELECT count(*), sum(k.id::int8) FROM (SELECT vs_circle(x, y, 2) AS w FROM generate_series(0, 316, 9) x,
  generate_series(0, 210, 9) y) q JOIN killed k ON k.shape && q.w"
check 'index scan and sequential scan' "$(sql pairs <<<"SET enable_indexscan = off; SET enable_bitmapscan = off; $held")" \
  "$(sql pairs <<<"SET enable_seqscan = off; $held")"
contains 'the index scan' 'killed_shape_idx' "$(sql pairs <<<"SET enable_seqscan = off; EXPLAIN $held")"
sql pairs -F, <<<"$by_index" >"$work/after.csv"
same_pairs 'GiST after the kill' "$work/after.csv"
finish
