#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: builds a zip into DIRECTORY, of the assembly, its texts and the native library beside it, unpacks
# it into a fresh folder, and there compiles and runs its tests, by mcs and mono. VESICA_SHARED names a folder with a
# libvesica.so.0 to be taken; VESICA_OLDER one with a library that is to be refused. VESICA_TREES names the folder where
# packaging/linux/library.sh has built: the zip then has those libraries too, where NuGet looks for them.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 -B "$here/../declare" csharp
library=$("$here/../../tools/build_library.sh" shared "$directory/shared")
version=$(sed -n 's/ *"version": "\(.*\)",/\1/p' "$here/../../capi/vesica.json")
compile() { mcs -langversion:latest -unsafe -warn:4 -warnaserror "$@"; }

mkdir "$work/vesica-csharp"
compile -target:library "-doc:$work/vesica-csharp/Vesica.xml" "-out:$work/vesica-csharp/Vesica.dll" \
  "$here"/src/*.cs "$here"/generated/*.cs
cp "$library/libvesica.so.0" "$work/vesica-csharp/libvesica.so"
strip --strip-unneeded "$work/vesica-csharp/libvesica.so"
if [ -n "${VESICA_TREES:-}" ]; then
  for target in x86_64-gnu=linux-x64 x86_64-musl=linux-musl-x64 aarch64-gnu=linux-arm64 aarch64-musl=linux-musl-arm64; do
    runtime=$work/vesica-csharp/runtimes/${target#*=}/native
    mkdir -p "$runtime"
    "${target%%-*}-linux-gnu-strip" --strip-unneeded -o "$runtime/libvesica.so" "$VESICA_TREES/${target%=*}/capi/libvesica.so"
  done
fi
cp -r "$here/src" "$here/generated" "$here/Vesica.csproj" "$here/README.md" "$here/../../LICENSE" "$work/vesica-csharp"
rm -f "$directory"/vesica-csharp-*.zip
(cd "$work" && zip -qr "$directory/vesica-csharp-$version.zip" vesica-csharp && rm -rf vesica-csharp)

mkdir "$work/fresh"
cd "$work/fresh"
unzip -q "$directory/vesica-csharp-$version.zip"
cp vesica-csharp/Vesica.dll vesica-csharp/libvesica.so .
compile -r:Vesica.dll -out:VesicaTests.exe "$here"/tests/*.cs
{
  # The README's example, and what it gives.
  printf '%s\n' 'using System;' 'using System.Linq;' 'using Vesica;' 'static class Example { static void Main() {'
  sed -n '/^```csharp$/,/^```$/{/^```/!p}' "$here/README.md"
  echo 'Console.WriteLine("{0} {1} {2} {3} {4} {5} {6} {7}", hit, far > 5, hits.All(x => x), ratio < 0, impact.T > 0,'
  echo 'pairs.Length, inside, met); } }'
} >Example.cs
compile -r:Vesica.dll -out:Example.exe Example.cs
mono Example.exe | grep -Fx 'True True True True True 2 True 1'
mono VesicaTests.exe "$here/../calls/calls.txt" "${VESICA_CALLS:-5000}"

if [ -n "${VESICA_OLDER:-}" ]; then
  cp "$VESICA_OLDER/libvesica.so.0" libvesica.so
  mono VesicaTests.exe >older.out 2>&1 && exit 1
  grep -q 'older than [0-9]*, which this assembly needs' older.out
fi
ls "$directory"/vesica-csharp-*.zip
