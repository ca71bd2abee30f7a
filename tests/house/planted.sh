#!/usr/bin/env bash
# Plants one breach of every house rule in a copy of the tree: each must be found, and the clean copy must pass.
#   planted.sh ROOT
set -uo pipefail

root=$(cd "$1" && pwd)
check=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/check.sh
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
failed=0

fresh_copy() {
  rm -rf "$copy/tree" && mkdir "$copy/tree" && cd "$copy/tree" || exit 2
  for entry in CMakeLists.txt framework modules scripts examples tests; do
    [[ -e $root/$entry ]] && cp -r "$root/$entry" .
  done
}

# expect RULE WORDS : the rule must fail and say these words.
expect() {
  local said
  if said=$(bash "$check" "$copy/tree" "$1"); then
    echo "$1 finds nothing where it must say: $2" && failed=1
  elif [[ $said != *"$2"* ]]; then
    echo "$1 says: $said" && echo "instead of: $2" && failed=1
  fi
}

# planted RULE WORDS FILE LINE : appends LINE to FILE (made if need be) of a fresh copy, then expects.
planted() {
  fresh_copy
  mkdir -p "$(dirname "$3")"
  printf '%s\n' "$4" >>"$3"
  expect "$1" "$2"
}

fresh_copy
bash "$check" "$copy/tree" >/dev/null || { echo "the clean copy does not pass" && failed=1; }

planted top_level 'the top level holds only' notes.txt 'a note'
planted folders_complete 'modules/ghost/README.md:1: is missing' modules/ghost/module.lua 'return {}'
planted folders_complete 'examples/ghost/expected.lua:1: is missing' examples/ghost/scene.lua 'return {}'
planted folders_complete 'is no layer' framework/ghost/ghost.hpp '#pragma once'
planted includes_point_down 'belongs to a later layer than core' framework/core/error.cpp '#include "mesh/mesh.hpp"'
planted includes_point_down 'is for tests only' framework/core/error.cpp '#include "testing/patch.hpp"'
planted includes_point_down 'is in no layer' framework/core/error.cpp '#include "elasticity/element.hpp"'
planted libraries_in_their_rooms 'Lua belongs' framework/core/error.cpp '#include <lua.hpp>'
planted libraries_in_their_rooms 'CGAL stays' framework/geometry/point.hpp '#include <CGAL/Gmpq.h>'
planted libraries_in_their_rooms 'gmsh belongs' framework/core/error.cpp '#include <gmsh.h>'
planted libraries_in_their_rooms 'HDF5 and Cairo belong' framework/core/error.cpp '#include <hdf5.h>'
planted file_lengths 'is longer than 500 lines' framework/core/error.cpp "$(yes '//' | head -n 501)"
planted headers_guarded 'has no #pragma once' framework/core/ghost.hpp 'int ghost();'
planted no_machine_paths 'a path of one machine' framework/core/error.cpp "// see /home""/someone/notes"
planted nothing_unfinished 'unfinished' framework/core/error.cpp "// TO""DO: later"

fresh_copy
mkdir -p modules/ghost
echo 'return { name = "ghost", provides = { { kind = "mesh", name = "phantom" } } }' >modules/ghost/module.lua
echo 'const char* word = "ghost";' >>framework/core/error.cpp
echo 'const char* other = "phantom";' >>framework/core/log.cpp
expect framework_names_no_module 'framework/core/error.cpp'
expect framework_names_no_module 'framework/core/log.cpp'

exit $failed
