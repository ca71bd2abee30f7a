#!/usr/bin/env bash
# clang-tidy over every compiled .cpp; a file is skipped while it, its headers and the checks stay as they passed.
# Most of the time goes into headers, so files are read in batches, each as one text: a batch without a word has
# passed; the files of any other are looked at one by one.
#   lint.sh ROOT BUILD [FILE…]
set -uo pipefail

root=$1
export build=$2
export stamps=$build/lint
house=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
shift 2
mkdir -p "$stamps/batches/tests"
cd "$root" || exit 2

# Any header may reach any file: one digest of all headers stands for each file's own.
common=$(find framework modules tests -name '*.hpp' -print0 | sort -z |
  xargs -0 cat .clang-tidy tests/.clang-tidy tests/house/lint.sh | sha256sum)
export common

digest() { cat "$1" - <<<"$common" | sha256sum; }
stamp() { echo "$stamps/${1//\//_}"; }
# Without a precompiled header of the other compiler there is nothing to warn of.
tidy() { clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option "$@" 2>&1; }
passed() { digest "$1" >"$(stamp "$1")"; }

lint_one() {
  local said
  if said=$(tidy -p "$build" "$1"); then
    passed "$1"
  else
    grep -v 'warnings generated' <<<"$said"
    return 1
  fi
}

# idle_name FILE… : does one make a name known, by using or as a namespace, and never speak it again? In a batch
# another file may speak it.
idle_name() {
  local file name
  for file in "$@"; do
    for name in $(sed -nE 's/^ *using [A-Za-z_0-9:]*::([A-Za-z_0-9]+);.*/\1/p; s/^ *namespace ([a-z_0-9]+) =.*/\1/p' "$file"); do
      grep -vE '^ *(using|namespace|#include) ' "$file" | grep -qE "(^|[^:A-Za-z_0-9])$name([^A-Za-z_0-9]|\$)" || return 0
    done
  done
  return 1
}

# lint_batch BATCH FILE… : the text of all FILEs, and how to compile it, are in the folder of batches.
lint_batch() {
  local batch=$1 file bad=0
  shift
  if (($# > 1)) && ! idle_name "$@" && tidy -p "$stamps/batches" "$batch" >/dev/null; then
    for file in "$@"; do passed "$file"; done
  else
    for file in "$@"; do lint_one "$file" || bad=1; done
  fi
  return $bad
}
export -f digest stamp tidy passed lint_one idle_name lint_batch

changed() {
  local file
  while read -r file; do
    [[ $(cat "$(stamp "$file")" 2>/dev/null) == "$(digest "$file")" ]] || echo "$file"
  done
}

asked() {
  if (($#)); then
    printf '%s\n' "$@"
  else
    sed -n 's|^ *"file": "\(.*\)",\{0,1\}$|\1|p' "$build/compile_commands.json" |
      sed -n "s|^$root/||p" | grep -v '^build' | sort -u
  fi
}

# keyed : before each file "tests" or ".", whose checks apply, and a way to compile all such files, which has every
# include folder and definition that one of them asks for.
keyed() {
  awk -v root="$root/" '
    function add(under, word) {
      if (word ~ /_EXPORTS$/ || (under, word) in known) return
      known[under, word]
      flags[under] = flags[under] word " "
    }
    NR == FNR && /^ *"command": / { sub(/^ *"command": "/, ""); sub(/ -o [^ ]* -c .*/, ""); command = $0 }
    NR == FNR && /^ *"file": / {
      sub(/^ *"file": "/, ""); sub(/",?$/, ""); sub(root, "")
      under[$0] = /^tests\// ? "tests" : "."
      words = split(command, word, " ")
      for (i = 1; i <= words; ++i)
        add(under[$0], word[i] == "-isystem" ? word[i] " " word[++i] : word[i])
    }
    NR != FNR { print under[$0] " " flags[under[$0]] "\t" $0 }' "$build/compile_commands.json" -
}

# text_of FILE : with the headers of its own folder named in full.
text_of() {
  awk -v folder="$root/$(dirname "$1")/" '
    /^#include "/ {
      split($0, part, "\"")
      if ((getline line < (folder part[2])) >= 0) $0 = "#include \"" folder part[2] "\""
    }
    { print }' "$1"
}

# write_batches : their texts, how these are compiled, and "BATCH FILE…" to lint.
write_batches() {
  local number key file batch list=$stamps/batches/compile_commands.json comma=
  declare -A files=()
  echo '[' >"$list"
  while IFS=$'\t' read -r number key file; do
    batch=$stamps/batches/${key%% *}/$number.cpp
    if [[ ! ${files[$batch]-} ]]; then
      : >"$batch"
      echo "$comma{\"directory\": \"$build\", \"command\": \"${key#* } -c $batch\", \"file\": \"$batch\"}" >>"$list"
      comma=,
    fi
    files[$batch]+=" $file"
    text_of "$file" >>"$batch"
  done
  echo ']' >>"$list"
  for batch in "${!files[@]}"; do echo "$batch${files[$batch]}"; done
}

# Tests are checked for less: each batch finds the checks of its files beside or above it.
cp .clang-tidy "$stamps/batches/.clang-tidy"
cp tests/.clang-tidy "$stamps/batches/tests/.clang-tidy"
asked "$@" | changed | keyed | awk -v most=20 -f "$house/batches.awk" | write_batches |
  xargs -d '\n' -r -n 1 -P "$(nproc)" bash -c 'lint_batch $1' lint
