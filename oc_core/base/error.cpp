#include "oc_core/base/error.h"

#include <algorithm>

namespace ocelli {
namespace {

constexpr size_t kMaxBytes = 1000;

// What comes out of a damaged file must neither end the message nor steer the terminal.
std::string printable(std::string text, bool mayHaveLines) {
  constexpr char kDelete = 0x7f;
  std::ranges::replace_if(
      text,
      [&](char c) { return (static_cast<unsigned char>(c) < ' ' && !(mayHaveLines && c == '\n')) || c == kDelete; },
      '?');
  return text;
}

std::string oneLine(const std::string& text) {
  if (text.size() <= kMaxBytes) {
    return printable(text, false);
  }
  size_t end = kMaxBytes;
  const auto continuesCharacter = [&] { return (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80; };
  while (end > 0 && continuesCharacter()) {
    --end;
  }
  return printable(text.substr(0, end), false) + "...";
}

std::string sentence(const std::string& what, const std::string& where, const std::string& next,
                     const std::string& details) {
  std::string text = where.empty() ? oneLine(what) : oneLine(where) + ": " + oneLine(what);
  for (size_t begin = 0; begin < details.size();) {
    const size_t end = std::min(details.find('\n', begin), details.size());
    text += "\n    " + details.substr(begin, end - begin);
    begin = end + 1;
  }
  if (!next.empty()) {
    text += "\n  try: " + next;
  }
  return printable(text, true);
}

}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& next, const std::string& details)
    : std::runtime_error(sentence(what, where, next, details)) {}

}  // namespace ocelli
