// A folder of a test's own, removed with all it holds.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ocelli::test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  /// Writes a file there and returns its path.
  std::filesystem::path write(std::string_view name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// The bytes of a file; fails the test where it cannot be read.
std::string fileBytes(const std::filesystem::path& path);

}  // namespace ocelli::test
