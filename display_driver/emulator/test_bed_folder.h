// The folder for temporary files in which a process's emulated devices live. It is locked for as long as it exists, so
// that what killed emulators have left can be told from what lives, and removed.
#pragma once

#include <filesystem>

namespace ocelli {

/// The folder is the same one for all that live at the same time, and its name for all of a process: umockdev finds out
/// only once where temporary files go.
class TestBedFolder {
 public:
  /// Throws WorkError where there can be no such folder.
  TestBedFolder();
  /// The last one removes it with all it holds.
  ~TestBedFolder();
  TestBedFolder(const TestBedFolder&) = delete;
  TestBedFolder& operator=(const TestBedFolder&) = delete;

  const std::filesystem::path& path() const;
};

/// Removes folders of this kind in `where` that nobody has locked. Returns how many; what cannot be removed is left.
size_t sweepTestBeds(const std::filesystem::path& where = std::filesystem::temp_directory_path());

}  // namespace ocelli
