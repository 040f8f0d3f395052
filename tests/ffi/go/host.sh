# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Go, by cgo and the installed header.
build() {
  export GOCACHE=$work/cache
  (cd "$host" && go build -buildvcs=false -o "$work/vectors" ./vectors)
}
run() { "$work/vectors" "$1"; }
