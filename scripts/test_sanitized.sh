#!/bin/sh
# Builds the `asan` preset (clang, AddressSanitizer, UndefinedBehaviorSanitizer) of what needs no OpenGL, and runs the
# fast tests; then fuzzes the file readers, 10 seconds each: fuzz/run.sh by hand gives them more.
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh --developer
cmake --preset asan
cmake --build --preset asan --target fast_tests
# What the libraries underneath keep until the process ends is theirs.
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0:allocator_may_return_null=1}"
export ASAN_SYMBOLIZER_PATH="${ASAN_SYMBOLIZER_PATH:-/usr/lib/llvm-16/bin/llvm-symbolizer}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1}"
results="$PWD/build/asan/results"
rm -rf "$results"
ctest --preset asan --parallel "$(nproc)" || failed=yes
python3 -B tests/house/check_results.py tests/expected_results.json asan "$results"/*.xml
[ -z "${failed-}" ]
fuzz/run.sh 10
