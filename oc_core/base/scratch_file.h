// Arrays on disk for what need not fit into memory: a file without a name, which is gone when its program ends, however
// that ends, and which is mapped into memory to be read and written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <type_traits>
#include <vector>

namespace ocelli {

class ScratchFile {
 public:
  /// In `folder`. Here and below WorkError is thrown where the disk is full or nothing can be written there.
  explicit ScratchFile(const std::filesystem::path& folder);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// A path by which it can be opened while this object lives, also by other processes of this user: a link of the
  /// system, /proc/ID/fd/NUMBER. What was appended here and is still buffered is not seen there.
  std::filesystem::path link() const;

  void append(std::span<const uint8_t> bytes);
  void appendZeros(uint64_t bytes);

  /// All of it, in memory as it is touched. From now on nothing can be appended.
  std::span<uint8_t> map();
  /// Gives the memory of what was touched back to the system; its contents stay.
  void release() const;

 private:
  void flush();
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path folder_;
  int file_ = -1;
  uint64_t size_ = 0;  ///< without what is buffered
  std::vector<uint8_t> buffered_;
  std::span<uint8_t> mapped_;
};

/// The same of values that are their bytes.
template <class T>
class ScratchArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit ScratchArray(const std::filesystem::path& folder) : file_(folder) {}

  void push(const T& value) { file_.append({reinterpret_cast<const uint8_t*>(&value), sizeof(T)}); }
  void pushZeros(uint64_t count) { file_.appendZeros(count * sizeof(T)); }
  std::span<T> map() {
    const std::span<uint8_t> bytes = file_.map();
    return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
  void release() const { file_.release(); }

 private:
  ScratchFile file_;
};

}  // namespace ocelli
