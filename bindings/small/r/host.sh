# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# R, by .Call: vesica.R and vesica_r.so, which vesica_r.c makes (in a package, as src/vesica_r.c).
build() {
  cp "$host"/*.R "$work"
  "$CC" -std=c99 -O2 -fPIC -shared -Wall -Wextra -Wconversion -Wshadow -Werror \
    -isystem "$(Rscript -e 'cat(R.home("include"))')" -o "$work/vesica_r.so" "$host/vesica_r.c" "${flags[@]}"
}
run() { Rscript --vanilla vectors.R "$1"; }
