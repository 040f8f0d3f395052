# SPDX-License-Identifier: Apache-2.0
"""measure.py COMMAND...: runs it and prints `seconds MiB`, the time it took and the most memory of it or a child."""
import resource
import subprocess
import sys
import time

begin = time.monotonic()
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL)
seconds = time.monotonic() - begin
print(f"{seconds:.3f} {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024}")
