# SPDX-License-Identifier: Apache-2.0
# To be sourced.
# block PAGE LANGUAGE [N]: the first fenced block of a language, or the Nth.
block() {
  awk -v open="\`\`\`$2" -v wanted="${3-1}" '
    $0 == open { inside = ++n == wanted; next }
    $0 == "```" { inside = 0 }
    inside' "$1"
}
