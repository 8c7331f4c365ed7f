#!/bin/sh
# Builds the `release` preset with its benchmarks and runs the tests that scripts/test.sh leaves out: simulations that repeat what is random
# hundreds of times. They take about 20 minutes on two cores. For changes of the analysis, of walk maps and of cameras in
# mazes, and before a release.
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --target all bench/all
results="$PWD/build/release/results/thorough.xml"
mkdir -p "$(dirname "$results")"
ctest --preset release --label-regex '^thorough$' --parallel "$(nproc)" --output-junit "$results" || failed=yes
python3 -B tests/house/check_results.py tests/expected_results.json thorough "$results"
[ -z "${failed-}" ]
