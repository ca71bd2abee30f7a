#!/usr/bin/env bash
# The house rules that a machine can hold: prints every breach as "file:line: what is wrong" and fails if any.
#   check.sh ROOT [RULE…]
set -uo pipefail

cd "$1" || exit 2
shift
rules=("${@:-}")
layers="core geometry mesh fields algebra model solve output script study app"

# files FOLDER… -- ENDING… : our files, without what builds and runs leave behind.
files() {
  local folders=() ending=()
  while [[ $1 != -- ]]; do
    [[ -e $1 ]] && folders+=("$1")
    shift
  done
  shift
  for word in "$@"; do ending+=(-o -name "$word"); done
  ((${#folders[@]})) || return 0
  find "${folders[@]}" \( -path './build*' -o -path ./.git -o -name results \) -prune -o \
    -type f \( "${ending[@]:1}" \) -print | sed 's|^\./||' | sort
}

# search PATTERN < list of files : grep that names file and line, quiet when nothing matches.
search() { xargs -r -d '\n' grep -HnE "$1" || true; }

top_level() {
  local entry
  for entry in *; do
    case $entry in
      CMakeLists.txt | framework | modules | scripts | examples | tests | README.md | LICENSE* | NOTICE) ;;
      build* | results | compile_commands.json | *.h5) ;;
      *) echo "$entry:1: the top level holds only CMakeLists.txt framework modules scripts examples tests README.md" ;;
    esac
  done
}

folders_complete() {
  local folder file
  for folder in framework/*/; do
    [[ " $layers testing cmake " == *" $(basename "$folder") "* ]] || echo "$folder:1: is no layer of the framework"
  done
  for folder in modules/*/; do
    for file in CMakeLists.txt README.md module.lua; do
      [[ -f $folder$file ]] || echo "$folder$file:1: is missing: a module has code, README and schema"
    done
  done
  for folder in examples/*/; do
    for file in scene.lua README.md expected.lua; do
      [[ -f $folder$file ]] || echo "$folder$file:1: is missing: an example has scene, README and expected numbers"
    done
  done
}

includes_point_down() {
  files framework -- '*.cpp' '*.hpp' | xargs -r -d '\n' awk -v layers="$layers" '
    BEGIN { count = split(layers, names, " "); for (i = 1; i <= count; i++) rank[names[i]] = i }
    match($0, /^[ \t]*#[ \t]*include[ \t]*"[^"]+"/) {
      split($0, quoted, "\""); split(quoted[2], target, "/"); split(FILENAME, own, "/")
      from = own[2]; to = target[1]
      if (to != "testing" && !(to in rank)) wrong = "is in no layer of the framework"
      else if (from == "testing") wrong = ""
      else if (to == "testing") wrong = "is for tests only"
      else wrong = rank[to] > rank[from] ? "belongs to a later layer than " from : ""
      if (wrong) print FILENAME ":" FNR ": includes \"" quoted[2] "\", which " wrong
    }'
}

libraries_in_their_rooms() {
  files framework modules -- '*.cpp' '*.hpp' | search '#include *[<"](lua|lauxlib|lualib)\.(h|hpp)' |
    grep -v '^framework/script/' | sed 's/$/ : Lua belongs to framework\/script/'
  files framework -- '*.hpp' | search '#include *<CGAL/' | sed 's/$/ : CGAL stays in .cpp files/'
  files framework -- '*.cpp' '*.hpp' | search '#include *<gmsh\.h' | sed 's/$/ : gmsh belongs to its module/'
  files framework modules -- '*.cpp' '*.hpp' | search '#include *<(hdf5|cairo)' |
    grep -v '^framework/output/' | sed 's/$/ : HDF5 and Cairo belong to framework\/output/'
}

# Words that a module provides, as whole string literals in the framework. Ordinary words are not held against it,
# nor are the names of fields, by which modules and output speak with each other.
framework_names_no_module() {
  local ordinary=" none file penalty points free loads shear linear " words
  words=$({
    for folder in modules/*/; do [[ -d $folder ]] && basename "$folder"; done
    files modules -- module.lua | xargs -r -d '\n' grep -hv 'kind = "field"' |
      grep -oE '\bname *= *"[^"]+"' | cut -d'"' -f2
  } | sort -u | while read -r word; do [[ $ordinary == *" $word "* ]] || echo "$word"; done | paste -sd'|')
  [[ -n $words ]] || return 0
  files framework -- '*.cpp' '*.hpp' | grep -v '^framework/testing/' | xargs -r -d '\n' awk -v words="$words" '
    { line = $0; sub(/\/\/.*/, "", line) }
    match(line, "\"(" words ")\"") {
      print FILENAME ":" FNR ": the framework names " substr(line, RSTART, RLENGTH) ", which a module provides"
    }'
}

file_lengths() {
  files framework modules scripts examples tests -- '*.cpp' '*.hpp' '*.lua' '*.sh' '*.cmake' CMakeLists.txt |
    xargs -r -d '\n' awk 'FNR == 501 { print FILENAME ":501: is longer than 500 lines" }'
}

headers_guarded() {
  files framework modules tests -- '*.hpp' | xargs -r -d '\n' grep -L '^#pragma once' |
    sed 's/$/:1: has no #pragma once/'
}

no_machine_paths() {
  files . -- '*.cpp' '*.hpp' '*.lua' '*.sh' '*.cmake' '*.md' '*.txt' '*.in' '*.inp' run |
    search '(^|[^A-Za-z0-9_.})*])/(home|root|work|mnt|opt|Users)/[A-Za-z]' | sed 's/$/ : a path of one machine/'
}

nothing_unfinished() {
  files . -- '*.cpp' '*.hpp' '*.lua' '*.sh' '*.cmake' '*.md' CMakeLists.txt |
    search '\b(TOD[O]|FIXM[E]|XX[X])\b' | sed 's/$/ : unfinished/'
}

[[ -n ${rules[0]} ]] || rules=(top_level folders_complete includes_point_down libraries_in_their_rooms
  framework_names_no_module file_lengths headers_guarded no_machine_paths nothing_unfinished)
shopt -s nullglob
breaches=$(for rule in "${rules[@]}"; do "$rule"; done)
[[ -z $breaches ]] && exit 0
printf '%s\n' "$breaches"
exit 1
