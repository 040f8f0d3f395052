#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install_moved.sh BUILD MOVED: installs the build tree, then moves the whole prefix to MOVED, so that what still
# points to the first place is found out.
set -euo pipefail
build=$1 moved=$2 first=$2.first
rm -rf "$first" "$moved"
cmake --install "$build" --prefix "$first"
mv "$first" "$moved"
if grep -rIlF "$first" "$moved"; then
  echo "these installed files name the place they were first installed in" >&2
  exit 1
fi
