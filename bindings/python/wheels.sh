#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# wheels.sh DIRECTORY [TARGET...]: builds the library and a wheel for each target (packaging/linux/targets.sh; all four
# unless told), for Python 3.9 and later. Those for glibc run their tests in Debian 11: Python 3.9, numpy 1.19 and glibc
# 2.31, under qemu-user for another processor. There is no Python for musl here: `./run package c` tests its library.
# shellcheck disable=SC2154
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)

# check TARGET WHEEL: pip takes the wheel for the target's platform, and it passes its tests, by the Python of an unpacked Debian 11, which has nothing of this machine's.
check() {
  # shellcheck source=/dev/null
  . "$root/packaging/linux/targets.sh" "$1"
  local work old=$root/build/linux/debian11-$processor triplet=$processor-linux-gnu libraries folder
  work=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf '$work'" EXIT
  /usr/bin/python3 -m pip download --quiet --no-index --find-links "$directory" --no-deps --only-binary :all: \
    --platform "${platform%%.*}" --python-version 39 -d "$work/taken" vesica
  cmp "$work"/taken/*.whl "$2"
  [ "$libc" = gnu ] || return 0
  "$root/packaging/linux/root.sh" bullseye "$processor" "$old" python3-numpy
  /usr/bin/python3 -m zipfile -e "$2" "$work/site"
  "$here/copy_tests.sh" "$work/tests"
  for folder in lib usr/lib; do libraries+=$old/$folder/$triplet:$old/$folder/$triplet/blas:$old/$folder/$triplet/lapack:; done
  cd "$work"
  PYTHONHOME=$old/usr PYTHONPATH=$work/site:$old/usr/lib/python3/dist-packages VESICA_REPEAT=0.25 \
    "${emulator[@]}" "$(echo "$old/lib/$triplet"/ld-2.*.so)" --library-path "$libraries" "$old/usr/bin/python3.9" -B \
    -m unittest discover -s tests
}

built=$("$root/packaging/linux/library.sh" "${@:2}")
while read -r target tree; do
  wheel=$(
    # shellcheck source=/dev/null
    . "$root/packaging/linux/targets.sh" "$target"
    VESICA_BUILD=$tree "$here/wheel.sh" "$directory" "$platform"
  ) </dev/null
  (check "$target" "$wheel") </dev/null
  echo "$wheel"
done <<<"$built"
