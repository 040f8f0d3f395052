#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh MOVED WORK: join_mpi by 1, 2, 4 and 7 ranks: pairs, bad input, a rank that is killed.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/testing.sh"
. "$here/../common/unprivileged.sh"

# mpirun's user can read and write here, whoever owns $work.
stage=$(mktemp -d "${TMPDIR:-/tmp}/vesica-mpi.XXXXXX")
trap 'rm -rf "$stage"' EXIT
"$here/build.sh" "$stage"
cp "$data"/[ab].npy "$LD_LIBRARY_PATH/libvesica.so.0" "$stage"
chmod -R a+rX "$stage"
hand_over "$stage"
export LD_LIBRARY_PATH=$stage
cd "$stage"

ranks() {
  unprivileged mpirun --oversubscribe --bind-to none -n "$1" "${@:2}" 2>&1
}

for n in 1 2 4 7; do
  rm -f pairs.*
  output=$(ranks "$n" ./join_mpi a.npy b.npy pairs)
  contains "what $n ranks say" "ranks $n shapes 40000 pairs 16587 " "$output"
  check "files of $n ranks" "$n" "$(find . -name 'pairs.*.csv' | wc -l)"
  same_pairs "$n ranks" pairs.*.csv
done

# ---- Bad shapes have no pairs, and no other is lost; few shapes, one over everything, infinite bounds ----
/usr/bin/python3 -B - <<'PYTHON'
import numpy

def save(name, rows):
    shapes = numpy.zeros(len(rows), [("kind", "<i8"), ("numbers", "<f8", (7,))])
    for shape, (kind, *numbers) in zip(shapes, rows):
        shape["kind"] = kind
        shape["numbers"][: len(numbers)] = numbers
    numpy.save(name, shapes)

a = numpy.load("a.npy")
bad = numpy.zeros(3, a.dtype)
bad["kind"] = (2, 9, -1)
bad["numbers"][0] = numpy.nan
numpy.save("bad.npy", numpy.concatenate((a, bad)))
save("few.npy", [(0, 1, 1), (2, 0, 0, 2), (2, 1.7e308, 0, 1.7e308)])
save("none.npy", [])
numpy.save("other.npy", numpy.zeros(3))
open("cut.npy", "wb").write(open("a.npy", "rb").read()[:-1])
PYTHON
chmod a+r ./*.npy
rm -f pairs.*
contains 'bad shapes' 'join_mpi: 3 invalid shapes have no pairs' "$(ranks 4 ./join_mpi bad.npy b.npy pairs)"
same_pairs 'with bad shapes' pairs.*.csv
for n in 1 3; do
  rm -f pairs.*
  ranks "$n" ./join_mpi few.npy few.npy pairs >/dev/null
  check "few shapes by $n" '0,0 0,1 0,2 1,0 1,1 1,2 2,0 2,1 2,2' "$(sort pairs.*.csv | paste -sd ' ')"
  contains "no shapes by $n" 'pairs 0 ' "$(ranks "$n" ./join_mpi none.npy few.npy pairs)"
done
for file in other cut nowhere; do
  rm -f pairs.*
  if output=$(ranks 2 ./join_mpi "$file.npy" b.npy pairs); then check "$file.npy" 'an error' "$output"; fi
  contains "$file.npy" "join_mpi: $file.npy: " "$output"
  check "pairs after $file.npy" '' "$(find . -name 'pairs.*.csv')"
done

# ---- A rank killed while it writes: the job ends with an error, and no file is left that could be taken for pairs ----
rm -f pairs.*
mkfifo -m 666 pairs.1.csv.part  # without a reader rank 1 waits here
cat >with_pid.sh <<'SHELL'
echo $$ >"pid.$OMPI_COMM_WORLD_RANK"
exec ./join_mpi a.npy b.npy pairs
SHELL
ranks 4 sh with_pid.sh >killed.out &
job=$!
until [ -s pairs.0.csv.part ] || ! kill -0 $job; do sleep 0.05; done
kill -9 "$(cat pid.1)"
if wait $job; then check 'a killed rank' 'an error' "$(cat killed.out)"; fi
check 'pairs after a kill' '' "$(find . -name 'pairs.*.csv')"
rm pairs.*
ranks 4 ./join_mpi a.npy b.npy pairs >/dev/null
same_pairs 'once more' pairs.*.csv
finish
