// Values one after the other in the bytes of a message between ranks (ranks.h).
#pragma once

#include <cstring>
#include <string>
#include <type_traits>

#include "oc_core/base/check.h"
#include "oc_core/ranks/ranks.h"

namespace ocelli {

class BytePacker {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    addRaw(&value, sizeof(T));
  }
  void add(const std::string& text) {
    add(uint64_t{text.size()});
    addRaw(text.data(), text.size());
  }
  template <class T>
  void add(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(uint64_t{values.size()});
    addRaw(values.data(), values.size() * sizeof(T));
  }

  Bytes take() { return std::move(bytes_); }

 private:
  void addRaw(const void* from, size_t size) {
    const auto* const first = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  Bytes bytes_;
};

/// Takes them out in the same order. A message that ends too early is a bug: ranks run the same program.
class ByteUnpacker {
 public:
  /// The bytes must outlive it.
  explicit ByteUnpacker(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  T value() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    takeRaw(&value, sizeof(T));
    return value;
  }
  std::string text() {
    std::string text(static_cast<size_t>(value<uint64_t>()), '\0');
    takeRaw(text.data(), text.size());
    return text;
  }
  template <class T>
  std::vector<T> values() {
    std::vector<T> values(static_cast<size_t>(value<uint64_t>()));
    takeRaw(values.data(), values.size() * sizeof(T));
    return values;
  }
  bool atEnd() const { return left_.empty(); }

 private:
  void takeRaw(void* to, size_t size) {
    OC_CHECK(size <= left_.size(), "messages between ranks are whole");
    if (size > 0) {
      std::memcpy(to, left_.data(), size);
    }
    left_ = left_.subspan(size);
  }

  std::span<const std::byte> left_;
};

}  // namespace ocelli
