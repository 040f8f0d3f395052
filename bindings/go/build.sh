#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: packs the module into DIRECTORY as a zip that has the headers and the static library inside,
# unpacks it into a fresh folder without network, and there runs go vet and its tests, and a program that uses it.
# VESICA_ARCHIVE names a folder with a libvesica.a to be taken.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
directory=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
export GOFLAGS=-mod=mod GOPROXY=off GOCACHE=$work/cache
library=$("$here/../../tools/build_library.sh" static "$directory/static")
version=$(sed -n 's/ *"version": "\(.*\)",/\1/p' "$here/../../capi/vesica.json")

module=$work/vesica-go
mkdir -p "$module/include" "$module/lib"
cp "$here"/*.go "$here/go.mod" "$here/declarations.h" "$here/README.md" "$here/../../LICENSE" "$module"
cp "$here"/../../capi/include/vesica*.h "$module/include"
cp "$library/libvesica.a" "$module/lib"
unformatted=$(cd "$here" && gofmt -l ./*.go)
[ -z "$unformatted" ] || { echo "go: not as gofmt has it: $unformatted" >&2; exit 1; }
rm -f "$directory"/vesica-go-*.zip
(cd "$work" && zip -qr "$directory/vesica-go-$version.zip" vesica-go)

mkdir -p "$work/fresh/program"
cd "$work/fresh"
unzip -q "$directory/vesica-go-$version.zip"
(cd vesica-go && go vet . && VESICA_CALLS_FILE=$here/../calls/calls.txt go test .)

cd program
cat >go.mod <<'END'
module program

go 1.19

require example.org/vesica v0.0.0
replace example.org/vesica => ../vesica-go
END
# The program is the README's example.
{
  printf '%s\n' 'package main' '' 'import (' '"fmt"' '"math"' '' '"example.org/vesica"' ')' '' 'func main() {'
  sed -n '/^```go$/,/^```$/{/^```/!p}' "$here/README.md"
  echo 'fmt.Println("overlap:", hit, far.Distance > 5, n, item, impact.T, pairs, inside, m, err)'
  echo '}'
} >main.go
go run . | grep -Fx 'overlap: true true 2 0 0 [{0 2} {1 3}] true 2 <nil>'
ls "$directory"/vesica-go-*.zip
