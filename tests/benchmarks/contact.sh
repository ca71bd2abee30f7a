#!/usr/bin/env bash
# What contact costs: CPU against the bonded body, of each further water level, and of CalculiX on the same mesh;
# and its iterations as the mesh is refined. No pictures or files are written. Ends with 1 if a bound is missed.
#   contact.sh BUILD
set -euo pipefail

build=$1
ashlar=$build/ashlar
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
dam=$root/examples/jointed_dam
levels=$root/tests/benchmarks/levels.lua
joints=$root/tests/benchmarks/joints.lua
# shellcheck source=timing.bash
source "$root/tests/benchmarks/timing.bash"

run() { "$ashlar" run "$@" --threads 1 --no-files --quiet --json "$folder/run.json"; }

# cpu RUNS command… : the least CPU time of its runs.
cpu() {
  repeat "$@"
  column 1 | cut -d' ' -f1
}

# ratio A B [FACTOR] : FACTOR A / B.
ratio() { awk -v a="$1" -v b="$2" -v factor="${3:-1}" 'BEGIN { printf "%.3g\n", factor * a / b }'; }
minus() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f\n", a - b }'; }

# told KEY : the first value of a key in the run's JSON; phase NAME : CPU of a phase of the run.
told() { awk -F'[:, ]+' -v key="\"$1\"" '$2 == key { print $3; exit }' "$folder/run.json"; }
phase() { awk -F'[:,]' -v name="\"$1\"" '/"phase"/ { here = index($2, name) } here && /"cpu"/ { sum += $2 } END { print sum + 0 }' "$folder/run.json"; }

# iterations : the most that a stage took.
iterations() { awk -F'[:,]' '/"number"/ { if ($2 > most) most = $2 } END { print most + 0 }' "$folder/run.json"; }

echo "CPU in seconds, the least of 3 runs; the load of the machine was $(cut -d' ' -f1-3 /proc/loadavg)"
run "$levels" --set cells=1000

bonded=$(cpu 3 run "$dam" --set cells=100000 --set jointed=false)
jointed=$(cpu 3 run "$dam" --set cells=100000)
share=$(ratio "$jointed" "$bonded")
judge "$share" 1.5
echo "dam, 100 000 cells, two stages: bonded $bonded, with contact $jointed, ratio $share   bound: 1.5, $verdict"

first=$(cpu 3 run "$levels" --set cells=100000 --set levels=0)
all=$(cpu 3 run "$levels" --set cells=100000 --set levels=10)
share=$(ratio "$(minus "$all" "$first")" "$first" 10)
judge "$share" 5
echo "friction, 100 000 cells: first stage $first, with ten levels $all, each $share % of the first   bound: 5 %, $verdict"

bonded=$(cpu 3 run "$joints" --set cells=80000 --set count=0)
jointed=$(cpu 3 run "$joints" --set cells=80000)
echo "four rough joints, 80 000 cells, two stages: bonded $bonded, with contact $jointed in $(iterations) iterations, ratio $(ratio "$jointed" "$bonded")"

for cells in 1000 10000 100000; do
  run "$dam" --set cells="$cells"
  smooth=$(iterations)
  run "$levels" --set cells="$cells"
  rough=$(iterations)
  [[ $cells != 1000 ]] || fewest=$rough
  judge "$rough" "$(ratio "$fewest" 2 3)"
  echo "$cells cells: iterations without friction $smooth, with friction $rough   bound: 1.5 times those of 1000 cells, $verdict"
done

crosscheck=$build/tests/crosscheck/crosscheck
if [[ ! -x $crosscheck ]] || ! command -v ccx >/dev/null; then
  echo "no comparison with CalculiX: ccx or $crosscheck is missing"
  exit "$over"
fi
# Gmsh makes about 20 000 and 100 000 quadrilaterals of these wishes.
for wish in 17400 87000; do
  whole=$(cpu 1 run "$dam" --set mesh=quads --set cells="$wish")
  cells=$(told cells)
  ours=$(minus "$whole" "$(phase mesh)")
  read -r same theirs <<<"$(TMPDIR=$folder "$crosscheck" "$wish" | sed -n 's/^\([0-9]*\) cells, CalculiX \([0-9.]*\) s of CPU.*/\1 \2/p')"
  [[ $same == "$cells" ]] || { echo "the meshes differ: $cells and $same cells" >&2; exit 1; }
  share=$(ratio "$theirs" "$ours")
  judge 5 "$share"
  echo "dam, $cells quadrilaterals, without meshing: $ours, CalculiX $theirs, $share times   bound: at least 5, $verdict"
done
echo "load at the end $(cut -d' ' -f1-3 /proc/loadavg)"
exit "$over"
