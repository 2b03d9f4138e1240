#!/usr/bin/env bash
# ./do COMMAND - one entry for people. Works from any folder; installs what is missing on Debian and Ubuntu.
#
#   demo                what Sunder does, in five minutes: builds the program, decides about a robot arm, proves it
#   test [--quick]      build everything and run all tests (15 minutes; --quick: 1 minute); the rest goes to ctest
#   build [PRESET]      build everything: release (default), dev, clang, libcxx, asan-ubsan, tsan, coverage, bench
#   bench [OPTIONS]     run the benchmarks against other libraries; --check: the ratios that are promised
#   check [PART...]     lint (of what has changed since scripts/lint.base), sanitizers, fuzzers, the Python verifier
#                       (20 minutes); parts: format headers bench sanitize tidy fuzz verify
#   soak [PART...]      hours: parts: differential[=FROM-TO] structure claims tsan clang libcxx fuzz corpus coverage lint
#   docs                check the pages, and list them; the reference of all functions: build/docs/index.html
#   help                this text
#
# CXX chooses the compiler (else g++ 12 or newer, else clang++ 16 or newer). Logs are in build/log.
# Exit code 0: all went well. 1: something failed. 2: something is missing, or a wrong call.
set -euo pipefail
root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
cd "$root"
log_folder=build/log

say() { printf '%s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }
refuse() { printf '%s\n' "$*" >&2; exit 2; }  # something is missing, or a wrong call
wrong_call() { refuse "./do: $*; see ./do help"; }

# --- Running things -----------------------------------------------------------------------------------------------

# The lesser of cores and memory / 2 GiB.
job_count() {
  local cores kilobytes limit=
  cores=$(nproc 2>/dev/null || echo 1)
  kilobytes=$(awk '/^MemTotal:/ {print $2}' /proc/meminfo 2>/dev/null || true)
  if [ -r /sys/fs/cgroup/memory.max ]; then limit=$(cat /sys/fs/cgroup/memory.max); fi  # a container's
  case $limit in '' | max) ;; *) [ $((limit / 1024)) -lt "${kilobytes:-0}" ] && kilobytes=$((limit / 1024)) ;; esac
  local by_memory=$((${kilobytes:-2097152} / 2000000))  # what is sold as 2 GiB is a little less
  [ "$by_memory" -lt "$cores" ] && cores=$by_memory
  [ "$cores" -ge 1 ] || cores=1
  echo "$cores"
}

duration() { if [ "$1" -lt 100 ]; then echo "$1 s"; else echo "$((($1 + 30) / 60)) min"; fi; }

# run NAME WHAT COMMAND...: its output goes to the log NAME; a failure shows the log's end and gives the command's code.
run() {
  local log=$log_folder/$1.log what=$2 start=$SECONDS result=0
  shift 2
  mkdir -p "$log_folder"
  printf '%s ... ' "$what"
  "$@" >"$log" 2>&1 </dev/null || result=$?
  if [ "$result" -eq 0 ]; then
    say "done ($(duration $((SECONDS - start))))"
  else
    say "FAILED ($result)"
    tail -n 30 "$log"
    say "The whole output is in $root/$log"
  fi
  return "$result"
}

# --- Packages -----------------------------------------------------------------------------------------------------

version_of() { "$1" --version 2>/dev/null | head -n 1 | grep -oE '[0-9]+\.[0-9]+(\.[0-9]+)?' | head -n 1; }
at_least() { [ -n "$1" ] && [ "$(printf '%s\n%s\n' "$2" "$1" | sort -V | head -n 1)" = "$2" ]; }
has_command() { command -v "$1" >/dev/null 2>&1; }

has_header() {
  local folder
  IFS=: read -r -a folders <<<"/usr:/usr/local:${CMAKE_PREFIX_PATH:-}"
  for folder in "${folders[@]}"; do
    if [ -n "$folder" ] && [ -e "$folder/include/$1" ]; then return 0; fi
  done
  return 1
}

