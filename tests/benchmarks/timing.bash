# For benchmark scripts to source: they set `folder` (temporary), and end with `exit "$over"`.
# shellcheck shell=bash disable=SC2034,SC2154

# once command… : appends "CPU wall" to $folder/times.
once() {
  local TIMEFORMAT='%U %S %R' spent user system wall
  if ! spent=$({ time "$@" >"$folder/said" 2>&1; } 2>&1); then
    cat "$folder/said" >&2
    exit 1
  fi
  read -r user system wall <<<"$spent"
  awk -v u="$user" -v s="$system" -v w="$wall" 'BEGIN { printf "%.3f %.3f\n", u + s, w }' >>"$folder/times"
}

# column N : "least median" of one column of the times.
column() {
  cut -d' ' -f"$1" "$folder/times" | sort -n | awk '{ t[NR] = $1 } END { print t[1], t[int((NR + 1) / 2)] }'
}

# repeat RUNS command… : its times alone.
repeat() {
  local runs=$1 i
  shift
  : >"$folder/times"
  for ((i = 0; i < runs; i++)); do once "$@"; done
}

over=0

# judge VALUE BOUND : sets `verdict`, and `over` if the value is above its bound.
judge() {
  verdict=within
  if ! awk -v value="$1" -v bound="$2" 'BEGIN { exit !(value <= bound) }'; then
    verdict=OVER
    over=1
  fi
}
