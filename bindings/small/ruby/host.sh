# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Ruby, by fiddle, which comes with it.
build() { ruby -r fiddle -e ''; }
run() { ruby "$host/vectors.rb" "$1"; }
