# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Builds the playground, the pages around it and the reference of every function into build/site.
#
#   ./run site               builds it
#   ./run site --serve       serves it on a local port too

[[ "$*" = "" || "$*" = --serve ]] || fail "site takes --serve or nothing"
need "${build_packages[@]}" "${wasm_packages[@]}" "${site_packages[@]}"
step 'build WebAssembly' bindings/small/wasm/build.sh "$root/build/wasm"
step 'write pages' docs/site/build.py "$root/build/site" "$root/build/wasm"
echo "site: $root/build/site"
[ $# = 0 ] || "$root/docs/site/serve.py" "$root/build/site"
