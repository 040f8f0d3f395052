#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bare.sh [CACHE]: does a bare Debian 12 get from a clone to passing tests by the README's two commands? Makes a minimal
# root (debootstrap and git, nothing else), clones this repository's HEAD into it, and runs there, as root, each command
# that the README prints under "Two commands", word for word. Needs root and the network; run by hand, for it takes
# minutes. The root is packed into CACHE (build/bare unless told) and kept; what runs is a fresh copy every time.
# After each command it prints how long that took, of the clock and of processors, the installation of packages
# included, and what has been installed beyond the bare root. VESICA_MIRROR names another Debian mirror. Exit status 0
# when every command's is.
set -euo pipefail

# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../../tools/run/common.sh"
[ "$(id -u)" = 0 ] || fail "bare.sh has to be root, for chroot"
need debootstrap git util-linux
mkdir -p "${1:-$root/build/bare}"
cache=$(cd "${1:-$root/build/bare}" && pwd)
packed=$cache/bookworm.tar bare=$cache/root

if [ ! -e "$packed" ]; then
  rm -rf "$cache/new"
  debootstrap --variant=minbase --include=git bookworm "$cache/new" ${VESICA_MIRROR:+"$VESICA_MIRROR"} \
    >"$cache/debootstrap.log" || fail "debootstrap failed; see $cache/debootstrap.log"
  tar -C "$cache/new" -cf "$packed.part" .
  mv "$packed.part" "$packed"
  rm -rf "$cache/new"
fi
rm -rf "$bare"
mkdir "$bare"
tar -C "$bare" -xf "$packed"
cp -L /etc/resolv.conf "$bare/etc/resolv.conf"
git clone --quiet --no-hardlinks "$root" "$bare/vesica"

mapfile -t commands < <(awk '/^## / { inside = $0 == "## Two commands" }
                             inside && /^    / { print substr($0, 5) }' "$bare/vesica/README.md")
[ ${#commands[@]} = 2 ] || fail "the README prints ${#commands[@]} commands under 'Two commands', not two"
echo "bare: $(cat "$bare/etc/debian_version"), $(git -C "$bare/vesica" log -1 --format='commit %h')"

# inside COMMAND: in the root, with its own mounts and processes, which end with it, and a new login's environment.
inside() {
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child bash -c 'mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" &&
    exec env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$1" bash -c "cd /vesica && $2"' \
    inside "$bare" "$1"
}

# Megabytes of all that is installed, as the packages say.
installed() {
  # shellcheck disable=SC2016
  chroot "$bare" dpkg-query -W -f='${db:Status-Status} ${Installed-Size}\n' |
    awk '$1 == "installed" { kb += $2 } END { printf "%d", kb / 1000 }'
}

failures=0
TIMEFORMAT='bare: %0R s, of processors %0U s and %0S s in the system'
bare_size=$(installed)
for command in "${commands[@]}"; do
  echo "bare: $command"
  status=0
  time inside "$command" || status=$?
  echo "bare: status $status, $(($(installed) - bare_size)) MB of packages installed"
  [ $status = 0 ] || failures=$((failures + 1))
done
[ $failures = 0 ]
