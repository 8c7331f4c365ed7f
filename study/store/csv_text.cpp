#include "study/store/csv_text.h"

#include <cstdint>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

/// Bytes of the UTF-8 sequence at the start, 0 where there is none.
size_t sequenceLength(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t first = byte(0);
  const size_t length = first < 0x80   ? 1
                        : first < 0xc2 ? 0
                        : first < 0xe0 ? 2
                        : first < 0xf0 ? 3
                        : first < 0xf5 ? 4
                                       : 0;
  if (length == 0 || length > text.size()) {
    return 0;
  }
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) {
      return 0;
    }
  }
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) > 0x9f;
  const bool tooLarge = first == 0xf4 && byte(1) > 0x8f;
  return overlong || surrogate || tooLarge ? 0 : length;
}

}  // namespace

std::string csvText(std::string_view text) {
  std::string field;
  bool quoted = false;
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) {
    field += '\'';
  }
  while (!text.empty()) {
    const size_t length = sequenceLength(text);
    if (length == 0) {
      field += kReplacement;
      text.remove_prefix(1);
      continue;
    }
    const char c = text.front();
    quoted = quoted || c == ',' || c == '"' || c == '\n' || c == '\r';
    if (c == '"') {
      field += '"';
    }
    field += text.substr(0, length);
    text.remove_prefix(length);
  }
  return quoted ? std::string("\"").append(field).append("\"") : field;
}

std::vector<std::vector<std::string>> csvLines(std::string_view bytes, const std::string& where) {
  std::vector<std::vector<std::string>> lines;
  std::vector<std::string> line;
  std::string field;
  bool inQuotes = false;
  bool lineHasBytes = false;
  const auto endLine = [&] {
    line.push_back(std::move(field));
    field.clear();
    lines.push_back(std::move(line));
    line.clear();
    lineHasBytes = false;
  };
  for (size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (inQuotes) {
      if (c != '"') {
        field += c;
      } else if (i + 1 < bytes.size() && bytes[i + 1] == '"') {
        field += bytes[++i];
      } else {
        inQuotes = false;
      }
    } else if (c == '"') {
      inQuotes = true;
      lineHasBytes = true;
    } else if (c == ',') {
      line.push_back(std::move(field));
      field.clear();
      lineHasBytes = true;
    } else if (c == '\n') {
      endLine();
    } else if (c != '\r' || i + 1 >= bytes.size() || bytes[i + 1] != '\n') {
      field += c;
      lineHasBytes = true;
    }
  }
  if (inQuotes) {
    throw InputError("a quoted field of this table does not end", where, "check the quotes of the last lines");
  }
  if (lineHasBytes) {
    endLine();
  }
  return lines;
}

}  // namespace ocelli
