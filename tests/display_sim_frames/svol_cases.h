// Good and bad `.svol` files as bytes: for the hostile tests, the corpus and the fuzzer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli::test {

struct SvolCase {
  std::string name;  ///< of its file in the corpus: good_... is whole, unfinished_... opens, bad_... is damaged
  std::vector<uint8_t> bytes;
};

/// The same on every call (as long as the version of zstd is the same).
std::vector<SvolCase> svolCases();

/// A recording of `frames` frames of 5 slices of 17x9 voxels: key and delta frames, dark, whole, delta and unchanged
/// slices.
std::vector<uint8_t> smallRecording(int frames);

}  // namespace ocelli::test
