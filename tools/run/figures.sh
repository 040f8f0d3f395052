# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Writes the figures of docs/figures anew.

need "${test_packages[@]}"
build test vesica_figures
"$root/build/test/tests/figures/program/vesica_figures" "$root/docs/figures"
