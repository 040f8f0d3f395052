# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# PHP, by its FFI extension, which comes with Debian's php-cli.
build() {
  php -r 'exit(extension_loaded("FFI") ? 0 : 1);'
  cp "$host"/*.php "$here/../../capi/vesica.cdef" "$work"
}
run() { php vectors.php "$1"; }
