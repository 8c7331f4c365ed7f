#include "oc_core/base/printable_text.h"

#include <cstdio>

namespace ocelli {
namespace {

std::string escaped(const char* format, unsigned code) {
  char text[16];
  std::snprintf(text, sizeof text, format, code);
  return text;
}

}  // namespace

std::string printableText(std::string_view text) {
  constexpr unsigned char kDelete = 0x7f;
  constexpr unsigned char kLeadOfC1 = 0xc2;  // U+0080 to U+00BF are this byte and one from 0x80 to 0xbf
  std::string shown;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const unsigned char next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if (byte == '\n') {
      shown += "\\n";
    } else if (byte == '\t') {
      shown += "\\t";
    } else if (byte < ' ' || byte == kDelete) {
      shown += escaped("\\x%02x", byte);
    } else if (byte == kLeadOfC1 && next >= 0x80 && next <= 0x9f) {
      shown += escaped("\\u%04x", next);
      ++i;
    } else {
      shown += text[i];
    }
  }
  return shown;
}

}  // namespace ocelli
