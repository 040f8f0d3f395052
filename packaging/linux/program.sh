#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# program.sh PROCESSOR: builds vesica-join for x86_64 or aarch64, in build/linux/PROCESSOR-musl, linked statically with
# musl and with the library: it runs on any Linux. A program that is linked with this machine's glibc would need one as
# new. Prints the program.
# shellcheck disable=SC2154
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
read -r _ tree < <("$root/packaging/linux/library.sh" "$1-musl")
# shellcheck source=/dev/null
. "$root/packaging/linux/targets.sh" "$1-musl"
program=$tree/programs/vesica-join
cmake --build "$tree" --target vesica_join >&2
"$STRIP" "$program"
if readelf -lW "$program" | grep INTERP >&2; then
  echo "program.sh: $program is not static" >&2
  exit 1
fi
echo "$program"
