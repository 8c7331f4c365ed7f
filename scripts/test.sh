#!/bin/sh
# Installs what is missing, builds the `release` preset and runs every test, the fast ones first, but those that repeat what
# is random for minutes (scripts/test_thorough.sh). Ends with how many ran; a test that was skipped without a known reason,
# and fewer tests than before, count as failures (tests/expected_results.json).
# OCELLI_DATA_DIR, where set, names a folder with meshes that some tests need; they are skipped without it.
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release
results="$PWD/build/release/results"
rm -rf "$results"
ctest --preset release --label-regex '^fast$' --parallel "$(nproc)" --output-junit "$results/fast.xml"
ctest --preset release --label-exclude '^(fast|thorough)$' --parallel "$(nproc)" --output-junit "$results/others.xml" || others=failed
python3 -B tests/house/check_results.py tests/expected_results.json release "$results"/*.xml
[ -z "${others-}" ]
