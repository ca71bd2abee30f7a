#!/usr/bin/env bash
# CPU seconds, wall clock and peak memory of whole processes: least and median of several runs after one to warm
# the file cache, with their bounds beside. Ends with 1 if a least CPU time or a peak of memory is over its bound.
#   program.sh BUILD
set -euo pipefail

build=$1
ashlar=$build/ashlar
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
dam=$root/examples/jointed_dam

# shellcheck source=timing.bash
source "$root/tests/benchmarks/timing.bash"

# measure WHAT BOUND RUNS command… : the bound is in seconds of CPU, for the least of the runs
measure() {
  local what=$1 bound=$2 runs=$3
  shift 3
  local least median wall
  repeat "$runs" "$@"
  read -r least median <<<"$(column 1)"
  wall=$(column 2)
  judge "$least" "$bound"
  # shellcheck disable=SC2086
  printf '%-44s CPU %7.3f %7.3f   wall %7.3f %7.3f   bound: %s s CPU, %s\n' "$what" "$least" "$median" $wall "$bound" "$verdict"
}

peak() { awk -F'[:,]' '/"peak_bytes"/ { printf "%.2f\n", $2 / 1e9 }' "$1"; }

run_dam() { "$ashlar" run "$dam" --set cells="$1" --threads 1 --out "$folder/dam" --json "$folder/dam.json" --quiet; }

echo "seconds: least and median of several runs; the load of the machine was $(cut -d' ' -f1-3 /proc/loadavg)"
"$ashlar" check "$dam" >/dev/null
measure "check of the jointed dam" 0.05 11 "$ashlar" check "$dam"
measure "cantilever, whole process (no gmsh)" 0.15 11 \
  "$ashlar" run "$root/examples/cantilever" --out "$folder/cantilever" --quiet
measure "dam, 20 000 Voronoi cells, all output" 2.5 5 run_dam 20000
echo "  peak memory $(peak "$folder/dam.json") GB"
measure "dam, 100 000 Voronoi cells, all output" 15 3 run_dam 100000
memory=$(peak "$folder/dam.json")
judge "${memory:?the run told no peak_bytes}" 1.5
echo "  peak memory $memory GB   bound: 1.5 GB, $verdict"

crosscheck=$build/tests/crosscheck/crosscheck
if [[ -x $crosscheck ]] && command -v ccx >/dev/null; then
  # Gmsh makes about 20 000 quadrilaterals of this wish.
  TMPDIR=$folder "$crosscheck" 17400 | sed -n 's/^\([0-9]* cells, CalculiX [0-9.]* s of CPU\).*/for comparison, without meshing: \1/p'
else
  echo "no comparison with CalculiX: ccx or $crosscheck is missing"
fi
echo "load at the end $(cut -d' ' -f1-3 /proc/loadavg)"
exit "$over"
