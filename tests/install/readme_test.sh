#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# readme_test.sh MOVED WORK: the programs of README.md, docs/guide.md, planning.md, recipes.md and cookbook.md compile,
# and answer as they say. README.md is a first page: at most 120 lines, and no link leads nowhere.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"
root=$here/../..
readme=$root/README.md guide=$root/docs/guide.md

block "$readme" c >"$work/demo.c"
[ "$(wc -l <"$work/demo.c")" -gt 10 ]
"$CC" -std=c11 -Wall -Wextra -Wpedantic -Werror -o "$work/demo" "$work/demo.c" "${flags[@]}"
says=$(sed -n 's/^It prints `\([^`]*\)`.*/\1/p' "$readme" | head -n 1)
[ -n "$says" ]
[ "$("$work/demo")" = "$says" ]

# The line that compiles it, word for word, where ./run has installed the library: here, that is the moved install.
rm "$work/demo"
mkdir "$work/build"
ln -s "$moved" "$work/build/install"
line=$(sed -n 's/^    \(cc demo\.c .*\)/\1/p' "$readme")
(cd "$work" && env -u PKG_CONFIG_PATH -u LD_LIBRARY_PATH bash -euc "$line && ./demo") | grep -qxF "$says"

# The README's project, and the first of the guide, which is the same, by the command below each.
mkdir "$work/project"
cp "$work/demo.c" "$work/project"
for page in "$readme" "$guide"; do
  block "$page" cmake >"$work/project/CMakeLists.txt"
  line=$(sed -n 's/^ *`*\(cmake -B out -DCMAKE_PREFIX_PATH[^`]*\).*/\1/p' "$page")
  rm -rf "$work/project/out"
  (cd "$work/project" && env -u PKG_CONFIG_PATH -u LD_LIBRARY_PATH bash -euc "${line//\/path\/to\/vesica/$work}")
  [ "$("$work/project/out/app")" = "$says" ]
done

{
  printf '#include <stdio.h>\n#include <vesica.h>\nint main(void) {\n'
  printf 'struct record { int id; vesica_rect_f32 box; } records[2] = {{1, {0, 0, 1, 0, 1, 1}}, {2, {9, 9, 1, 0, 1, 1}}};\n'
  printf 'vesica_ellipse_f32 ellipse = {1, 1, 1, 0, 2, 1};\nenum { n = 2 };\nuint8_t out[n];\n'
  block "$guide" c 2
  printf 'printf("%%d %%d %%d\\n", (int)hits, out[0], out[1]);\nreturn 0;\n}\n'
} >"$work/many.c"
"$CC" -std=c99 -Wall -Wextra -Werror -o "$work/many" "$work/many.c" "${flags[@]}"
[ "$("$work/many")" = '1 1 0' ]

block "$guide" cpp >"$work/core.cpp"
printf 'int main() { return hit ? 0 : 1; }\n' >>"$work/core.cpp"
"$CXX" -std=c++20 -Wall -Wextra -Werror -o "$work/core" "$work/core.cpp" "${flags[@]}"
"$work/core"

{
  block "$guide" cpp 2
  printf 'int main() { list({{9, 9, 1}, {0, 0, 1}}, {{1, 1, 1, 0, 3, 1}}); }\n'
} >"$work/index.cpp"
"$CXX" -std=c++20 -Wall -Wextra -Werror -o "$work/index" "$work/index.cpp" "${flags[@]}"
[ "$("$work/index")" = '1 0' ]

block "$root/docs/planning.md" cpp >"$work/planning.cpp"
"$CXX" -std=c++20 -Wall -Wextra -Werror -o "$work/planning" "$work/planning.cpp" "${flags[@]}"
[ "$("$work/planning")" = "$(printf '%s\n' 'room 4.10' 'item 0, after 0.84 of the way' 'room 1.18' 'room 1.04')" ]
grep -qF 'It prints `room 4.10`, `item 0, after 0.84 of the way`, `room 1.18` and `room 1.04`.' "$root/docs/planning.md"

block "$guide" cpp 3 >"$work/constant.cpp"
grep -q static_assert "$work/constant.cpp"
"$CXX" -std=c++20 -Wall -Wextra -Werror -fsyntax-only "$work/constant.cpp" "${flags[@]}"

# Each recipe is a block of its own; what it prints is in the line below it. So are those of the cookbook, and the
# polygons of the other two pages.
fragments() {
  printf '#include <stdio.h>\n#include <vesica.h>\nint main(void) {\n'
  cat
  printf 'return 0;\n}\n'
}
recipes=("$root/docs/recipes.md" "$root/docs/cookbook.md")
{
  awk '$0 == "```c" { inside = 1; print "{"; next } $0 == "```" { if (inside) print "}"; inside = 0 } inside' "${recipes[@]}"
  printf '{\n%s\n}\n{\n%s\n}\n' "$(block "$readme" c 2)" "$(block "$guide" c)"
} | fragments >"$work/recipes.c"
"$CC" -std=c11 -Wall -Wextra -Wpedantic -Werror -o "$work/recipes" "$work/recipes.c" "${flags[@]}"
{
  grep -h '^It prints' "${recipes[@]}"
  grep '^It prints' "$readme" | tail -n 1
  grep '^It prints' "$guide"
} | grep -o '`[^`]*`' | tr -d '`' >"$work/recipes.expected"
[ "$(wc -l <"$work/recipes.expected")" -gt 8 ]
"$work/recipes" | diff "$work/recipes.expected" -

[ "$(wc -l <"$readme")" -le 120 ]
for page in "$readme" "$root"/docs/*.md; do
  while read -r target; do
    target=${target:2:-1} target=${target%%#*}
    [[ -z $target || $target == http* || -e ${page%/*}/$target ]] ||
      { echo "$page: a link to $target, which is not there"; exit 1; }
  done < <(grep -o ']([^)]*)' "$page")
done
