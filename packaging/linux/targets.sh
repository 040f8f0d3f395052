# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2034,SC2154
# To be sourced, with the repository as root and a target as $1: x86_64-gnu, x86_64-musl, aarch64-gnu or aarch64-musl.
# Sets processor, libc, the platform of its wheels, the arguments of cmake, and the emulator, if it needs one.
processor=${1%-*} libc=${1#*-}
packaging=$root/packaging/linux
export NM=$processor-linux-gnu-nm STRIP=$processor-linux-gnu-strip
case $1 in
  x86_64-gnu | aarch64-gnu)
    toolchain=("-DCMAKE_TOOLCHAIN_FILE=$root/tests/platforms/linux.cmake" "-DVESICA_TRIPLET=$processor-linux-gnu")
    platform=manylinux_2_17_$processor.manylinux2014_$processor
    ;;
  x86_64-musl | aarch64-musl)
    musl=$root/build/linux/root-$1
    "$packaging/root.sh" bookworm "$processor" "$musl" musl-dev >&2
    toolchain=("-DCMAKE_TOOLCHAIN_FILE=$packaging/musl.cmake" "-DVESICA_PROCESSOR=$processor" "-DVESICA_MUSL=$musl")
    platform=musllinux_1_2_$processor
    ;;
  *)
    echo "no target $1" >&2
    exit 2
    ;;
esac
emulator=()
[ "$processor" = "$(uname -m)" ] || emulator=("qemu-$processor" -L "/usr/$processor-linux-gnu")

# run LIBRARIES PROGRAM...: runs a program of the target's, which finds shared libraries in the folder LIBRARIES.
run() {
  if [ "$libc" = musl ]; then
    "${emulator[@]}" "$musl/lib/ld-musl-$processor.so.1" --library-path "$1" "${@:2}"
  elif [ ${#emulator[@]} -gt 0 ]; then
    "${emulator[@]}" -E "LD_LIBRARY_PATH=$1" "${@:2}"
  else
    LD_LIBRARY_PATH=$1 "${@:2}"
  fi
}
