# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Node, by koffi, as package-lock.json pins it. Packages come from npm's own cache where they are there.
build() {
  cp "$host"/*.mjs "$host"/package*.json "$here/../../capi/vesica.cdef" "$work"
  npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --no-update-notifier --loglevel=error
}
run() { node vectors.mjs "$1"; }
