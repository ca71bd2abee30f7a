#!/usr/bin/env bash
# CPU seconds, wall clock and peak memory of the whole program, after one run to warm the file cache.
#   program.sh BUILD
set -euo pipefail

ashlar=$1/ashlar
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
dam=$root/examples/jointed_dam

# measure WHAT BOUND command…
measure() {
  local what=$1 bound=$2 TIMEFORMAT='%U %S %R' spent user system wall
  shift 2
  if ! spent=$({ time "$@" >"$folder/said" 2>&1; } 2>&1); then
    cat "$folder/said" >&2
    exit 1
  fi
  read -r user system wall <<<"$spent"
  awk -v what="$what" -v bound="$bound" -v cpu="$user" -v system="$system" -v wall="$wall" \
    'BEGIN { printf "%-60s %8.3f s CPU %8.3f s wall   bound: %s\n", what, cpu + system, wall, bound }'
}

peak() { sed -n 's/.*"peak_[a-z]*" *: *\([0-9.]*\).*/\1/p' "$1" | head -n 1; }

"$ashlar" check "$dam" >/dev/null
measure "check of the jointed dam" "0.05 s wall" "$ashlar" check "$dam"
measure "cantilever, whole process (no gmsh, no contact)" "0.15 s wall" \
  "$ashlar" run "$root/examples/cantilever" --out "$folder/cantilever" --quiet
measure "jointed dam, 20 000 Voronoi cells, two stages, all output" "2.5 s CPU" \
  "$ashlar" run "$dam" --set cells=20000 --out "$folder/dam20" --json "$folder/dam20.json" --quiet
measure "jointed dam, 100 000 Voronoi cells, two stages, all output" "15 s CPU, 1.5 GB" \
  "$ashlar" run "$dam" --set cells=100000 --out "$folder/dam100" --json "$folder/dam100.json" --quiet
echo "peak memory of the last two: $(peak "$folder/dam20.json") and $(peak "$folder/dam100.json")"
