#!/usr/bin/env bash
# Sets Ashlar up on Debian 12 and then does what it is asked. Each step is skipped when it is done already.
#
#   bash scripts/setup.sh                      install the packages, build the program
#   bash scripts/setup.sh run SCENE [ARG…]     … and run a scene, e.g. examples/jointed_dam
#   bash scripts/setup.sh test                 … and build and run every test and check
#   bash scripts/setup.sh benchmark [ARG…]     … and build and run the benchmarks
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
sanitized=$root/build-sanitize
log=$build/setup.log

# What the program itself is built from; fonts-dejavu-core is what its pictures are lettered with.
program_packages=(
  g++ cmake ninja-build pkg-config
  libeigen3-dev liblua5.4-dev nlohmann-json3-dev libpugixml-dev zlib1g-dev
  libcgal-dev libgmp-dev libmpfr-dev libgmsh-dev
  libsuitesparse-dev libopenblas-dev libmetis-dev
  libhdf5-dev libcairo2-dev libpng-dev fonts-dejavu-core
)
# What only the tests need: VTK reads our files back, CalculiX computes the same scenes independently, and
# clang-tidy wants an omp.h of its own for sources compiled with OpenMP.
test_packages=(libgtest-dev libbenchmark-dev libvtk9-dev calculix-ccx clang-format clang-tidy libomp-dev)

say() { printf '\n== %s\n' "$*"; }
fail() {
  printf '\nsetup.sh: %s\n' "$*" >&2
  exit 1
}

# timed "what is done" command… : its output goes to the log and is shown only if it fails.
timed() {
  say "$1"
  local from=$SECONDS
  shift
  if ! "$@" >>"$log" 2>&1; then
    tail -n 40 "$log" >&2
    fail "that failed; the whole output is in $log"
  fi
  echo "   done in $((SECONDS - from)) s"
}

missing_packages() {
  local package
  for package in "$@"; do
    [[ $installed == *" $package "* ]] || echo "$package"
  done
}

as_root() {
  if [[ $(id -u) == 0 ]]; then "$@"; else sudo "$@"; fi
}

apt() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Dpkg::Use-Pty=0 "$@"; }

apt_install() {
  if compgen -G '/var/lib/apt/lists/*Packages*' >/dev/null; then
    apt install --no-install-recommends "$@" && return
  fi
  # Lists that are absent or out of date name packages that cannot be fetched: renew them and try again.
  apt update && apt install --no-install-recommends "$@"
}

install_packages() {
  command -v dpkg-query >/dev/null || fail "this is no Debian system; install what these Debian packages hold: $*"
  local installed missing
  # dpkg-query fails when it has never heard of one of them; what it says of the others stands.
  installed=" $({ dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true; } |
    awk '$1 == "installed" { print $2 }' | tr '\n' ' ') "
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  [[ $(id -u) == 0 ]] || command -v sudo >/dev/null ||
    fail "these packages are missing, and only root or sudo can install them: ${missing[*]}"
  timed "Installing ${#missing[@]} Debian packages (some minutes, once): ${missing[*]}" apt_install "${missing[@]}"
}

# configure FOLDER OPTION=VALUE… : does nothing when the folder is configured so already.
configure() {
  local folder=$1 option wanted=()
  shift
  for option in "$@"; do
    grep -qs "^${option%%=*}:[A-Z]*=${option#*=}\$" "$folder/CMakeCache.txt" || wanted+=("-D$option")
  done
  [[ -f $folder/build.ninja ]] && ((${#wanted[@]} == 0)) && return 0
  timed "Configuring $(basename "$folder")" cmake -S "$root" -B "$folder" -G Ninja "${wanted[@]}"
}

# compile FOLDER TARGET WHAT : progress in tenths, everything that is no progress as it comes, and not a word
# when there is nothing to do.
compile() {
  local from=$SECONDS
  ninja -C "$1" "$2" 2>&1 | awk -v what="$3" '
    /^ninja: (Entering|no work)/ || /Re-checking globbed/ { next }
    !begun++ { print "\n== Building " what; fflush() }
    /^\[[0-9]+\/[0-9]+\] / {
      split(substr($1, 2), n, "/"); tenth = int(10 * n[1] / n[2])
      if (tenth > told) { print "   " 10 * tenth " %"; fflush(); told = tenth }
      next
    }
    { print; fflush() }' || return 1
  ((SECONDS - from < 3)) || echo "   done in $((SECONDS - from)) s"
}

build_program() {
  install_packages "${program_packages[@]}"
  # A folder that is configured with the tests stays so.
  [[ -f $build/build.ninja ]] || configure "$build" ASHLAR_TESTS=OFF
  compile "$build" program "the program and its modules (some minutes, once)" || fail "the build failed"
}

build_tests() {
  install_packages "${program_packages[@]}" "${test_packages[@]}"
  configure "$build" ASHLAR_TESTS=ON
  compile "$build" all "the program, its modules and the tests (some minutes, once)" || fail "the build failed"
}

# Sources that are compiled as one may clash in a name that the batches did not see: then each on its own.
compile_sanitized() {
  local what="the unit tests with address and undefined-behaviour sanitizers (some minutes, once)"
  compile "$sanitized" unit_tests "$what" && return
  configure "$sanitized" ASHLAR_BATCHES=OFF
  compile "$sanitized" unit_tests "$what" || fail "the build failed"
}

run_tests() {
  build_tests
  configure "$sanitized" ASHLAR_TESTS=ON ASHLAR_SANITIZE=ON
  compile_sanitized
  say "Running unit tests (plain and sanitized), example tests, format, lint and layer checks"
  ASHLAR_SANITIZED_BUILD=$sanitized ctest --test-dir "$build" --parallel "$(nproc)" --output-on-failure
}

mkdir -p "$build"
case ${1:-build} in
  build)
    build_program
    say "build/ashlar is ready: bash scripts/setup.sh run examples/jointed_dam"
    ;;
  run)
    (($# > 1)) || fail "run what? Name a scene, for instance: bash scripts/setup.sh run examples/jointed_dam"
    build_program
    exec "$build/ashlar" "$@"
    ;;
  test) run_tests ;;
  benchmark)
    build_tests
    exec bash "$root/tests/benchmarks/run.sh" "$build" "${@:2}"
    ;;
  *)
    sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    [[ $1 == --help ]] || exit 2
    ;;
esac
