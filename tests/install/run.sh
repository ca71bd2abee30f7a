#!/usr/bin/env bash
# Installs Ashlar into an empty folder, builds modules outside the tree against it (a material, a friction law), and
# lets the installed program use them.
#   run.sh BUILD CMAKE
set -euo pipefail

build=$1
cmake=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/ashlar
ashlar=$prefix/bin/ashlar

fail() {
  echo "$1"
  printf '%s\n' "${said:-}"
  exit 1
}

# The tests' sources stay as they are: the modules are built from copies.
cp -r "$here/degrading" "$here/power" "$folder"
build_module() {
  "$cmake" -S "$folder/$1" -B "$folder/$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$prefix" &&
    "$cmake" --build "$folder/$1/build"
}
{ "$cmake" --install "$build" --prefix "$prefix" && build_module degrading && build_module power; } \
  >"$folder/log" 2>&1 || fail "a module outside the tree was not built: $(tail -n 20 "$folder/log")"

said=$("$ashlar" list)
[[ $said == *material.elastic* ]] || fail "the installed program does not find its own modules:"
[[ $said != *material.degrading* ]] || fail "the module is there before it was installed:"

said=$(ASHLAR_MODULES=$folder/degrading/build/modules "$ashlar" list)
[[ $said == *material.degrading* ]] || fail "ASHLAR_MODULES does not lead to the module:"

"$cmake" --install "$folder/degrading/build" >/dev/null
said=$("$ashlar" list)
[[ $said == *material.degrading* && $said == *material.elastic* ]] || fail "the installed module is not listed:"

# The library itself is opened: its law takes plane strain and refuses plane stress.
said=$("$ashlar" check "$folder/degrading/scene.lua" --set plane=stress 2>&1) && fail "the module's law was not asked:"
[[ $said == *"this law is for plane strain"* ]] || fail "the module's own words are missing:"

# It computes, and the same law written in the scene gives the same settlements.
settlements() {
  said=$("$ashlar" run "$folder/degrading/scene.lua" --set law="\"$1\"" --no-files --json "$folder/$1.json" 2>&1) ||
    fail "the scene with the law '$1' does not run:"
  grep -oE '"uy": -[0-9][-.e0-9]*' "$folder/$1.json"
}
module=$(settlements module)
lua=$(settlements lua)
awk -v a="$module" -v b="$lua" 'BEGIN {
  n = split(a, x, "\n"); m = split(b, y, "\n")
  if (n != 2 || m != 2) { print "two settlements were expected:", a, b; exit 1 }
  for (i = 1; i <= n; ++i) {
    sub(/.*: /, "", x[i]); sub(/.*: /, "", y[i])
    printf "settlement %s mm by the module, %s mm by the script\n", 1000*x[i], 1000*y[i]
    if (x[i] >= 0 || (x[i] - y[i])^2 > (1e-6*x[i])^2) exit 1
  }
  # Unloading follows the secants.
  if ((x[2]/x[1] - 0.5)^2 > 1e-6) exit 1
}' || fail "the module and the script disagree:"

# The friction law of the other module, which its own library hands to contact's, and its twin in the script: along a
# path, and in a scene whose joint slips in part.
"$cmake" --install "$folder/power/build" >/dev/null
sheared() {
  said=$("$ashlar" drive "$folder/power/drive.lua" --set law="\"$1\"" --out "$folder/power_$1" 2>&1) ||
    fail "the drive with the law '$1' does not run:"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "shear [Pa]") column = i } END { print $column }' \
    "$folder/power_$1/drive.csv"
}
module=$(sheared module)
lua=$(sheared lua)
awk -v a="$module" -v b="$lua" 'BEGIN {
  printf "shear left %s MPa by the module, %s MPa by the script\n", a/1e6, b/1e6
  exit !((3*a/2e6 - 1)^2 < 1e-12 && (a/b - 1)^2 < 1e-12)
}' || fail "module and script disagree about friction, or with the law:"

pushed() {
  said=$("$ashlar" run "$folder/power/scene.lua" --set law="\"$1\"" --no-files --json "$folder/power_$1.json" 2>&1) ||
    fail "the scene with the friction '$1' does not run:"
  grep -qE ' [1-9][0-9]* +[0-9.]+$' <<<"$(grep -E ' push ' <<<"$said")" || fail "nothing slips in the scene with '$1':"
  grep -oE '"ux": [-0-9][-.e0-9]*' "$folder/power_$1.json" | tail -n 1 | sed 's/.*: //'
}
module=$(pushed module)
lua=$(pushed lua)
awk -v a="$module" -v b="$lua" 'BEGIN {
  printf "block moved %s mm by the module, %s mm by the script\n", 1000*a, 1000*b
  exit !(a > 5e-4 && (a/b - 1)^2 < 1e-16)
}' || fail "module and script disagree about the block:"
