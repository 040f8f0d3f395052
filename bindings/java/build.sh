#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: builds the jar into DIRECTORY, with the native library inside, and tests it in a fresh folder.
# VESICA_ARCHIVE names a folder with a libvesica.a to be taken; VESICA_OLDER one with a library that is to be refused.
# VESICA_TREES names the folder where packaging/linux/library.sh has built: the jar then has the libraries for all those
# targets inside.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 -B "$here/../declare" java
version=$(sed -n 's/ *"version": "\(.*\)",/\1/p' "$here/../../capi/vesica.json")
jdk=$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")

# native FILE LIBRARY...: the native methods, linked to a library.
native() {
  "${CC:-cc}" -std=c99 -O2 -fPIC -shared -fvisibility=hidden -Wall -Wextra -Wl,--exclude-libs,ALL \
    -I "$jdk/include" -I "$jdk/include/linux" -I "$here/../../capi/include" -I "$here/native" -o "$1" \
    "$here"/{native,generated}/*.c "${@:2}" -lm
}

javac -Xlint:all -Werror --release 17 -d "$work/classes" "$here"/{src,generated}/vesica/*.java
system=Linux-$(java -XshowSettings:properties -version 2>&1 | sed -n 's/ *os.arch = //p')
# inside SYSTEM LIBRARY...: puts the native methods, linked to a library, into the jar.
inside() {
  local file=$work/classes/native/$1/libvesica_jni.so
  mkdir -p "${file%/*}"
  native "$file" "${@:2}"
  "${STRIP:-strip}" --strip-unneeded "$file"
}

# inside_for TARGET: the same for a target of packaging/linux, of the objects of its library.
# shellcheck disable=SC2154
inside_for() (
  root=$here/../..
  # shellcheck source=/dev/null
  . "$root/packaging/linux/targets.sh"
  tree=$VESICA_TREES/$1 CC=$processor-linux-gnu-gcc
  mapfile -t objects < <(find "$tree/src" "$tree/capi/CMakeFiles/vesica.dir" -name '*.o')
  if [ "$libc" = musl ]; then objects+=("-specs=$tree/musl-gcc.specs"); fi
  inside "Linux-${processor/x86_64/amd64}$([ "$libc" = gnu ] || echo -musl)" "${objects[@]}"
)

if [ -n "${VESICA_TREES:-}" ]; then
  for tree in "$VESICA_TREES"/{x86_64,aarch64}-{gnu,musl}; do inside_for "${tree##*/}"; done
else
  library=$("$here/../../tools/build_library.sh" static "$directory/static")
  inside "$system" "$library/libvesica.a"
fi
cp "$here/../../LICENSE" "$work/classes/vesica"
# The release's date for all files: one tree gives the same bytes each time.
date=$(date -u -d "@$("$here/../../packaging/date.sh")" +%FT%TZ)
jar --create --date="$date" --file "$directory/vesica-$version.jar" -C "$work/classes" .
rm -rf "$work/classes"
javadoc -quiet -Xdoclint:all,-missing -Werror -d "$work/javadoc" "$here"/{src,generated}/vesica/*.java

# Nothing of the sources is in reach of what is tested.
mkdir "$work/fresh"
cd "$work/fresh"
javac -Xlint:all -Werror -cp "$directory/vesica-$version.jar" -d . "$here"/tests/vesica/*.java
{
  # The README's example, and what it gives.
  printf '%s\n' 'import java.util.Arrays;' 'import vesica.*;' 'class Example { public static void main(String[] a) {'
  sed -n '/^```java$/,/^```$/{/^```/!p}' "$here/README.md"
  echo 'System.out.println(Arrays.toString(hits) + Arrays.deepToString(pairs) + inside + Arrays.toString(met)); } }'
} >Example.java
javac -cp "$directory/vesica-$version.jar" -d . Example.java
java -cp "$directory/vesica-$version.jar:." Example | grep -Fx '[true, true][[0, 1], [2, 3]]true[true, false]'
java -Xcheck:jni -cp "$directory/vesica-$version.jar:." vesica.Calls "$here/../calls/calls.txt"
java -Xcheck:jni -cp "$directory/vesica-$version.jar:." vesica.Paths
java -Xcheck:jni -Xmx150m -cp "$directory/vesica-$version.jar:." vesica.Arguments "${VESICA_CALLS:-5000}" |
  tee arguments.out
grep 'WARNING.*JNI' arguments.out && exit 1

if [ -n "${VESICA_OLDER:-}" ]; then
  native older.so -L "$VESICA_OLDER" -lvesica "-Wl,-rpath,$VESICA_OLDER"
  run=(java -Dvesica.library=older.so -cp "$directory/vesica-$version.jar:." vesica.Calls)
  "${run[@]}" "$here/../calls/calls.txt" >older.out 2>&1 && exit 1
  grep -q 'older than [0-9]*, which this package needs' older.out
fi
ls "$directory"/vesica-*.jar
