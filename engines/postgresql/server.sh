# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# To be sourced after prefix.sh: a server of its own in a temporary folder, on a socket in it, with the extension built
# from here. Nothing is installed in the system, whose server is only linked to. It ends with the shell that sourced this.
postgres=$(pg_config --bindir)
postgres=${postgres%/bin}
share=$(pg_config --sharedir)
stage=$(mktemp -d "${TMPDIR:-/tmp}/vesica-postgresql.XXXXXX")
trap stop_server EXIT
chmod 755 "$stage"

. "$here/../common/unprivileged.sh"

# link_rest FROM TO: what is in the one folder, and not in the other yet.
link_rest() {
  local file
  mkdir -p "$2"
  for file in "$1"/*; do
    [ -e "$2/${file##*/}" ] || ln -s "$file" "$2/${file##*/}"
  done
}

# A server looks for its files beside its program: so the program is copied, and its files are linked.
build_stage() {
  local root=$stage/root
  cp -r "$here/../common" "$here/../postgresql" "$stage"
  make -s -C "$stage/postgresql" with_llvm=no install "DESTDIR=$root" >"$stage/build.log" 2>&1 || {
    cat "$stage/build.log" >&2
    return 1
  }
  link_rest "$postgres/lib" "$root$postgres/lib"
  link_rest "$share/extension" "$root$share/extension"
  link_rest "$share" "$root$share"
  cp -r "$postgres/bin" "$root$postgres/bin"
  mkdir "$stage/lib" "$stage/socket"
  cp "$LD_LIBRARY_PATH"/libvesica.so.0 "$stage/lib"
  export LD_LIBRARY_PATH=$stage/lib PGHOST=$stage/socket PGUSER=vesica
  PATH=$root$postgres/bin:$PATH
}

start_server() {
  local options="-c listen_addresses= -k $stage/socket -c fsync=off -c max_wal_size=4GB $*"
  unprivileged pg_ctl -s -w -D "$stage/server/data" -l "$stage/server/log" -o "$options" start
}

make_server() {
  build_stage
  mkdir "$stage/server"
  hand_over "$stage/server" "$stage/socket"
  (cd "$stage" && unprivileged initdb -D "$stage/server/data" -A trust -U vesica -E UTF8 --locale=C --no-sync) >/dev/null
  (cd "$stage" && start_server "$@")
}

stop_server() {
  [ ! -f "$stage/server/data/postmaster.pid" ] || (cd "$stage" && unprivileged pg_ctl -s -D "$stage/server/data" -m immediate stop) || true
  rm -rf "$stage"
}

# Nobody of the server is asked, as where its machine ends.
kill_server() {
  local main children
  main=$(head -n 1 "$stage/server/data/postmaster.pid")
  children=$(cat "/proc/$main/task/$main/children")
  # shellcheck disable=SC2086
  kill -9 "$main" $children
  # shellcheck disable=SC2086
  while kill -0 $children 2>/dev/null; do sleep 0.05; done
}

# sql DATABASE [OPTION...]: the statements on standard input; rows without ornament.
sql() {
  psql -X -q -A -t -d "$@" 2>&1
}
