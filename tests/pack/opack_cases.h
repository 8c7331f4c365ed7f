// Good and bad packed scenes as bytes: for the hostile tests, the corpus and the fuzzer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli::test {

struct OpackCase {
  std::string name;  ///< of its file in the corpus: good_... is whole, bad_... is refused once all of it is read
  std::vector<uint8_t> bytes;
  std::string complaint;  ///< a part of what is said of a bad one
};

/// The same on every call.
std::vector<OpackCase> opackCases();

/// Three groups of one part, the second of which replaces the first, and a tree above the last two; less than 4 KiB.
std::vector<uint8_t> smallPack();

}  // namespace ocelli::test
