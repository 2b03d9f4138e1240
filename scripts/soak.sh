# The parts of ./do soak, which reads this file: hours of tests, with what ./do has to run them.
command_soak() {
  local part
  [ $# -gt 0 ] || set -- clang libcxx tsan coverage fuzz lint claims structure differential
  for part in "$@"; do
    case $part in
      differential | differential=[0-9]*-[0-9]* | structure | claims | tsan | clang | libcxx | fuzz | corpus | coverage | lint) ;;
      *) wrong_call "soak has no part '$part'" ;;
    esac
  done
  need_to_test
  need_clang
  case " $* " in *" coverage "*) need gcovr ;; esac
  pick_compiler
  SUNDER_FUZZ_SECONDS=${SUNDER_FUZZ_SECONDS:-600} run_parts "$@"
}

# 20 slices of 25 times the usual number of instances, each with seeds of its own: 10 million of what has 20,000.
part_differential() {
  local from=1 to=20 slice source name result=0
  case $1 in *-*) from=${1%-*} to=${1#*-} ;; esac
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  build release || return 1
  for ((slice = from; slice <= to; ++slice)); do
    for source in tests/*/*_differential_test.cpp; do
      name=$(basename "$source" .cpp)
      SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-25} SUNDER_TEST_SEED=$slice run "soak-$name-$slice" "$name, slice $slice" \
        "build/tests/$(basename "$(dirname "$source")")_fast" "--file=$name" || result=1
    done
  done
  return "$result"
}

# Hierarchies of bodies of up to a million vertices, and their probes with as many pairs of each size.
part_structure() {
  local result=0
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  build release sunder_unit_solid solid_fast || return 1
  SUNDER_TEST_SCALE=25 run soak-structure "Hierarchies of a million vertices" build/tests/sunder_unit_solid \
    --gtest_filter=HierarchyTest.StructureOfEveryFamily:PolarHierarchy.SizeAndDepth || result=1
  SUNDER_TEST_SCALE=40 run soak-probes "Probes of 276,000 pairs" build/tests/solid_fast \
    --file=solid_hierarchy_complexity_test || result=1
  return "$result"
}

# Of each statement of certificate files: 100,000 forced ones, which both checkers may accept where brute force says that they
# are true only, and 10,000 spoilt ones, about which they agree.
part_claims() {
  local test name result=0
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  build release sunder_cli || return 1
  for test in verifier/python/tests/test_*.py; do
    name=$(basename "$test" .py)
    SUNDER_PROGRAM=$root/build/bin/sunder SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-250} \
      run "soak-claims-$name" "$name" python3 "$test" || result=1
    grep -E '^(question|[a-z_]+ .* [0-9]+ +[0-9]+ +[0-9]+$)' "$log_folder/soak-claims-$name.log" || true
  done
  return "$result"
}

# Makes cases/fuzz/corpus.tar.gz anew: of what it held and of what runs have found since, few inputs that reach all branches.
part_corpus() {
  local program name result=0
  configure asan-ubsan "clang++-$clang" || return 1
  build asan-ubsan fuzzers || return 1
  rm -rf build/fuzz/{kept,new}
  mkdir -p build/fuzz/kept
  tar -xzf cases/fuzz/corpus.tar.gz -C build/fuzz/kept || return 1
  for program in build/asan-ubsan/fuzz/*_fuzz; do
    name=$(basename "$program")
    mkdir -p build/fuzz/{new,kept,corpus}/"$name"
    run "corpus-$name" "$name" fuzz_one "$program" -set_cover_merge=1 -use_counters=0 \
      build/fuzz/{new,kept,corpus}/"$name" cases || result=1
  done
  [ "$result" -eq 0 ] || return 1
  tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -C build/fuzz/new -cf - . | gzip -9n >cases/fuzz/corpus.tar.gz
}

part_tsan() {
  configure tsan "$CXX" || return 1
  build tsan || return 1
  local suppressions=
  [ ! -f tests/tsan.suppressions ] || suppressions=suppressions=$root/tests/tsan.suppressions
  SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-0.02} TSAN_OPTIONS="halt_on_error=1 $suppressions" \
    run_tests tsan tsan --label-regex '^(unit|tests|example)$' --label-exclude '^slow$'
}

# All tests with Clang, each source alone and without precompiled headers; then the same certificates, byte for byte, as
# with the other compiler.
part_clang() {
  configure clang "clang++-$clang" -DSUNDER_PRECOMPILED_HEADERS=OFF -DSUNDER_BATCHES=OFF || return 1
  build clang || return 1
  run_tests clang clang || return 1
  configure release "$CXX" -DSUNDER_TESTS=ON || return 1
  build release certificate_sample round_certificate_sample planar_certificate_sample segments_certificate_sample \
    sets_certificate_sample || return 1
  compare_compilers() {
    certificates build/certificates build 2000 && certificates build/clang/certificates build/clang 2000 &&
      diff -rq -x verdicts build/certificates build/clang/certificates
  }
  run compare "$CXX and clang++-$clang write the same certificates" compare_compilers
}

# Library and program with the other standard library: the same answers, the same proofs.
part_libcxx() {
  need "libc++-$clang-dev" "libc++abi-$clang-dev"
  configure libcxx "clang++-$clang" || return 1
  build libcxx || return 1
  run libcxx "What is proved, by the program with libc++" \
    env SUNDER_PROGRAM="$root/build/libcxx/bin/sunder" python3 cli/proofs_page_test.py
}

part_coverage() {
  configure coverage g++ || return 1
  build coverage || return 1
  find build/coverage -name '*.gcda' -delete
  SUNDER_TEST_SCALE=${SUNDER_TEST_SCALE:-0.02} run_tests coverage coverage-tests --label-exclude '^slow$' || return 1
  run coverage "Counting lines" gcovr --root . --filter sunder/ --filter cli/ --filter verifier/ \
    --exclude '.*_test\.cpp' --exclude-throw-branches --sort-uncovered build/coverage || return 1
  tail -n 3 "$log_folder/coverage.log"
  say "By file: $root/$log_folder/coverage.log"
}
