# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# To be sourced in the folder of build.sh.
# sql [SETTING=VALUE]...: the statements on standard input.
sql() {
  node "$here/sql.mjs" "$@"
}

# The statements that make tables a and b of draw.py's shapes, and the macros of pattern.sql.
load() {
  local side
  for side in a b; do
    cat <<SQL
CREATE TABLE $side AS SELECT row_number() OVER () - 1 AS id, vs_shape(line) AS shape
  FROM read_csv('$data/$side.csv', columns = {'line': 'VARCHAR'}, delim = '|', header = false, parallel = false);
SQL
  done
  cat "$here/pattern.sql"
}

# join FILE: the statement that writes the pairs.
join() {
  echo "COPY (SELECT * FROM vs_join('a', 'b', 4)) TO '$1' (HEADER false);"
}
