#!/usr/bin/env bash
# Every C++ file is as clang-format leaves it.
#   format.sh ROOT [--fix]
cd "$1" || exit 2
how=(--dry-run -Werror)
[[ ${2:-} == --fix ]] && how=(-i)
find . \( -path './build*' -o -path ./.git \) -prune -o \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
  xargs -0 -r -n 20 -P "$(nproc)" clang-format "${how[@]}" --style=file
