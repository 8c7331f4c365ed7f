// Bytes that are read where they are asked for: of files, which may be larger than memory, and of tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "oc_core/base/reading_budget.h"

namespace ocelli {

class ByteSource {
 public:
  explicit ByteSource(std::string name) : name_(std::move(name)) {}
  virtual ~ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// For messages: a path.
  const std::string& name() const { return name_; }
  virtual uint64_t size() const = 0;
  /// How many of them take room on a disk: fewer, where the file has holes.
  virtual uint64_t storedBytes() const { return size(); }
  /// All of `into`. Throws InputError where the bytes end before.
  virtual void read(uint64_t offset, std::span<std::byte> into) const = 0;
  /// The first byte from there on that is not known to be zero: what lies before is a hole of a sparse file.
  virtual uint64_t skipHole(uint64_t offset) const { return offset; }

 private:
  std::string name_;
};

class FileSource : public ByteSource {
 public:
  /// Throws InputError where it is no regular file that can be read. `budget` grows by its size, and may be null.
  FileSource(const std::filesystem::path& path, ReadingBudget* budget);
  ~FileSource() override;

  uint64_t size() const override { return size_; }
  uint64_t storedBytes() const override { return storedBytes_; }
  void read(uint64_t offset, std::span<std::byte> into) const override;
  uint64_t skipHole(uint64_t offset) const override;

 private:
  int file_ = -1;
  uint64_t size_ = 0;
  uint64_t storedBytes_ = 0;
};

/// The bytes must outlive it.
class MemorySource : public ByteSource {
 public:
  MemorySource(std::span<const std::byte> bytes, std::string name) : ByteSource(std::move(name)), bytes_(bytes) {}
  uint64_t size() const override { return bytes_.size(); }
  void read(uint64_t offset, std::span<std::byte> into) const override;

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace ocelli
