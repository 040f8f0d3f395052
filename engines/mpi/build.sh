#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh FOLDER: the program join_mpi into FOLDER, against the library that pkg-config finds.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/../common/linking.sh"
mpicc -std=c99 -O2 -Wall -Wextra -Wconversion -Wshadow -Wmissing-prototypes -Werror \
  -o "$1/join_mpi" "$here"/*.c "${linking[@]}" -lm
