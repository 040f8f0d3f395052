# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2034
# To be sourced. linking: the flags that compile and link with the library that pkg-config finds. Outside of the
# system's folders the file remembers where the library was, so that it loads without LD_LIBRARY_PATH.
# Paths with spaces come with backslashes, which read without -r takes away.
# shellcheck disable=SC2162
read -a linking < <(pkg-config --cflags --libs vesica)
libdir=$(realpath "$(pkg-config --variable=libdir vesica)")
case $libdir in
  /usr/lib | /usr/lib/* | /usr/lib64 | /lib | /lib/* | /lib64) ;;
  *) linking+=("-Wl,-rpath,$libdir") ;;
esac
