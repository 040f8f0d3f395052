# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Java, by JNI: Vesica.java and libvesica_jni.so, which vesica_jni.c makes.
build() {
  local jdk
  javac -Xlint:all -d "$work" "$host/Vesica.java" "$host/Vectors.java"
  jdk=$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")
  "$CC" -std=c99 -O2 -fPIC -shared -Wall -Wextra -Wconversion -Wshadow -Werror \
    -I "$jdk/include" -I "$jdk/include/linux" -o "$work/libvesica_jni.so" "$host/vesica_jni.c" "${flags[@]}"
}
run() { java -XX:TieredStopAtLevel=1 -Xcheck:jni "-Djava.library.path=$work" -cp "$work" Vectors "$1"; }
