#!/usr/bin/env bash
# Plants faults in a small tree that is linted in batches: each must be found, and the clean tree must pass.
#   lint_planted.sh ROOT
set -uo pipefail

root=$(cd "$1" && pwd)
lint=$root/tests/house/lint.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0
mkdir -p "$tree"/{framework,modules,tests/house,build}
cp "$root/.clang-tidy" "$tree"
cp "$root/tests/.clang-tidy" "$tree/tests"
cp "$lint" "$tree/tests/house"

printf '#pragma once\nnamespace far {\nint up();\n}\n' >"$tree/tests/far.hpp"
# One and two can share a batch; three names something that one keeps to itself.
for file in framework/one framework/two framework/three tests/one tests/two; do
  name=of_${file//\//_}
  local=local_$name
  [[ $file == */three ]] && local=local_of_framework_one
  printf '%s\n' '#include "far.hpp"' '' '' 'using far::up;' 'namespace {' "int $local() { return up(); }" \
    '}  // namespace' "int $name() { return $local(); }" >"$tree/$file.cpp"
  printf '{\n  "directory": "%s",\n  "command": "c++ -std=c++20 -Wall -I%s -o %s.o -c %s",\n  "file": "%s"\n},\n' \
    "$tree/build" "$tree/tests" "$name" "$tree/$file.cpp" "$tree/$file.cpp"
done | sed '1s/^/[\n/; $s/,$/\n]/' >"$tree/build/compile_commands.json"

# expect WORDS : lint must fail and say these words, or pass in silence if there are none.
expect() {
  local said passed=passed
  said=$(bash "$lint" "$tree" "$tree/build") || passed=failed
  if [[ $1 ]]; then
    [[ $passed == failed && $said == *"$1"* ]] && return
  else
    [[ $passed == passed && ! $said ]] && return
  fi
  printf 'lint %s and says: %s\ninstead of: %s\n' "$passed" "$said" "${1:-nothing}"
  failed=1
}

# planted WORDS FILE EDIT : FILE as sed's EDIT leaves it must be found, alone after all others have passed and in
# a batch with them.
planted() {
  cp "$tree/$2" "$tree/kept"
  sed -i "$3" "$tree/$2"
  expect "$1"
  rm -r "$tree/build/lint"
  expect "$1"
  cp "$tree/kept" "$tree/$2"
}

expect ''
for file in framework/one framework/two framework/three tests/one tests/two; do
  planted "$file.cpp:9:5: error: invalid case style for function 'BadName'" $file.cpp '$aint BadName() { return 0; }'
  planted "$file.cpp:4:12: error: using decl 'up' is unused" $file.cpp 's/return up/return far::up/'
done
planted 'bugprone-suspicious-semicolon' framework/two.cpp '$avoid wait(int n) {\n  while (n > 1);\n  { --n; }\n}'
printf '#pragma once\ninline int WorseName() { return 0; }\n' >"$tree/framework/fault.hpp"
planted "fault.hpp:2:12: error: invalid case style for function 'WorseName'" framework/one.cpp '1i#include "fault.hpp"'
rm "$tree/framework/fault.hpp"

expect ''
exit $failed
