# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# C#, by DllImport (Debian: mono-mcs).
build() {
  mcs -unsafe -warnaserror "-out:$work/vectors.exe" "$host"/*.cs "$here/../../csharp/src/Native.cs"
}
run() { mono "$work/vectors.exe" "$1"; }
