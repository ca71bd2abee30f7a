#!/usr/bin/env bash
# Installs Ashlar into an empty folder, builds a module outside the tree against it, and lets the installed
# program use that module.
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

# The tests' sources stay as they are: the module is built from a copy.
cp -r "$here/lame" "$folder/lame"
{
  "$cmake" --install "$build" --prefix "$prefix"
  "$cmake" -S "$folder/lame" -B "$folder/lame/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$prefix"
  "$cmake" --build "$folder/lame/build"
} >"$folder/log" 2>&1 || fail "the module outside the tree was not built: $(tail -n 20 "$folder/log")"

said=$("$ashlar" list)
[[ $said == *material.elastic* ]] || fail "the installed program does not find its own modules:"
[[ $said != *material.lame* ]] || fail "the module is there before it was installed:"

said=$(ASHLAR_MODULES=$folder/lame/build/modules "$ashlar" list)
[[ $said == *material.lame* ]] || fail "ASHLAR_MODULES does not lead to the module:"

"$cmake" --install "$folder/lame/build" >/dev/null
said=$("$ashlar" list)
[[ $said == *material.lame* && $said == *material.elastic* ]] || fail "the installed module is not listed:"

# The library itself is opened: its law takes plane strain and refuses plane stress.
said=$("$ashlar" check "$folder/lame/scene.lua" 2>&1) || fail "a scene with the installed module does not pass:"
said=$("$ashlar" check "$folder/lame/scene.lua" --set plane=stress 2>&1) && fail "the module's law was not asked:"
[[ $said == *"this law is for plane strain"* ]] || fail "the module's own words are missing:"
