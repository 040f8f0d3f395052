# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# To be sourced. Servers and mpirun refuse to be root, and rightly so.

# unprivileged COMMAND...: as this user, or as nobody where this is root.
unprivileged() {
  if [ "$(id -u)" = 0 ]; then
    setpriv --reuid=nobody --regid="$(id -g nobody)" --clear-groups env "HOME=${TMPDIR:-/tmp}" "$@"
  else
    "$@"
  fi
}

# hand_over FOLDER...: to that user.
hand_over() {
  [ "$(id -u)" != 0 ] || chown nobody "$@"
}
