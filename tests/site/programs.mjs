// SPDX-License-Identifier: Apache-2.0
// Programs that the playground offers: run, and what they print.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';

export const languages = ['c', 'cpp', 'python', 'javascript'];

const shell = (command) => execFileSync('bash', ['-c', command], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });

/** Programs of C or C++ as functions of one, which calls them all. */
function compiled(programs, file, compile) {
  const includes = new Set(programs.flatMap((program) => program.match(/^#include .*$/gm)));
  const functions = programs.map((program, i) =>
    program.replace(/^#include .*\n+/gm, '').replace(/int main\((void)?\)/, `static int f${i}()`).replace(/\n}\n$/, '\nreturn 0;\n}\n'),
  );
  const calls = programs.map((_, i) => `f${i}();`);
  writeFileSync(file, [...includes, ...functions, 'int main() {', ...calls, 'return 0;\n}\n'].join('\n'));
  shell(`${compile} -o ${file}.out ${file} ${process.env.VESICA_FLAGS}`);
  return shell(`./${file}.out`);
}

const run = {
  c: (programs) => compiled(programs, 'programs.c', '"$CC" -std=c11 -Wall -Wextra -Werror'),
  cpp: (programs) => compiled(programs, 'programs.cpp', '"$CXX" -std=c++20 -O0 -Wall -Wextra -Werror'),
  /** Each by itself; what fails says so in a line. */
  python: (programs) => {
    writeFileSync('programs.json', JSON.stringify(programs));
    writeFileSync(
      'programs.py',
      `import json, vesica
for program in json.load(open('programs.json')):
    try:
        exec(program, {})
    except vesica.VesicaError as error:
        print(error)
`,
    );
    return shell('PYTHONPATH="$VESICA_PYTHON" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 programs.py');
  },
  javascript: (programs) => {
    mkdirSync('node_modules/vesica', { recursive: true });
    shell(`cp "$VESICA_SITE"/vesica/* "$VESICA_JAVASCRIPT"/package.json node_modules/vesica`);
    // Modules are loaded once; programs are bodies of functions.
    const bodies = programs.map((program) => `async () => {\n${program.replace(/^import .*\n/, '')}}`);
    writeFileSync(
      'programs_all.mjs',
      `import { load, VesicaError } from 'vesica';
for (const program of [\n${bodies.join(',\n')}\n]) {
  try {
    await program();
  } catch (error) {
    if (!(error instanceof VesicaError)) throw error;
    console.log(error.message);
  }
}
`,
    );
    return shell('node programs_all.mjs');
  },
};

/** A line each: what they print. */
export const printed = (language, programs) => run[language](programs).trimEnd().split('\n');
