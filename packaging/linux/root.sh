#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# root.sh SUITE PROCESSOR FOLDER PACKAGE...: unpacks Debian packages, and all that they depend on, into FOLDER, and
# installs nothing. SUITE is a release of Debian, such as bullseye; PROCESSOR is x86_64 or aarch64. They come from
# where this machine has its own packages from.
set -euo pipefail
[ $# -ge 4 ] || { echo 'usage: root.sh SUITE PROCESSOR FOLDER PACKAGE...' >&2; exit 2; }
case $2 in
  x86_64) architecture=amd64 ;;
  aarch64) architecture=arm64 ;;
  *) echo "root.sh: no processor $2" >&2; exit 2 ;;
esac
mkdir -p "$3"
root=$(cd "$3" && pwd)
[ ! -e "$root/complete" ] || exit 0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p "$work"/{lists/partial,archives/partial}
touch "$work/status"
# shellcheck disable=SC2016
archive=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Origin: Debian' | head -n 1)
[ -n "$archive" ] || { echo 'root.sh: apt-get knows no archive of Debian' >&2; exit 2; }
keys=/usr/share/keyrings/debian-archive-keyring.gpg
echo "deb [signed-by=$keys] $archive $1 main" >"$work/sources.list"
apt=(apt-get -qq -o "Dir::State=$work" -o "Dir::State::lists=$work/lists" -o "Dir::State::status=$work/status"
  -o "Dir::Cache=$work" -o "Dir::Cache::archives=$work/archives" -o "Dir::Etc::sourcelist=$work/sources.list"
  -o Dir::Etc::sourceparts=- -o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture"
  -o APT::Sandbox::User=root -o APT::Install-Recommends=false -o Debug::NoLocking=true)
"${apt[@]}" update
"${apt[@]}" install --download-only --yes "${@:4}"
for package in "$work"/archives/*.deb; do dpkg-deb -x "$package" "$root"; done
touch "$root/complete"