# Is what we need of this Debian package there, from wherever?
has_package() {
  case $1 in
    g++ | g++-[0-9]*) pick_compiler quietly ;;
    cmake) has_command cmake && at_least "$(version_of cmake)" 3.25 ;;
    ninja-build) has_command ninja ;;
    ccache) has_command ccache ;;
    libboost-dev) has_header boost/multiprecision/cpp_int.hpp ;;
    libcli11-dev) has_header CLI/CLI.hpp ;;
    libfmt-dev) has_header fmt/format.h ;;
    libtinyxml2-dev) has_header tinyxml2.h ;;
    libfast-float-dev) has_header fast_float/fast_float.h ;;
    zlib1g-dev) has_header zlib.h ;; nlohmann-json3-dev) has_header nlohmann/json.hpp ;;
    libgtest-dev) has_header gtest/gtest.h ;;
    librapidcheck-dev) has_header rapidcheck.h ;;
    libfcl-dev) has_header fcl/fcl.h ;;
    libccd-dev) has_header ccd/ccd.h ;;
    libeigen3-dev) has_header eigen3/Eigen/Core ;;
    libbullet-dev) has_header bullet/btBulletCollisionCommon.h ;;
    libqhull-dev) has_header libqhull_r/libqhull_r.h ;;
    libcgal-dev) has_header CGAL/Surface_sweep_2_algorithms.h ;;
    libgeos-dev) has_header geos_c.h ;;
    libgeos++-dev) has_header geos/noding/MCIndexNoder.h ;;
    libembree-dev) has_header embree4/rtcore.h || has_header embree3/rtcore.h ;;
    libppl-dev) has_header ppl.hh || compgen -G "/usr/include/*/ppl.hh" >/dev/null ;;
    libbenchmark-dev) has_header benchmark/benchmark.h ;;
    libtbb-dev) has_header tbb/version.h ;;
    libhwy-dev) has_header hwy/highway.h ;;
    libclang-rt-*-dev) compgen -G "/usr/lib/llvm-${1//[^0-9]/}/lib/clang/*/lib/*/libclang_rt.fuzzer*" >/dev/null ;;
    clang-[0-9]*) has_command "clang++-${1#clang-}" ;;
    pkg-config) has_command pkg-config ;;
    python3-venv) python3 -c 'import ensurepip, venv' 2>/dev/null ;;
    python3-dev) python3 -c 'import os, sysconfig; os.stat(sysconfig.get_path("include") + "/Python.h")' 2>/dev/null ;;
    python3 | gcovr | doxygen | clang-*) has_command "$1" ;;
    *) dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed' ;;
  esac
}

# The version that apt would install; empty where it knows none (a name that it does not know, it takes for a pattern).
candidate() {
  LC_ALL=C apt-cache policy "$1" 2>/dev/null |
    awk -v name="$1:" '/^[^ ]/ {here = $0 == name} here && /Candidate:/ && $2 != "(none)" {print $2}'
}

# Sets become_root: the words before a command that needs root. False where that cannot be.
can_become_root() {
  become_root=(env)
  [ "$(id -u)" -ne 0 ] || return 0
  become_root=(sudo env)
  has_command sudo && { sudo -n true 2>/dev/null || [ -t 0 ]; }
}

apt_update() {
  "${become_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 update
}
apt_install() {
  "${become_root[@]}" DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "$@"
}

