#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles device.cu as device code and holds every kernel against limits of stack, registers and spills.

usage: compile.py clang++ [sm_80]      without CUDA: the PTX, its kernels, and their stack by PTX's own numbers
       compile.py nvcc sm_80 [...]     with CUDA: both sides, and what ptxas says of each kernel for each architecture
"""
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COMMON = ['-std=c++20', f'-I{ROOT}/include', str(HERE / 'device.cu')]
# 21 pairs in step, one in the other order, and three other forms: three kernels each. And one kernel of a user.
KERNELS = {'overlap_by_filter': 25, 'overlap_in_double': 25, 'overlap_exactly': 25, 'predicates': 1}
# Of a thread: bytes of stack, registers, bytes spilt. What decides nearly all pairs needs no stack. The user's kernel has
# three questions with their exact stages.
LIMITS = {'overlap_by_filter': (0, 64, 0), 'overlap_in_double': (0, 96, 0), 'overlap_exactly': (40_960, 128, 0),
          'predicates': (65_536, 255, 8192)}
# PTX is before ptxas, which lets numbers of one function share their memory: so its stacks are upper bounds.
LIMITS_OF_PTX = {'overlap_by_filter': (0, 0, 0), 'overlap_in_double': (640, 0, 0), 'overlap_exactly': (98_304, 0, 0),
                 'predicates': (98_304, 0, 0)}


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


def by_clang(compiler, arch):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / 'device.ptx'
        run([compiler, '-x', 'cuda', '--cuda-device-only', '-nocudainc', '-nocudalib', f'--cuda-gpu-arch={arch}', '-O2',
             '-S', '-DNDEBUG', '-Wall', '-Wextra', '-Werror', '-Wno-unknown-cuda-version', f'-I{HERE}/device', '-o', str(out), *COMMON])
        return stacks_of_ptx(out.read_text())


def by_nvcc(compiler, arch):
    with tempfile.TemporaryDirectory() as folder:
        said = run([compiler, '--expt-relaxed-constexpr', '-Werror', 'all-warnings', f'-arch={arch}', '-c',
                    '--resource-usage', '-o', f'{folder}/device.o', *COMMON])
    found = {}
    for entry in said.split('Compiling entry function ')[1:]:
        name = entry.split("'")[1]
        stack = re.search(r'(\d+) bytes cumulative stack size', entry)
        spills = max(int(n) for n in re.findall(r'(\d+) bytes spill', entry))
        found[name] = (int(stack[1]) if stack else 0, int(re.search(r'Used (\d+) registers', entry)[1]), spills)
    return found


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
    by, limits = (by_nvcc, LIMITS) if name == 'nvcc' else (by_clang, LIMITS_OF_PTX)
    faults = []
    for arch in architectures or ('sm_80',):
        faults += check(f'{name} {arch}', by(compiler, arch), limits)
    sys.exit('\n'.join(faults) or 0)


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
