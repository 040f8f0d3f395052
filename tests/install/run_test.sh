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
status=0
complaint=$("$run" join 2>&1) || status=$?
check 'status of a join of nothing' 2 $status
check 'its complaint' 'run: join takes one or two files of shapes' "$complaint"
status=0
complaint=$("$run" site --quietly 2>&1) || status=$?
check 'status of an unknown way to have the site' 2 $status
check 'its complaint' 'run: site takes --serve or nothing' "$complaint"
check 'first line of help' 'usage: ./run [COMMAND [ARGUMENT]...]' "$("$run" help | head -n 1)"
check 'help by option' "$("$run" help)" "$("$run" --help)"

status=0
complaint=$("$run" test --everything 2>&1) || status=$?
check 'status of an unknown size of test' 2 $status
check 'its complaint' 'run: test takes --all, --cross, --cuda, --engines, --sanitize or nothing' "$complaint"

# Every command has a help of its own, and is in the list of all.
list=$("$run" help)
for script in "$(dirname "$run")"/tools/run/*.sh; do
  command=$(basename "$script" .sh)
  [[ " common packages join stress " != *" $command "* ]] || continue
  check "help of $command" "$(sed -n '3s/^# //p' "$script")" "$("$run" "$command" --help | head -n 1)"
  grep "^  $command  *[A-Z]" <<<"$list" >/dev/null || check "$command in the list of commands" there missing
done

# A step is one line; its output is printed if it fails, and is in a log.
steps_of() {
  (
    # shellcheck source=/dev/null
    . "$run"
    root=$(mktemp -d)
    trap 'rm -rf "$root"' EXIT
    step "$@" 2>&1 | sed "s,$root,ROOT,; s/ [0-9.]* s$/ TIME/"
  )
}
check 'a step' 'one                                TIME' "$(steps_of one echo quiet)"
check 'a failed step' 'loud
run: one failed; all of its output is in ROOT/build/log/one' "$(steps_of one bash -c 'echo loud; exit 3')"

# pretend: within a subshell, only `here` and `twice` are installed, and nothing beyond this script is run.
pretend() {
  # shellcheck source=/dev/null
  . "$run"
  step() { "${@:2}"; }
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
}

# needs USER PACKAGE...: what `need PACKAGE...` runs.
needs() {
  (
    user=$1
    pretend
    need "${@:2}"
  )
}
install='env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends'
check 'with nothing missing' '' "$(needs 0 here twice)"
check 'as root' "to be installed: removed away
apt-get update
$install removed away" "$(needs 0 here removed away)"
check 'as another' "to be installed: away
sudo apt-get update
sudo $install away" "$(needs 1000 away twice)"

# What cannot be had is passed over and named; the others are installed.
possible() {
  (
    user=0
    pretend
    env() {
      [[ " $* " != *' nowhere '* ]] || return 100
      echo "env $*"
    }
    need_if_possible "$@" 2>&1
  )
}
check 'with one that cannot be had' "to be installed: away nowhere
apt-get update
$install away
run: cannot be installed: nowhere" "$(possible here away nowhere)"
check 'with all that can be had' "to be installed: away
apt-get update
$install away" "$(possible here away)"

# steps ARGUMENT...: what ./run does for these arguments, but for asking Debian for packages.
steps() {
  (
    user=0
    pretend
    need() { echo "need: $# packages"; }
    cmake() { echo "cmake $*"; }
    ctest() { echo "ctest $*"; }
    answer() { echo "answer ${1#"$root/"}"; }
    main "$@"
  ) | sed -e '/^need:/d' -e "s,$(dirname "$run")/,,"
}
tests='cmake --preset test
cmake --build --preset test
cmake --install build/test
answer tests/corpus/cases.csv
ctest --preset test'
check 'without a command' 'cmake --preset release
cmake --build --preset release
cmake --install build/release
answer tests/corpus/cases.csv' "$(steps)"
check 'the tests' "$tests" "$(steps test | sed '/^$/d')"
check 'all tests' "$tests
cmake --preset test
cmake --build --preset slow
ctest --preset slow" "$(steps test --all)"
check 'the engines' 'cmake --preset test
cmake --build --preset engines
ctest --preset engines' "$(steps test --engines)"

status=0
complaint=$(PATH=/usr/bin:/bin "$run" test --cuda 2>&1) || status=$?
if ! PATH=/usr/bin:/bin command -v nvcc >/dev/null; then
  check 'status of CUDA without nvcc' 2 $status
  check 'its complaint' 'run: test --cuda needs nvcc, which is not on the PATH; nothing was compiled' "$complaint"
fi

# `./run test` asks for nothing of npm, and for no language but C, C++ and Python.
check 'packages of the tests' 'cmake g++ libgmp-dev libgtest-dev libmpfr-dev libxml2-utils ninja-build pkg-config python3-cffi python3-numpy' \
  "$(. "$run" && printf '%s\n' "${test_packages[@]}" | sort | paste -sd ' ')"

[ $failures = 0 ]
