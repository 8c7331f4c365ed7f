// A file mapped into memory to be read: what is not touched is not read.
//
// Where the file becomes shorter while it is mapped (`cp` over it does that, a rename does not), or its disk fails, the
// next read of what is gone is a SIGBUS, which ends the program. A program that calls mappedFileAt() in its handler of
// SIGBUS can say of which file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace ocelli {

class MappedFile {
 public:
  /// Throws InputError where it is no regular file that can be read. An empty file has no bytes.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;

  std::span<const uint8_t> bytes() const { return bytes_; }
  /// Reads them ahead.
  void willNeed(size_t begin, size_t end) const;
  /// Gives the memory of what was read back to the system: of all, or of the pages that lie in a part as a whole.
  void release() const;
  void release(size_t begin, size_t end) const;

 private:
  std::span<const uint8_t> bytes_;
  size_t slot_ = 0;
};

/// The path of the file that is mapped there; null where none is that this program knows of. May be called in a signal
/// handler, which interrupts a read of that file.
const char* mappedFileAt(const void* address) noexcept;

}  // namespace ocelli
