# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Guile Scheme, by (system foreign-library).
build() { guile -c '(use-modules (system foreign-library))'; }
run() { guile --no-auto-compile -L "$host" "$host/vectors.scm" "$1"; }
