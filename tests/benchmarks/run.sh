#!/usr/bin/env bash
# Every benchmark program of the build, then the whole program on scenes; says first how busy the machine is.
# Ends with 1 if one of them is over its bounds.
#   run.sh BUILD [NAME…]
set -euo pipefail

build=$1
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

chosen() { (($# == 1)) || [[ " ${*:2} " == *" $1 "* ]]; }

echo "cores $(nproc), load before the start $(cut -d' ' -f1-3 /proc/loadavg)"
over=0
shopt -s nullglob
for program in "$build"/tests/benchmarks/bench_*; do
  name=$(basename "$program")
  chosen "${name#bench_}" "$@" || continue
  printf '\n== %s\n' "${name#bench_}"
  "$program" || over=1
done
for script in "$here"/*.sh; do
  name=$(basename "$script" .sh)
  [[ $name != run ]] && chosen "$name" "$@" || continue
  printf '\n== %s\n' "$name"
  bash "$script" "$build" || over=1
done
exit "$over"
