#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles device.cu as device code and holds every kernel against limits of stack, registers, spills and instructions.

usage: compile.py clang++ [sm_80]      without CUDA: the PTX, its kernels, and their stack by PTX's own numbers
       compile.py nvcc sm_80 [...]     with CUDA: both sides, what ptxas says of each kernel for each architecture, and what a
                                       decided pair takes of the filter kernels' instructions
"""
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # beside the sources
import rates
import sass

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COMMON = ['-std=c++20', f'-I{ROOT}/include', str(HERE / 'device.cu')]
# 36 pairs in step, three of double, and three other forms: three kernels each. One kernel of a user, and one whose
# instructions are known.
KERNELS = {'overlap_by_filter': 42, 'overlap_in_double': 42, 'overlap_exactly': 42, 'predicates': 1, 'known_instructions': 1}
# Of a thread: bytes of stack, registers, bytes spilt. What decides nearly all pairs needs no stack; of the second kernel
# pairs of round shapes call a function. Of a multiprocessor's 65,536 registers these are for 1024, 512 and 512 threads at
# a time. The user's kernel has three questions with their exact stages.
LIMITS = {'overlap_by_filter': (0, 64, 0), 'overlap_in_double': (128, 128, 0), 'overlap_exactly': (40_960, 128, 0),
          'predicates': (65_536, 255, 8192), 'known_instructions': (0, 32, 0)}
# PTX is before ptxas, which lets numbers of one function share their memory: so its stacks are upper bounds, 99 kB where
# nvcc's were 34. nvcc has not seen the code since, nor capsules and rounded rectangles.
LIMITS_OF_PTX = {'overlap_by_filter': (64, 0, 0), 'overlap_in_double': (128, 0, 0), 'overlap_exactly': (49_152, 0, 0),
                 'predicates': (40_960, 0, 0), 'known_instructions': (0, 0, 0)}
# Of a pair that a filter kernel decides; and what must be found in known_instructions.
MOST_INSTRUCTIONS = {'f32': 220, 'f64': 180}
KNOWN = {'fp32': 11, 'fp64': 8, 'memory': 3}


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f'{done.stdout}\n{" ".join(command)}: exit status {done.returncode}')
    return done.stdout


def stacks_of_ptx(text):
    """Kernel -> bytes of stack: its own and that of the deepest chain of calls."""
    own, calls, kernels, name, called = {}, {}, [], None, None
    for line in text.splitlines():
        head = re.match(r'(\.visible |\.weak |\.extern )*\.(entry|func) +(?:\(.*?\) *)?(\w+)', line)
        if head and '.extern' in line:
            sys.exit(f'an external function is called: {line}')
        if head:
            name = head[3]
            own.setdefault(name, 0)
            calls.setdefault(name, set())
            if head[2] == 'entry':
                kernels.append(name)
        depot = re.search(r'__local_depot\d+\[(\d+)\]', line)
        if depot:
            own[name] = int(depot[1])
        if called:
            calls[name].add(line.strip(' \t,'))
        called = re.match(r'\tcall\b', line)

    def deepest(function, above=()):
        if function not in own or function in above:
            sys.exit(f'{function}: not defined here, or it calls itself')
        return own[function] + max((deepest(callee, above + (function,)) for callee in calls[function]), default=0)

    return {kernel: (deepest(kernel), 0, 0) for kernel in kernels}


def by_clang(compiler, arch, folder):
    out = folder / 'device.ptx'
    run([compiler, '-x', 'cuda', '--cuda-device-only', '-nocudainc', '-nocudalib', f'--cuda-gpu-arch={arch}', '-O2', '-S',
         '-DNDEBUG', '-Wall', '-Wextra', '-Werror', '-Wno-unknown-cuda-version', f'-I{HERE}/device', '-o', str(out), *COMMON])
    return stacks_of_ptx(out.read_text())


def by_nvcc(compiler, arch, folder):
    said = run([compiler, '--expt-relaxed-constexpr', '-Werror', 'all-warnings', f'-arch={arch}', '-c', '--resource-usage',
                '--keep', '--keep-dir', str(folder), '-o', f'{folder}/device.o', *COMMON])
    found = {}
    for entry in said.split('Compiling entry function ')[1:]:
        name = entry.split("'")[1]
        stack = re.search(r'(\d+) bytes cumulative stack size', entry)
        spills = max(int(n) for n in re.findall(r'(\d+) bytes spill', entry))
        found[name] = (int(stack[1]) if stack else 0, int(re.search(r'Used (\d+) registers', entry)[1]), spills)
    return found


def check_instructions(arch, cubin):
    """Prints what filter kernels take a pair, and what this comes to on paper; returns faults."""
    number = int(arch.removeprefix('sm_'))
    code = sass.kernels(cubin, number, ('17overlap_by_filter', 'known_instructions'))
    counts = {name: sass.counts_a_pair(instructions) for name, instructions in code.items()}
    known = [counts.pop(name) for name in list(counts) if 'known_instructions' in name]
    faults = [f'known_instructions: {k} is not {KNOWN}' for k in known if any(k[kind] != n for kind, n in KNOWN.items())]
    if len(known) != 1 or len(counts) != KERNELS['overlap_by_filter']:
        faults.append(f'instructions of {len(counts)} filter kernels')
    rates.print_table(counts, number)
    for name, of_kernel in counts.items():
        most = MOST_INSTRUCTIONS['f64' if of_kernel['fp64'] else 'f32']
        if sum(of_kernel.values()) > most:
            faults.append(f'{name}: {sum(of_kernel.values())} instructions a pair, more than {most}')
    return [f'{arch}: {fault}' for fault in faults]


def check(title, found, limits):
    faults = []
    print(title)
    for kind, number in KERNELS.items():
        of_kind = {name: figures for name, figures in found.items() if f'{len(kind)}{kind}' in name}
        stack, registers, spills = (max((figures[i] for figures in of_kind.values()), default=0) for i in range(3))
        print(f'  {len(of_kind):2} x {kind:18} stack at most {stack:6} bytes, {registers:3} registers, {spills} spilt')
        if len(of_kind) != number:
            faults.append(f'{kind}: {len(of_kind)} kernels, not {number}')
        for limit, figure, what in zip(limits[kind], (stack, registers, spills), ('of stack', 'registers', 'spilt')):
            if figure > limit:
                faults.append(f'{kind}: {figure} {what}, more than {limit}')
    return [f'{title}: {fault}' for fault in faults]


def main(compiler, *architectures):
    name = pathlib.Path(compiler).name
    is_nvcc = name == 'nvcc'
    by, limits = (by_nvcc, LIMITS) if is_nvcc else (by_clang, LIMITS_OF_PTX)
    faults = []
    for arch in architectures or ('sm_80',):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            faults += check(f'{name} {arch}', by(compiler, arch, folder), limits)
            if is_nvcc:
                faults += check_instructions(arch, folder / f'device.{arch}.cubin')
    sys.exit('\n'.join(faults) or 0)


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
