# SPDX-License-Identifier: Apache-2.0
"""test.py DATA WORK: joins on a cluster of two processes of 1 GiB each; the pairs go to WORK, a file for each join."""
import os
import pathlib
import signal
import sys
import threading
import time

import dask.array
import dask.distributed
import numpy
import vesica_dask

data, work = map(pathlib.Path, sys.argv[1:])
failures = 0


def check(what, expected, found):
    global failures
    if found != expected:
        print(f"{what} is\n{found}\nand should be\n{expected}")
        failures += 1


def write(name, pairs):
    with open(work / f"{name}.csv", "w") as file:
        for some in pairs:
            numpy.savetxt(file, some, "%d", ",")
    check(f"{name}: count", pairs.count, sum(len(some) for some in pairs))


def files(rows):
    return [vesica_dask.slices(data / f"{side}.npy", rows) for side in "ab"]


def kill_one_worker(client, folder):
    """Kills a worker once the first pairs are there; returns its process."""
    victim = min(client.run(os.getpid).values())

    def wait_and_kill():
        while not list(folder.glob("pairs.*")):
            time.sleep(0.002)
        os.kill(victim, signal.SIGKILL)

    killer = threading.Thread(target=wait_and_kill)
    killer.start()
    return victim, killer


def all_ways(client):
    write("by_cells", vesica_dask.overlap_join(*files(3000), work / "by_cells", cells=16))
    write("as_they_are", vesica_dask.overlap_join(*files(7000), work / "as_they_are"))
    a, b = (numpy.load(data / f"{side}.npy") for side in "ab")
    left, right = dask.array.from_array(a, 6000), [dask.delayed(b[:9999]), dask.delayed(b[9999:])]
    write("array_and_delayed", vesica_dask.overlap_join(left, right, work / "array_and_delayed", cells=9))


def killed_worker(client):
    victim, killer = kill_one_worker(client, work / "killed")
    pairs = vesica_dask.overlap_join(*files(3000), work / "killed", cells=100)
    write("killed", pairs)
    killer.join()
    client.wait_for_workers(2)
    check("the killed worker is gone", False, victim in client.run(os.getpid).values())
    check("files left over", len(pairs.paths), len(list((work / "killed").iterdir())))


def bad_input(client):
    a, b = (numpy.load(data / f"{side}.npy") for side in "ab")
    bad = numpy.zeros(3, a.dtype)
    bad["kind"] = (2, 9, -1)
    bad["numbers"][0] = numpy.nan
    left = [dask.delayed(numpy.concatenate((a, bad)))]
    for cells in (None, 4):
        pairs = vesica_dask.overlap_join(left, [dask.delayed(b)], work / f"bad_{cells}", cells=cells)
        check("invalid shapes", 3, pairs.invalid)
        write(f"bad_{cells}", pairs)
    for empty in ([], [dask.delayed(a[:0])]):
        for cells in (None, 4):
            pairs = vesica_dask.overlap_join(empty, left, work / f"empty_{len(empty)}_{cells}", cells=cells)
            check("of nothing", 0, pairs.count)
    try:
        vesica_dask.overlap_join([dask.delayed(numpy.zeros(3))], left, work / "numbers")
        check("numbers alone", "an error", "none")
    except TypeError as error:
        check("numbers alone", "a partition's records are [('kind', '<i8'), ('numbers', '<f8', (7,))], not float64", str(error))
    try:
        vesica_dask.overlap_join(left, left, work / "numbers")
        check("a folder that was used", "an error", "none")
    except FileExistsError:
        pass
    # Infinite bounds, and one shape over everything.
    few = numpy.zeros(3, a.dtype)
    few["kind"] = (0, 2, 2)
    few["numbers"][:, :3] = (1, 1, 0), (0, 0, 2), (1.7e308, 0, 1.7e308)
    pairs = vesica_dask.overlap_join([few], [dask.delayed(few)], work / "few", cells=4)
    check("few shapes", [[i, j] for i in range(3) for j in range(3)], sorted(numpy.concatenate(list(pairs)).tolist()))


def main():
    cluster = dask.distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, memory_limit="1GiB", dashboard_address=None
    )
    with cluster, dask.distributed.Client(cluster) as client:
        all_ways(client)
        killed_worker(client)
        bad_input(client)
    sys.exit(failures != 0)


if __name__ == "__main__":
    main()
