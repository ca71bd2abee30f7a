#!/usr/bin/env bash
# The scenario that README.md shows is one that the program takes.
#   readme.sh ROOT BUILD
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed -n '/^```lua$/,/^```$/p' "$1/README.md" | sed '/^```/d' >"$folder/scene.lua"
grep -q '^return Scene' "$folder/scene.lua"
"$2/ashlar" check "$folder/scene.lua"