# need PACKAGE...: installs those that are missing. Nothing missing: apt is not touched.
need() {
  local package missing=() unknown=() sizes
  for package in "$@"; do has_package "$package" || missing+=("$package"); done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "Missing: ${missing[*]}"
  if ! has_command apt-get; then
    refuse "This is not Debian or Ubuntu: install what these packages hold by your own means, then call again."
  fi
  for package in "${missing[@]}"; do [ -n "$(candidate "$package")" ] || unknown+=("$package"); done
  if ! can_become_root; then
    show_sizes "${missing[@]}"
    local line="sudo apt-get install -y --no-install-recommends ${missing[*]}"
    [ ${#unknown[@]} -eq 0 ] || line="sudo apt-get update && $line"
    say "Only root may install them. Run this line, then call again:"
    refuse "$line"
  fi
  if [ ${#unknown[@]} -gt 0 ]; then
    run apt-update "Fetching the list of packages" apt_update || exit 2
    for package in "${unknown[@]}"; do
      [ -n "$(candidate "$package")" ] || refuse "This system has no package $package (Debian 12 and Ubuntu 24.04 have)."
    done
  fi
  show_sizes "${missing[@]}"
  if ! run apt-install "Installing" apt_install "${missing[@]}"; then
    say "Trying once more with a fresh list of packages."
    run apt-update "Fetching the list of packages" apt_update || exit 2
    run apt-install "Installing" apt_install "${missing[@]}" || exit 2
  fi
  hash -r
  for package in "${missing[@]}"; do
    has_package "$package" || refuse "$package is installed, but what is needed of it is not there or too old."
  done
}

show_sizes() {
  LC_ALL=C apt-get -o Debug::NoLocking=1 install --no-install-recommends --assume-no "$@" 2>/dev/null </dev/null |
    grep -E '^[0-9]+ upgraded|^Need to get|^After this operation' | sed 's/^/  /' || true
}

# --- Compilers ----------------------------------------------------------------------------------------------------

# Sets CXX: the caller's, else g++ 12 or newer, else clang++ 16 or newer.
pick_compiler() {
  local name version found=
  if [ -n "${CXX:-}" ]; then
    has_command "${CXX%% *}" || refuse "CXX is '$CXX', but there is no such command."
    found=$CXX
  else
    for name in g++ g++-{15,14,13,12} clang++ clang++-{21,20,19,18,17,16}; do
      version=$("$name" -dumpversion 2>/dev/null) || continue
      case $name in g++*) at_least "$version" 12 || continue ;; *) at_least "$version" 16 || continue ;; esac
      found=$name
      break
    done
  fi
  [ -n "$found" ] || return 1
  [ "${1:-}" = quietly ] && return 0
  export CXX=$found
  say "Compiler: $CXX $($CXX -dumpfullversion 2>/dev/null || $CXX -dumpversion)"
}

# The package with a g++ that is new enough, where none is installed.
compiler_package() {
  local version
  version=$(candidate g++)
  version=${version#*:}
  if [ -z "$version" ] || at_least "$version" 12; then echo g++; else echo g++-12; fi
}

# Sets clang: the version of clang, clang-tidy and clang-format to use: the newest of 19 to 16 that is complete here,
# else the newest that can be had.
pick_clang() {
  local version
  for version in 19 18 17 16; do
    if has_command "clang++-$version" && has_command "clang-tidy-$version" && has_command "clang-format-$version"; then
      clang=$version
      return
    fi
  done
  for _ in 1 2; do
    for version in 19 18 17 16; do
      if has_command apt-cache && [ -n "$(candidate "clang-tidy-$version")" ]; then
        clang=$version
        return
      fi
    done
    if has_command apt-get && can_become_root; then
      run apt-update "Fetching the list of packages" apt_update || exit 2
    fi
  done
  refuse "There is no clang++, clang-tidy and clang-format of one version from 16 to 19. Run: apt-get update"
}

need_to_build_program() {
  need cmake ninja-build ccache "$(compiler_package)" libboost-dev libcli11-dev libfmt-dev libfast-float-dev nlohmann-json3-dev libtinyxml2-dev zlib1g-dev "$@"
}
need_to_test() {
  need_to_build_program libgtest-dev librapidcheck-dev libgeos-dev python3 python3-dev python3-venv "$@"
}
need_clang() {
  pick_clang
  need "clang-$clang" "clang-tidy-$clang" "clang-format-$clang" "libclang-rt-$clang-dev"
}
need_to_bench() {
  need_to_build_program pkg-config libfcl-dev libccd-dev libeigen3-dev libbullet-dev libqhull-dev libbenchmark-dev \
    libcgal-dev libembree-dev libgeos-dev libgeos++-dev libppl-dev python3
}

# --- Building -----------------------------------------------------------------------------------------------------

build_folder() { if [ "$1" = release ]; then echo build; else echo "build/$1"; fi; }

# configure PRESET COMPILER [OPTION...]. Another compiler than last time: from scratch.
configure() {
  local preset=$1 compiler=$2 cache fresh=() old
  shift 2
  cache=$(build_folder "$preset")/CMakeCache.txt
  if [ -f "$cache" ]; then
    old=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$cache")
    [ "$(readlink -f "$old")" = "$(readlink -f "$(command -v "${compiler##* }")")" ] || fresh=(--fresh)
  fi
  CXX=$compiler run "configure-$preset" "Configuring $(build_folder "$preset")" \
    cmake --preset "$preset" "${fresh[@]}" "$@"
}

# build PRESET [TARGET...]
build() {
  local preset=$1 folder
  shift
  folder=$(build_folder "$preset")
  run "build-$preset" "Building $folder with $(job_count) jobs (to watch: tail -f $root/$log_folder/build-$preset.log)" \
    cmake --build "$folder" --parallel "$(job_count)" --target "${@:-all}"
}

# run_tests PRESET LOG [CTEST OPTION...]: shows everything, and keeps it as a log.
run_tests() {
  local folder log=$log_folder/$2.log
  folder=$(build_folder "$1")
  shift 2
  CMAKE_BUILD_PARALLEL_LEVEL=$(job_count) \
    ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(job_count)" "$@" </dev/null 2>&1 | tee "$log"
}

# --- Commands -----------------------------------------------------------------------------------------------------

run_demo() { bash examples/demo.sh "$root/build/bin/sunder"; }

command_demo() {
  [ $# -eq 0 ] || wrong_call "demo takes no options"
  need_to_build_program python3
  pick_compiler
  local tests=OFF  # but a folder in which everything is built stays so
  if grep -qs '^SUNDER_TESTS:BOOL=ON' build/CMakeCache.txt && [ -f build/build.ninja ]; then tests=ON; fi
  configure release "$CXX" -DSUNDER_TESTS=$tests || return 1
  build release sunder_cli || return 1
  say
  run_demo
}

command_test() {
  local options=() quick=
  while [ $# -gt 0 ]; do
    case $1 in
      --quick) quick=1 ;;
      *) options+=("$1") ;;
    esac
    shift
  done
  need_to_test
  pick_compiler
  configure release "$CXX" -DSUNDER_TESTS=ON -DSUNDER_WARNINGS_AS_ERRORS="${SUNDER_WARNINGS_AS_ERRORS:-OFF}" || return 1
  build release || return 1
  if [ -n "$quick" ]; then
    export SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-0.05}
    options+=(--label-exclude '^slow$')
  fi
  run_tests release test "${options[@]}"
}

command_build() {
  local preset=${1:-release} compiler
  [ $# -le 1 ] || wrong_call "build takes one preset"
  grep -q "\"configurePreset\": \"$preset\"" CMakePresets.json || wrong_call "there is no preset '$preset'"
  case $preset in
    bench) need_to_bench ;;
    *) need_to_test ;;
  esac
  case $preset in
    clang | asan-ubsan) need_clang; compiler=clang++-$clang; say "Compiler: $compiler" ;;
    libcxx)
      need_clang
      need "libc++-$clang-dev" "libc++abi-$clang-dev"
      compiler=clang++-$clang; say "Compiler: $compiler" ;;
    *) pick_compiler; compiler=$CXX ;;
  esac
  if [ "$preset" = release ]; then set -- -DSUNDER_TESTS=ON; else set --; fi
  configure "$preset" "$compiler" "$@" && build "$preset"
}

