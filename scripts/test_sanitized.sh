#!/bin/sh
# scripts/test_sanitized.sh [--all]: builds the `asan` preset (clang, AddressSanitizer, UndefinedBehaviorSanitizer) of what
# needs no OpenGL, and runs the fast tests of what reads, stores and talks, and of the program itself, which goes through all
# rooms; then fuzzes the file readers, 10 seconds each: fuzz/run.sh by hand gives them more.
# --all: the fast tests of rooms that compute as well, which take longest: for changes of these, and before a release.
set -eu
cd "$(dirname "$0")/.."

case "${1-}" in
  "") target=light_tests leave_out='^computes$' expected=asan ;;
  --all) target=fast_tests leave_out='^$' expected=asan-all ;;
  *)
    echo "usage: $0 [--all]" >&2
    exit 2
    ;;
esac

scripts/install_dependencies.sh --developer
cmake --preset asan
cmake --build --preset asan --target "$target"
# What the libraries underneath keep until the process ends is theirs.
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0:allocator_may_return_null=1}"
export ASAN_SYMBOLIZER_PATH="${ASAN_SYMBOLIZER_PATH:-/usr/lib/llvm-16/bin/llvm-symbolizer}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1}"
results="$PWD/build/asan/results"
rm -rf "$results"
ctest --preset asan --label-exclude "$leave_out" --parallel "$(nproc)" || failed=yes
python3 -B tests/house/check_results.py tests/expected_results.json "$expected" "$results"/*.xml
[ -z "${failed-}" ]
fuzz/run.sh 10
