// A file on disk without a name, which other programs open through this process (/proc/PID/fd/N): gone when the program
// ends, however that ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace ocelli {

class UnnamedFile {
 public:
  /// In a folder, that for temporary files by default. Here and below WorkError is thrown where the disk is full or
  /// nothing can be written there.
  UnnamedFile();
  explicit UnnamedFile(const std::filesystem::path& folder);
  ~UnnamedFile();
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  void append(std::span<const std::byte> bytes);
  /// Zeros up to this size, which take no space before they are written over.
  void resize(uint64_t bytes);
  void writeAt(uint64_t offset, std::span<const std::byte> bytes);
  /// What other programs may open, to read or to write, while this lives.
  std::string path() const;
  uint64_t size() const;
  /// All of it, for reading. From now on its size stays; what is written over shows.
  std::span<const std::byte> map();

 private:
  std::filesystem::path folder_;
  int file_ = -1;
  std::span<const std::byte> mapped_;
};

}  // namespace ocelli
