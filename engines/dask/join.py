# SPDX-License-Identifier: Apache-2.0
"""join.py A.npy B.npy FOLDER: a join on a cluster of this machine's; --help tells the options."""
import argparse
import json
import resource
import time

import dask.distributed
import vesica_dask


def peak_memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("files", nargs=2)
    parser.add_argument("folder")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--memory", default="1GiB", help="of a worker")
    parser.add_argument("--rows", type=int, default=250000, help="of a partition")
    parser.add_argument("--cells", type=int, default=64, help="0: partitions are spatial already")
    options = parser.parse_args()
    cluster = dask.distributed.LocalCluster(
        n_workers=options.workers, threads_per_worker=1, memory_limit=options.memory, dashboard_address=None
    )
    with cluster, dask.distributed.Client(cluster) as client:
        sides = [vesica_dask.slices(path, options.rows) for path in options.files]
        begin = time.monotonic()
        pairs = vesica_dask.overlap_join(*sides, options.folder, cells=options.cells or None)
        seconds = time.monotonic() - begin
        memory = max(client.run(peak_memory).values())
    print(json.dumps({"pairs": pairs.count, "invalid": pairs.invalid, "seconds": seconds, "MiB": memory}))


if __name__ == "__main__":
    main()
