# SPDX-License-Identifier: Apache-2.0
# To be sourced with the moved install as $1 and a directory of the test's own, emptied here, as $2. Compilers come in
# CC and CXX.
set -euo pipefail
moved=$1 work=$2
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd)
# shellcheck source=tests/install/block.sh
. "$(dirname "${BASH_SOURCE[0]}")/block.sh"
rm -rf "$work"
mkdir -p "$work"

PKG_CONFIG_PATH=$(dirname "$(find "$moved" -name vesica.pc)")
export PKG_CONFIG_PATH
export LD_LIBRARY_PATH=${PKG_CONFIG_PATH%/pkgconfig}
# Paths with spaces come with backslashes, which read without -r takes away.
# shellcheck disable=SC2162
read -a flags < <(pkg-config --cflags --libs vesica)
