#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# readme_test.sh MOVED WORK: the programs that README.md prints compile, and answer as they say.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"
readme=$here/../../README.md

# block LANGUAGE N: the N-th fenced block of a language.
block() {
  awk -v open="\`\`\`$1" -v wanted="$2" '
    $0 == open { inside = ++n == wanted; next }
    $0 == "```" { inside = 0 }
    inside' "$readme"
}

block c 1 >"$work/demo.c"
[ "$(wc -l <"$work/demo.c")" -gt 10 ]
"$CC" -std=c99 -Wall -Wextra -Wpedantic -Werror -o "$work/demo" "$work/demo.c" "${flags[@]}"
[ "$("$work/demo")" = overlap ]

# The line that compiles it, word for word, where ./run has installed the library: here, that is the moved install.
rm "$work/demo"
mkdir "$work/build"
ln -s "$moved" "$work/build/install"
line=$(sed -n 's/^    \(cc demo\.c .*\)/\1/p' "$readme")
(cd "$work" && env -u PKG_CONFIG_PATH -u LD_LIBRARY_PATH bash -euc "$line && ./demo") | grep -qx overlap

{
  printf '#include <stdio.h>\n#include <vesica.h>\nint main(void) {\n'
  printf 'struct record { int id; vesica_rect_f32 box; } records[2] = {{1, {0, 0, 1, 0, 1, 1}}, {2, {9, 9, 1, 0, 1, 1}}};\n'
  printf 'vesica_ellipse_f32 ellipse = {1, 1, 1, 0, 2, 1};\nenum { n = 2 };\nuint8_t out[n];\n'
  block c 2
  printf 'printf("%%d %%d %%d\\n", (int)hits, out[0], out[1]);\nreturn 0;\n}\n'
} >"$work/many.c"
"$CC" -std=c99 -Wall -Wextra -Werror -o "$work/many" "$work/many.c" "${flags[@]}"
[ "$("$work/many")" = '1 1 0' ]

block cpp 1 >"$work/core.cpp"
printf 'int main() { return hit ? 0 : 1; }\n' >>"$work/core.cpp"
"$CXX" -std=c++20 -Wall -Wextra -Werror -o "$work/core" "$work/core.cpp" "${flags[@]}"
"$work/core"
