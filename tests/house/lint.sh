#!/usr/bin/env bash
# clang-tidy over every compiled .cpp; a file is skipped while it, its headers and the checks stay as they passed.
#   lint.sh ROOT BUILD [FILE…]
set -uo pipefail

root=$1
export build=$2
export stamps=$build/lint
shift 2
mkdir -p "$stamps"
cd "$root" || exit 2

# Any header may reach any file: one digest of all headers stands for each file's own.
common=$(find framework modules tests -name '*.hpp' -print0 | sort -z |
  xargs -0 cat .clang-tidy tests/.clang-tidy tests/house/lint.sh | sha256sum)
export common

lint_one() {
  local stamp said
  stamp=$stamps/$(tr '/' '_' <<<"$1")
  [[ $(cat "$stamp" 2>/dev/null) == "$(cat "$1" - <<<"$common" | sha256sum)" ]] && return 0
  # Without a precompiled header of the other compiler there is nothing to warn of.
  if said=$(clang-tidy -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option "$1" 2>&1); then
    cat "$1" - <<<"$common" | sha256sum >"$stamp"
  else
    grep -v 'warnings generated' <<<"$said"
    return 1
  fi
}
export -f lint_one

if (($#)); then
  printf '%s\n' "$@"
else
  sed -n 's|^ *"file": "\(.*\)",\{0,1\}$|\1|p' "$build/compile_commands.json" |
    sed -n "s|^$root/||p" | grep -v '^build' | sort -u
fi | xargs -d '\n' -r -n 1 -P "$(nproc)" bash -c 'lint_one "$1"' lint
