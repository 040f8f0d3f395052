#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: one row; an R*Tree over one side is built, then asked for each shape of the other.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
"$here/build.sh" "$work"

{
  echo ".load $work/vesica_sqlite.so"
  echo ".read $here/pattern.sql"
  cat <<SQL
CREATE TABLE words (line TEXT);
.mode tabs
.import $data/a.csv words
INSERT INTO a SELECT rowid - 1, vs_shape(line) FROM words;
DELETE FROM words;
.import $data/b.csv words
INSERT INTO b SELECT rowid - 1, vs_shape(line) FROM words;
SQL
} >"$work/load.sql"
cat >"$work/join.sql" <<SQL
.load $work/vesica_sqlite.so
.separator ,
.once $work/pairs.csv
SELECT a, b FROM overlaps;
SQL
read -r load _ < <(measure sqlite3 "$work/all.db" ".read $work/load.sql")
read -r join memory < <(measure sqlite3 "$work/all.db" ".read $work/join.sql")
row "SQLite: R*Tree, loaded in $load s" "$join" "$memory" "$work/pairs.csv"
