// The checklist of `ocelli device selftest`: plain HTML and CSS to read beside a display or to print, no script,
// nothing from the network.
#pragma once

#include <string>
#include <vector>

#include "display_driver/selftest/selftest_images.h"
#include "display_driver/selftest/test_patterns.h"

namespace ocelli {

struct SelftestSection {
  const TestPattern* pattern = nullptr;
  std::string volumeFile;             ///< relative to the page
  std::vector<SelftestImage> images;  ///< none of a dark one
  std::vector<SelftestImage> wrong;   ///< as many as the pattern has wrong looks
};

/// The whole of index.html. `version` is that of the program.
std::string selftestPage(const std::vector<SelftestSection>& sections, const DisplayProfile& profile,
                         const std::string& version);

}  // namespace ocelli
