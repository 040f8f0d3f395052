#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: builds the wheel into DIRECTORY, installs it into a fresh environment without network, and runs
# the tests there. VESICA_BUILD names a build folder of cmake's whose library is taken,
# VESICA_OLDER a folder with a library that is to be refused.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INDEX=1

rm -f "$directory"/vesica-*.whl
"$here/wheel.sh" "$directory"

# numpy and pandas are Debian's. Nothing of the sources is in reach of what is tested.
/usr/bin/python3 -m venv --system-site-packages "$work/environment"
"$work/environment/bin/pip" install --quiet --no-deps "$directory"/vesica-*.whl
"$here/copy_tests.sh" "$work/tests"
cd "$work"
VESICA_PANDAS=1 "$work/environment/bin/python" -B -m unittest discover -s "$work/tests"
"$work/environment/bin/python" -B -c 'import vesica; print("installed:", vesica.__version__, vesica.__file__)'
if [ -n "${VESICA_OLDER:-}" ]; then
  cp "$VESICA_OLDER/libvesica.so.0" "$work"/environment/lib/python3*/site-packages/vesica
  "$work/environment/bin/python" -B -c 'import vesica' >"$work/older" 2>&1 && exit 1
  grep -q 'ImportError: .*older than [0-9]*, which this package needs' "$work/older"
fi
ls "$directory"/vesica-*.whl
