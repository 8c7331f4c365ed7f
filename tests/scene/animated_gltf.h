// Small glTF files with animations, made by tests: accessors go into one buffer in the text of the file.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ocelli::test {

class AnimatedGltf {
 public:
  /// Adds an accessor, and returns its number. `type` is SCALAR, VEC2, VEC3, VEC4 or MAT4, with as many numbers an
  /// element.
  int floats(const std::string& type, const std::vector<float>& values) {
    return add(type, 5126, sizeof(float), values.size(), values.data());
  }
  int shorts(const std::string& type, const std::vector<uint16_t>& values) {
    return add(type, 5123, sizeof(uint16_t), values.size(), values.data());
  }
  /// Shares of 32767.
  int normalized(const std::string& type, const std::vector<int16_t>& values) {
    return add(type, 5122, sizeof(int16_t), values.size(), values.data(), R"(, "normalized": true)");
  }
  /// All zeros, but for what other accessors would say: no one reads it here.
  int sparse(const std::string& type, size_t numbers) {
    const std::vector<float> zeros(numbers, 0);
    return add(type, 5126, sizeof(float), numbers, zeros.data(),
               R"(, "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5125},
                               "values": {"bufferView": 0}})");
  }

  /// The file: `members` are those of its top level beside accessors, buffers and views, as JSON: "nodes": [...], ...
  std::string text(const std::string& members) const {
    return textWith(members, R"(, "uri": "data:application/octet-stream;base64,)" + base64() + '"');
  }
  /// The same with the bytes in a file of their own, which bytes() gives.
  std::string textBeside(const std::string& members, const std::string& uri) const {
    return textWith(members, R"(, "uri": ")" + uri + '"');
  }
  std::string bytes() const { return {bytes_.begin(), bytes_.end()}; }
  /// The same as a binary file (.glb).
  std::string binary(const std::string& members) const {
    std::string json = textWith(members, "");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](size_t number) {
      std::string bytes(4, '\0');
      const auto little = static_cast<uint32_t>(number);
      std::memcpy(bytes.data(), &little, bytes.size());
      return bytes;
    };
    return "glTF" + word(2) + word(28 + json.size() + bytes_.size()) + word(json.size()) + "JSON" + json +
           word(bytes_.size()) + std::string("BIN\0", 4) + bytes();
  }

 private:
  std::string textWith(const std::string& members, const std::string& place) const {
    return R"({"asset": {"version": "2.0"}, "scene": 0, )" + members + R"(, "accessors": [)" + accessors_ +
           R"(], "bufferViews": [)" + views_ + R"(], "buffers": [{"byteLength": )" + std::to_string(bytes_.size()) +
           place + "}]}";
  }

  int add(const std::string& type, int component, size_t size, size_t count, const void* data,
          const std::string& more = "") {
    const size_t width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    const std::string comma = number_ > 0 ? ", " : "";
    views_ += comma + R"({"buffer": 0, "byteOffset": )" + std::to_string(bytes_.size()) + R"(, "byteLength": )" +
              std::to_string(count * size) + "}";
    accessors_ += comma + R"({"bufferView": )" + std::to_string(number_) + R"(, "componentType": )" +
                  std::to_string(component) + R"(, "count": )" + std::to_string(count / width) + R"(, "type": ")" +
                  type + '"' + more + "}";
    const auto* first = static_cast<const uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + count * size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    return number_++;
  }

  std::string base64() const {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes_.size(); i += 3) {
      uint32_t bits = 0;
      for (size_t k = 0; k < 3; ++k) {
        bits = bits << 8 | (i + k < bytes_.size() ? bytes_[i + k] : 0u);
      }
      for (size_t k = 0; k < 4; ++k) {
        text += i + k > bytes_.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
      }
    }
    return text;
  }

  std::vector<uint8_t> bytes_;
  std::string accessors_;
  std::string views_;
  int number_ = 0;
};

}  // namespace ocelli::test
