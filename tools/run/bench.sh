# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Prints benchmarks as tables, beside yardsticks and other libraries.
#
#   ./run bench              all that needs no device, no other language and no engine
#   ./run bench ARGUMENT     scalar calls only, with arguments of Google Benchmark
#   ./run bench batch PART   arrays only, rows whose names hold every PART
#   ./run bench boxes        arrays of boxes to shapes and back, corners and bounds, beside loops by hand
#   ./run bench cast         rays and casts, beside textbook rays and Box2D; rays through an index, casts of arrays
#   ./run bench cuda         overlap of arrays on a CUDA device: [--pairs N] [PART]...; exit status 2 without nvcc, 3
#                            without a device
#   ./run bench detection    pairs by IoU and fusion of boxes, beside plain loops and the full matrix
#   ./run bench engines [N]  the join of N shapes a side (1e5) by each engine of docs/engines.md
#   ./run bench hosts        calls from the packages of other languages, beside C: [host]...
#   ./run bench join         index and join of a million shapes a side, beside Boost.Geometry and GEOS: [n] [repeats]
#                            [row]...
#   ./run bench methods      the named methods beside the exact default; PART as before
#   ./run bench model        the array kernels as llvm-mca models them on seven processors
#   ./run bench nearest      distances and depths with their errors, beside FCL, Boost.Geometry, GEOS and gradient
#                            descent
#   ./run bench polygon      polygons: distances, areas, many questions about one, overlap of triangles and
#                            quadrilaterals, beside GEOS, Boost.Geometry and Box2D
#   ./run bench python       shares of pixels, hulls and smallest rectangles, beside photutils, sep and OpenCV, by calls
#                            from Python; two threads against one
#   ./run bench relation     relation, containment, areas and suppression, beside yardsticks and Boost.Geometry
#   ./run bench start        loading the library, the memory this takes, and the first calls
#   ./run bench topology     within a distance, DE-9IM, shared regions, soft suppression, beside yardsticks and GEOS

programs=$root/build/bench/bench

# bench_of NAME [ARGUMENT...]: the tables of one program, or two.
bench_of() {
  case $1 in
    scalar) "$programs/vesica_bench" "${@:2}" ;;
    start) "$programs/start/vesica_bench_start" "$root/build/bench/capi/libvesica.so" ;;
    cast)
      "$programs/cast/vesica_bench_cast"
      "$programs/cast/vesica_bench_cast_many"
      "$programs/manifold/vesica_bench_manifold"
      ;;
    polygon)
      "$programs/polygon/vesica_bench_polygon"
      "$programs/polygon/vesica_bench_polygon_area"
      "$programs/polygon/vesica_bench_polygon_kept"
      "$programs/polygon/vesica_bench_polygon_overlap"
      ;;
    *) "$programs/$1/vesica_bench_$1" "${@:2}" ;;
  esac
}

case ${1:-} in
  cuda)
    command -v nvcc >/dev/null || fail "bench cuda needs nvcc, which is not on the PATH; nothing was measured"
    # The program would say so too, but after minutes of compiling.
    if ! nvidia-smi -L 2>/dev/null | grep '^GPU' >/dev/null; then
      echo "run: bench cuda needs a CUDA device, and there is none; nothing was measured" >&2
      exit 3
    fi
    build_and_install
    step 'compile bench cuda' bench/cuda/build.sh "$root/build/cuda/bench" native "$root/build/release/capi"
    "$root/build/cuda/bench" "${@:2}"
    ;;
  engines)
    # An engine that cannot be installed has no row.
    need_if_possible "${engine_packages[@]}" postgresql-15-postgis-3
    build_and_install
    "$root/engines/bench.sh" "$prefix" "$root/build/engines" "${@:2}"
    ;;
  hosts)
    need "${wasm_packages[@]}" "${rust_packages[@]}" "${go_packages[@]}" "${java_packages[@]}" "${csharp_packages[@]}" \
      "${python_packages[@]}"
    "$root/bench/hosts/hosts.sh" "$root/build/hosts" "${@:2}"
    ;;
  python)
    need "${python_packages[@]}"
    need_if_possible python3-opencv python3-photutils python3-sep
    build_and_install
    python3 -B "$root/bindings/declare" python
    export LD_LIBRARY_PATH=$root/build/release/capi PYTHONPATH=$root/bindings/python
    /usr/bin/python3 -B "$root/bench/python/peers.py"
    /usr/bin/python3 -B "$root/bench/python/threads.py"
    ;;
  model)
    need "${bench_packages[@]}" llvm-19 python3
    need_if_possible g++-aarch64-linux-gnu
    build bench vesica_bench_batch
    "$root/bench/model/model.sh" "$root/build/bench"
    ;;
  *)
    need "${bench_packages[@]}"
    build bench
    case ${1:-} in
      "")
        for name in scalar start batch boxes cast detection join methods nearest polygon relation topology; do bench_of $name; done
        ;;
      batch | boxes | cast | detection | join | methods | nearest | polygon | relation | start | topology) bench_of "$@" ;;
      *) bench_of scalar "$@" ;;
    esac
    ;;
esac
