#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# missing_tool_test.sh MOVED WORK OLDER: a host whose tools are not there fails its test, which names the command.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$2"
mkdir -p "$2/host"

# named COMMAND BUILD RUN: a host with these two functions fails, and its test names COMMAND.
named() {
  local output
  printf 'build() { %s; }\nrun() { %s; }\n' "$2" "$3" >"$host/host.sh"
  if output=$(bash "$here/host_test.sh" "$moved" "$work/work" "$host" "$older" 2>&1); then
    echo "a host passes without '$1'" >&2
    exit 1
  fi
  grep -F "$1" <<<"$output" | grep -F fail || { echo "'$1' is not named: $output" >&2; exit 1; }
}

moved=$1 work=$2 host=$2/host older=$3
named 'no-such-compiler --fast' 'true; no-such-compiler --fast; true' true
named 'no-such-interpreter' true 'no-such-interpreter "$1"'
