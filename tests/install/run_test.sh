#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run_test.sh RUN: what the ./run script decides before it builds anything. dpkg-query, apt-get and sudo are stand-ins.
set -euo pipefail
run=$1
failures=0

check() {
  [ "$2" = "$3" ] && return
  printf '%s is\n%s\nand should be\n%s\n' "$1" "$3" "$2"
  failures=$((failures + 1))
}

status=0
complaint=$("$run" nonsense 2>&1) || status=$?
check 'status of an unknown command' 2 $status
check 'its complaint' "run: 'nonsense' is neither a command nor a file; ./run help lists the commands" "$complaint"
status=0
complaint=$("$run" "$run" "$run" 2>&1) || status=$?
check 'status of two scenes' 2 $status
check 'its complaint' 'run: one scene file at a time' "$complaint"
status=0
complaint=$("$run" --table "$run" "$run" 2>&1) || status=$?
check 'status of two scenes in a table' 2 $status
check 'its complaint' 'run: one scene file at a time' "$complaint"
status=0
complaint=$("$run" --table nowhere 2>&1) || status=$?
check 'status of a table of no file' 2 $status
check 'its complaint' "run: 'nowhere' is not a file" "$complaint"
check 'first line of help' 'usage: ./run [COMMAND]' "$("$run" help | head -n 1)"
check 'help by option' "$("$run" help)" "$("$run" --help)"

# needs USER PACKAGE...: what `need PACKAGE...` runs where only `here` and `twice` are installed.
needs() {
  (
    user=$1
    shift
    # shellcheck source=/dev/null
    . "$run"
    dpkg-query() {
      case ${*: -1} in
        here) echo installed ;;
        twice) printf 'installed\nnot-installed\n' ;;
        removed) echo config-files ;;
        *) return 1 ;;
      esac
    }
    id() { echo "$user"; }
    sudo() { echo "sudo $*"; }
    apt-get() { echo "apt-get $*"; }
    env() { echo "env $*"; }
    need "$@"
  )
}
install='env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends'
check 'with nothing missing' '' "$(needs 0 here twice)"
check 'as root' "apt-get update
$install removed away" "$(needs 0 here removed away)"
check 'as another' "sudo apt-get update
sudo $install away" "$(needs 1000 away twice)"

[ $failures = 0 ]
