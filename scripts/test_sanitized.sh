#!/bin/sh
# scripts/test_sanitized.sh [--light|--all]: builds the `asan` preset (clang, AddressSanitizer, UndefinedBehaviorSanitizer) of
# what needs no OpenGL, and runs the fast tests of what takes in files, messages and answers of devices; then fuzzes the file
# readers, 10 seconds each: fuzz/run.sh by hand gives them more.
# --light: the fast tests of all rooms that compute little, and of the program itself, which goes through all rooms.
# --all: those of rooms that compute as well, which take longest: for changes of these, and before a release.
set -eu
cd "$(dirname "$0")/.."

case "${1-}" in
  "") target=reading_tests choice="--label-regex ^reads$" expected=asan ;;
  --light) target=light_tests choice="--label-exclude ^computes$" expected=asan-light ;;
  --all) target=fast_tests choice="" expected=asan-all ;;
  *)
    echo "usage: $0 [--light|--all]" >&2
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
# shellcheck disable=SC2086  # an option and its value
ctest --preset asan $choice --parallel "$(nproc)" || failed=yes
python3 -B tests/house/check_results.py tests/expected_results.json "$expected" "$results"/*.xml
[ -z "${failed-}" ]
fuzz/run.sh 10
