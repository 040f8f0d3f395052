# SPDX-License-Identifier: Apache-2.0
"""What harmless.txt says: mutants that are proved to change no answer."""


def read(path):
    """[(file, marked line, proof)]: records of three lines. The proof begins with "Slower only" where the mutant is that."""
    lines = [line.strip() for line in path.read_text().split("\n") if line.strip() and not line.startswith("#")]
    return list(zip(lines[0::3], lines[1::3], lines[2::3], strict=True))
