// The temporary folders in which emulated devices live. Whoever emulates marks his folder and holds a lock on the mark
// while he lives, so that the folders of emulators that were killed can be told from others, and removed.
#pragma once

#include <filesystem>

namespace ocelli {

class TestBedMark {
 public:
  explicit TestBedMark(const std::filesystem::path& folder);
  ~TestBedMark();
  TestBedMark(const TestBedMark&) = delete;
  TestBedMark& operator=(const TestBedMark&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// Removes folders in `where` that carry a mark that nobody holds. Returns how many; what cannot be removed is left.
size_t sweepTestBeds(const std::filesystem::path& where = std::filesystem::temp_directory_path());

}  // namespace ocelli
