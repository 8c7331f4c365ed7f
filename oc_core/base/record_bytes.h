// The bytes of the records that readers hand back (reader_process.h): numbers as they are in memory, lists, texts. For
// the .cpp files that write and read their parts.
//
// Both ends are of one build and on one machine; but the writer may have been led astray by the file that it read, so
// the reader trusts nothing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "oc_core/base/byte_sink.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {

class RecordWriter {
 public:
  explicit RecordWriter(const ByteSink& sink) : sink_(sink) {}

  template <class Value>
  void list(const std::vector<Value>& values) {
    raw(values.data(), values.size() * sizeof(Value));
  }
  template <class Value>
  void value(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    raw(&value, sizeof(value));
  }
  void count(size_t number) {
    OC_CHECK(number <= std::numeric_limits<uint32_t>::max(), "a record counts with 32 bits");
    value(static_cast<uint32_t>(number));
  }
  void text(std::string_view text) {
    count(text.size());
    raw(text.data(), text.size());
  }
  void raw(const void* data, size_t bytes) { sink_({static_cast<const std::byte*>(data), bytes}); }

 private:
  const ByteSink& sink_;
};

/// The parts of the text of an error, as Error::what() gives it.
struct ErrorText {
  explicit ErrorText(const std::string& message);

  std::string what;
  std::string next;
  std::string details;
};

/// The error whose text another process sent.
template <class ErrorType = InputError>
ErrorType errorAsItWas(const std::string& message) {
  const ErrorText text(message);
  return {text.what, "", text.next, text.details};
}

/// What a record is about, for the error message where it is none.
struct RecordWords {
  std::string_view what;  ///< "scene"
  std::string_view next;  ///< what to do where it is broken: "convert the scene to binary PLY"
};

/// Trusts nothing, and asks for no more memory than there are bytes.
class RecordParser {
 public:
  /// `writer` names the program that wrote them; it and `words` must outlive this.
  RecordParser(std::span<const std::byte> bytes, const std::string& writer, const RecordWords& words)
      : bytes_(bytes), writer_(writer), words_(words) {}

  [[noreturn]] void fail(const std::string& what) const {
    const std::string name(words_.what);
    throw WorkError("the program that reads " + name + " files gave back what is no " + name + " (" + what + ")",
                    writer_, std::string(words_.next) + ", and report this");
  }

  bool atEnd() const { return bytes_.empty(); }

  std::span<const std::byte> take(uint64_t bytes) {
    if (bytes > bytes_.size()) {
      fail("it ends too early");
    }
    const auto taken = bytes_.first(bytes);
    bytes_ = bytes_.subspan(bytes);
    return taken;
  }

  template <class Value>
  Value value() {
    Value value;
    std::memcpy(&value, take(sizeof(value)).data(), sizeof(value));
    return value;
  }

  uint32_t number() { return value<uint32_t>(); }

  template <class Value>
  std::vector<Value> list(uint64_t count) {
    const auto source = take(count * sizeof(Value));
    std::vector<Value> values(count);
    if (count > 0) {
      std::memcpy(values.data(), source.data(), source.size());
    }
    return values;
  }

  /// A count of things of which each takes so many bytes at least.
  uint32_t count(size_t minBytes) {
    const uint32_t count = number();
    if (count > bytes_.size() / minBytes) {
      fail("a count is too large");
    }
    return count;
  }

  std::string text() {
    const auto bytes = take(number());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  void expect(std::string_view word) {
    if (std::memcmp(take(word.size()).data(), word.data(), word.size()) != 0) {
      fail("a mark is missing");
    }
  }

 private:
  std::span<const std::byte> bytes_;  ///< those that are still to be read
  const std::string& writer_;
  const RecordWords& words_;
};

}  // namespace ocelli
