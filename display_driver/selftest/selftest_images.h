// What an observer sees of a test pattern on a display that is right: the reference images of the checklist.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "display_driver/selftest/test_patterns.h"

namespace ocelli {

struct SelftestImage {
  std::string file;   ///< relative to the page
  std::string place;  ///< "From the front"
  int width = 0;
  int height = 0;
};

/// Each wrong look of a pattern that has an example, by its number: `FOLDER/NAME-wrong-NUMBER.png`; an empty file name
/// where there is none.
std::vector<SelftestImage> writeWrongImages(const TestPattern& pattern, const DisplayProfile& profile,
                                            const std::filesystem::path& folder, int side);

/// From the front (the default eye), from the front and above, from the right and from straight above, all at the
/// profile's viewing distance, as square PNG files `FOLDER/NAME-PLACE.png` of so many pixels a side; and slice 0.
/// Throws WorkError.
std::vector<SelftestImage> writeSelftestImages(const Volume& volume, const std::filesystem::path& folder,
                                               const std::string& name, int side);

}  // namespace ocelli
