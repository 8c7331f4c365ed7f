// Seas of images that are whole, and such that are made to mislead: their checksums fit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli::test {

struct SeaCase {
  std::string name;  ///< "good_..." reads, "bad_..." does not
  std::vector<uint8_t> bytes;
  std::string complaint = {};  ///< a part of what is said of it
};

std::vector<SeaCase> seaCases();

}  // namespace ocelli::test
