# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Fortran 2018, by iso_c_binding.
build() {
  gfortran -std=f2018 -Wall -Wextra -Werror -fcheck=all -J "$work" -o "$work/vectors" \
    "$host/vesica_c.f90" "$host/vesica.f90" "$host/vectors.f90" "${flags[@]}"
}
run() { "$work/vectors" "$1"; }