command_bench() {
  local program result=0 found=
  need_to_bench
  pick_compiler
  configure bench "$CXX" || return 1
  build bench || return 1
  for program in build/bench/bin/bench_*; do
    [ -x "$program" ] || continue
    found=1
    say
    "$program" --commit "$(git rev-parse --short HEAD 2>/dev/null || echo unknown)" \
      --json "$log_folder/$(basename "$program").json" "$@" </dev/null || result=1
  done
  [ -n "$found" ] || fail "There is no benchmark in build/bench/bin."
  say
  say "As JSON: $root/$log_folder/bench_*.json"
  return "$result"
}

# The parts run one after the other, also after a failure; the last line says which failed.
run_parts() {
  local part failed=() start=$SECONDS
  for part in "$@"; do
    say "== $part"
    "part_${part%%=*}" "${part#*=}" || failed+=("$part")
  done
  if [ ${#failed[@]} -gt 0 ]; then
    say "FAILED: ${failed[*]} ($(duration $((SECONDS - start))))"
    return 1
  fi
  say "All passed: $* ($(duration $((SECONDS - start))))"
}

command_check() {
  local part
  [ $# -gt 0 ] || set -- format headers bench sanitize tidy fuzz verify
  for part in "$@"; do
    case $part in format | headers | bench | tidy | sanitize | fuzz | verify) ;; *) wrong_call "check has no part '$part'" ;; esac
  done
  need_to_test
  need_clang
  pick_compiler
  run_parts "$@"
}

sources() { find "$@" \( -name '*.h' -o -name '*.cpp' \) -print0 2>/dev/null | sort -z; }

part_format() {
  if [ "$clang" != 19 ]; then
    say "Skipped: clang-format $clang sees some lines differently from 19, which is the rule."
    return 0
  fi
  check_format() {
    sources sunder cli python verifier tests fuzz bench examples |
      xargs -0 -n 64 -P "$(job_count)" "clang-format-$clang" --dry-run -Werror
  }
  run format "clang-format-$clang (to mend: ./do format)" check_format
}

command_format() {
  need_clang
  [ "$clang" = 19 ] || refuse "clang-format-19 is the rule; here is $clang."
  sources sunder cli python verifier tests fuzz bench examples | xargs -0 "clang-format-$clang" -i
}

# Of the library's headers those changed since the commit of scripts/lint.base, and those that include them, or all.
part_headers() {
  local header objects changed includers targets
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  if ! knows_lint_base; then
    run headers "Every header stands alone" build_headers all_verify_interface_header_sets
    return
  fi
  changed=$(changed_since_lint_base sunder | grep -E '\.h$' || true)
  includers=$(for header in $changed; do grep -rlF --include='*.h' "<$header>" sunder || true; done)
  targets=$(ninja -C build -t targets all)
  mapfile -t objects < <(for header in $(printf '%s\n' $changed $includers | sort -u); do
    sed -n "s|^\([^ ]*verify_interface_header_sets/$header\.cxx\.o\): .*|\1|p" <<<"$targets"  # tests' own: none
  done)
  if [ ${#objects[@]} -eq 0 ]; then
    say "No header has changed since $(cat scripts/lint.base)."
    return 0
  fi
  run headers "${#objects[@]} headers stand alone" build_headers "${objects[@]}"
}
build_headers() { cmake --build build --parallel "$(job_count)" --target "$@"; }

# The compiler reads the benchmarks' own sources, where these or what they include have changed since the commit of
# scripts/lint.base. Only ./do bench builds them: the libraries that they are measured against are not installed for a
# check.
part_bench() {
  local files
  if knows_lint_base && [ -z "$(changed_since_lint_base bench tests/support sunder | grep -vE '_test\.(h|cpp)$')" ]; then
    say "Nothing that benchmarks are made of has changed since $(cat scripts/lint.base)."
    return 0
  fi
  mapfile -t files < <(grep -LE '#include <(libqhull_r/|ppl\.hh)' \
    bench/*.cpp bench/{contest,inputs}/*.cpp bench/peers/sunder_*.cpp)
  check_bench() {
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(job_count)" "clang++-$clang" -std=c++20 -fsyntax-only -Wall -Wextra -I. \
      -DSUNDER_BENCH_ARM='""' -DSUNDER_BENCH_MAP='""' -DSUNDER_BENCH_FLAGS='""'
  }
  run bench "The compiler reads ${#files[@]} sources of benchmarks" check_bench "${files[@]}"
}

knows_lint_base() { git cat-file -e "$(cat scripts/lint.base)^{commit}" 2>/dev/null; }
changed_since_lint_base() {  # and not moved alone, nor differs in comments and #include lines alone
  git diff --numstat -z -M -l10000 --diff-filter=d --ignore-blank-lines -I'^#include' -I'^ *//' "$(cat scripts/lint.base)" \
    -- "$@" | tr '\0' '\n' |
    awk -F'\t' 'NF == 3 { n = $1 + $2; if ($3 != "" && n) print $3 } NF == 1 && ++names % 2 == 0 && n'
  git ls-files --others --exclude-standard -- "$@"
}

# lint_files NAME...: clang-tidy on these sources.
lint_files() {
  configure lint "clang++-$clang" || return 1
  run precompile "The headers that sources are compiled with" \
    cmake --build build/lint --target CMakeFiles/sunder_{core,io,ask,picture,verifier}.dir/cmake_pch.hxx.pch || return 1
  check_tidy() { printf '%s\0' "$@" | xargs -0 -n 1 -P "$(job_count)" "clang-tidy-$clang" -p build/lint --quiet; }
  run tidy "clang-tidy-$clang on $# files" check_tidy "$@"
}

all_to_lint() { find sunder cli verifier -name '*.cpp' ! -name '*_test.cpp' | sort; }

# What has changed since the commit of scripts/lint.base, at which all was linted; of a header, the source beside it or
# else the first that includes it. All, where git does not know that commit.
changed_to_lint() {
  local file beside
  knows_lint_base || { all_to_lint; return; }
  changed_since_lint_base sunder cli verifier | grep -E '\.(h|cpp)$' | grep -vE '_test\.(h|cpp)$' | while read -r file; do
    beside=${file%.*}.cpp
    [ -f "$beside" ] || beside=$(grep -rlF --include='*.cpp' --exclude='*_test.cpp' "${file##*/}>" sunder cli verifier | sort | head -n 1 || true)
    [ -z "$beside" ] || echo "$beside"
  done | sort -u
}

part_tidy() {
  local files
  mapfile -t files < <(changed_to_lint)
  if [ ${#files[@]} -eq 0 ]; then
    say "Nothing to lint has changed since $(cat scripts/lint.base)."
    return 0
  fi
  lint_files "${files[@]}"
}

part_lint() {
  local files
  mapfile -t files < <(all_to_lint)
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  run headers "Every header stands alone" build_headers all_verify_interface_header_sets || return 1
  lint_files "${files[@]}" && say "All is linted: git rev-parse HEAD may go into scripts/lint.base"
}

part_sanitize() {
  { configure asan-ubsan "clang++-$clang" && build asan-ubsan; } || return 1
  # Counts of probes are the same there: left out. Smaller fake stacks, shorter allocation stacks: calls begin sooner.
  SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-0.02} GTEST_FILTER='-*Complexity*:*Grow*As*' UBSAN_OPTIONS=print_stacktrace=1 \
    ASAN_OPTIONS=max_uar_stack_size_log=16:malloc_context_size=4 run_tests asan-ubsan sanitize \
    --label-regex '^(unit|tests|example)$' --label-exclude '^slow$'
}

# fuzz_one PROGRAM OPTION... FOLDER...: with the options that are its own, and those that all have.
fuzz_one() {
  local program=$1 name own=()
  name=$(basename "$program")
  if [ -f "fuzz/$name.options" ]; then mapfile -t own < <(grep -vE '^[[:space:]]*(#|$)' "fuzz/$name.options"); fi
  UBSAN_OPTIONS=print_stacktrace=1 "$program" -timeout=20 -rss_limit_mb=2048 -max_len=8192 "${own[@]}" "${@:2}"
}

# Two at a time; all begin with the cases, and with what longer runs have found (cases/fuzz). What a run finds new is in
# build/fuzz/corpus, what fails in build/fuzz/failures.
part_fuzz() {
  local seconds=${SUNDER_FUZZ_SECONDS:-12} programs=() program result=0 first
  configure asan-ubsan "clang++-$clang" || return 1
  build asan-ubsan fuzzers || return 1
  rm -rf build/fuzz/kept
  mkdir -p build/fuzz/kept build/fuzz/failures
  tar -xzf cases/fuzz/corpus.tar.gz -C build/fuzz/kept || return 1
  for program in build/asan-ubsan/fuzz/*_fuzz; do [ ! -x "$program" ] || programs+=("$program"); done
  if [ ${#programs[@]} -eq 0 ]; then
    say "There is no fuzzer."
    return 1
  fi
  for ((first = 0; first < ${#programs[@]}; first += 2)); do
    local pids=() names=()
    for program in "${programs[@]:first:2}"; do
      names+=("$(basename "$program")")
      mkdir -p "build/fuzz/corpus/${names[-1]}" "build/fuzz/kept/${names[-1]}"
      fuzz_one "$program" -max_total_time="$seconds" -artifact_prefix="build/fuzz/failures/${names[-1]}-" \
        -print_final_stats=1 build/fuzz/{corpus,kept}/"${names[-1]}" cases >"$log_folder/${names[-1]}.log" 2>&1 </dev/null &
      pids+=($!)
    done
    local i status
    for i in "${!pids[@]}"; do
      status=0
      wait "${pids[i]}" || status=$?
      if [ "$status" -eq 0 ]; then
        say "${names[i]}: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log_folder/${names[i]}.log") runs"
      else
        result=1
        say "${names[i]}: FAILED ($status)"
        tail -n 30 "$log_folder/${names[i]}.log"
        say "The whole output is in $root/$log_folder/${names[i]}.log, the input in $root/build/fuzz/failures"
      fi
    done
  done
  return "$result"
}

# certificates FOLDER BUILD COUNT: as files.
certificates() {
  rm -rf "$1"
  mkdir -p "$1"
  "$2/tools/certificate_sample" "$1" "$3" "${SUNDER_TEST_SEED:-1}" &&
    "$2/tools/round_certificate_sample" "$1" "$3" "${SUNDER_TEST_SEED:-1}" &&
    "$2/tools/polytope_certificate_sample" "$1" "$(($3 / 4))" "${SUNDER_TEST_SEED:-1}" &&
    "$2/tools/planar_certificate_sample" "$1" "$3" "${SUNDER_TEST_SEED:-1}" &&
    "$2/tools/segments_certificate_sample" "$1" "$3" "${SUNDER_TEST_SEED:-1}" &&
    "$2/tools/sets_certificate_sample" "$1" "$3" "${SUNDER_TEST_SEED:-1}"
}

# The Python verifier on a sample of certificates.
part_verify() {
  local folder=build/certificates count=${SUNDER_SAMPLE:-2000}
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  build release certificate_sample round_certificate_sample planar_certificate_sample segments_certificate_sample \
    polytope_certificate_sample sets_certificate_sample || return 1
  verify_sample() {
    certificates "$folder" build "$count" || return 1
    local accepted
    find "$folder" -name '*.json' -print0 | sort -z | xargs -0 -n 250 -P "$(job_count)" \
      sh -c 'python3 verifier/python/sunder_verify "$@" >"$0/verdicts.$$"' "$folder" ||
      { grep -hvE ': accepted(: |$)' "$folder"/verdicts.*; return 1; }
    accepted=$(cat "$folder"/verdicts.* | grep -cE ': statement [0-9]+: accepted: ' || true)
    echo "$accepted certificates accepted"
    [ "$accepted" -ge $((4 * count + count / 4)) ]  # a sample that reads empty fails
  }
  run verify "The Python verifier on $((2 * count)) certificates of bodies, $((count / 4)) of polytopes, $count of polygons and $((2 * count)) of sets" verify_sample
}

. scripts/soak.sh  # command_soak

command_docs() {
  local page result=0
  need python3 doxygen
  python3 tests/check_links.py || result=1
  python3 tests/check_papers_table.py || result=1
  python3 tests/check_contracts.py || result=1
  rm -rf build/docs && mkdir -p build/docs
  run docs "Doxygen $(doxygen --version)" doxygen scripts/Doxyfile && python3 scripts/api_pages.py || result=1
  say "The reference: $root/build/docs/index.html"
  say
  find . -name '*.md' -not -path './build/*' -not -path './.git/*' -not -path './cases/*' | sort | while read -r page; do
    printf '%-40s %s\n' "${page#./}" "$(sed -n 's/^# *//p' "$page" | head -n 1)"
  done
  return "$result"
}

command_help() { sed -n '2,/^set -euo/ s/^# \{0,1\}//p' "$root/do"; }

case ${1:-help} in
  demo | test | build | bench | check | soak | docs | format) "command_$1" "${@:2}" ;;
  help | -h | --help) command_help ;;
  *) wrong_call "there is no command '$1'" ;;
esac
