# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Perl, by FFI::Platypus (Debian: libffi-platypus-perl).
build() { perl -MFFI::Platypus -e ''; }
run() { perl "$host/vectors.pl" "$1"; }
