# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# LuaJIT, by its ffi library and capi/vesica.cdef.
build() { cp "$host"/*.lua "$here/../../capi/vesica.cdef" "$work"; }
run() { luajit vectors.lua "$1"; }
