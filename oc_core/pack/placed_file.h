// A file of a packing job that is read and written at any place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace ocelli {

class PlacedFile {
 public:
  /// `flags`: those of open(2). All throw WorkError naming the file.
  PlacedFile(const std::filesystem::path& path, int flags);
  ~PlacedFile();
  PlacedFile(const PlacedFile&) = delete;
  PlacedFile& operator=(const PlacedFile&) = delete;

  void write(const void* bytes, size_t count, uint64_t at) const;
  void read(void* bytes, size_t count, uint64_t at) const;
  uint64_t size() const;

 private:
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path path_;
  int file_;
};

/// Gives a file that was written completely the name by which the job knows that. Throws WorkError.
void renameComplete(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ocelli
