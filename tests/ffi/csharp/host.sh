# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# C#, by DllImport (Debian: mono-mcs).
build() { mcs -warnaserror "-out:$work/vectors.exe" "$host/Vesica.cs" "$host/Vectors.cs"; }
run() { mono "$work/vectors.exe" "$1"; }
