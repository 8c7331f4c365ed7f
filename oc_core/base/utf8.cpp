#include "oc_core/base/utf8.h"

#include <algorithm>
#include <array>
#include <optional>

namespace ocelli {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Halves of surrogate pairs are none.
bool isCharacter(char32_t code) {
  return !(code >= 0xD800 && code < 0xE000) && code <= 0x10FFFF;
}

bool isAllowed(char32_t code) {
  const bool control = (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0);
  return !control && code != 0xFFFE && code != 0xFFFF && isCharacter(code);
}

struct Decoded {
  char32_t code;
  size_t bytes;
};

/// None where the bytes at `at` are no character in its shortest form.
std::optional<Decoded> decode(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) {
    return Decoded{first, 1};
  }
  const size_t bytes = first >= 0xF0 && first < 0xF8 ? 4 : first >= 0xE0 && first < 0xF0 ? 3 : first >= 0xC0 ? 2 : 0;
  if (bytes == 0 || first >= 0xF8 || at + bytes > text.size()) {
    return std::nullopt;
  }
  char32_t code = first & (0xFFU >> (bytes + 1));
  for (size_t i = 1; i < bytes; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80) {
      return std::nullopt;
    }
    code = code << 6 | (byte(at + i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
  if (code < kMin[bytes]) {
    return std::nullopt;
  }
  return Decoded{code, bytes};
}

}  // namespace

size_t bytesOfFirstCharacter(std::string_view text) {
  const std::optional<Decoded> decoded = text.empty() ? std::nullopt : decode(text, 0);
  return decoded && isCharacter(decoded->code) ? decoded->bytes : 0;
}

std::string cleanText(std::string_view text) {
  std::string clean;
  for (size_t at = 0; at < text.size();) {
    const std::optional<Decoded> decoded = decode(text, at);
    clean += utf8FromCodePoint(decoded && isAllowed(decoded->code) ? decoded->code : kReplacement);
    at += decoded ? decoded->bytes : 1;
  }
  return clean;
}

size_t characterCount(std::string_view text) {
  return static_cast<size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U; }));
}

std::vector<char32_t> codePoints(std::string_view text) {
  std::vector<char32_t> codes;
  for (size_t at = 0; at < text.size();) {
    const std::optional<Decoded> decoded = decode(text, at);
    codes.push_back(decoded ? decoded->code : kReplacement);
    at += decoded ? decoded->bytes : 1;
  }
  return codes;
}

std::string utf8FromCodePoint(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (code < 0x80) {
    return {byte(code)};
  }
  if (code < 0x800) {
    return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  }
  if (code < 0x10000) {
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
  }
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)), byte(0x80 | (code >> 6 & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

}  // namespace ocelli
