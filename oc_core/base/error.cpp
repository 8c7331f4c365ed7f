#include "oc_core/base/error.h"

#include <algorithm>
#include <utility>

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

Error::Parts cleaned(const std::string& what, const std::string& where, const std::string& next,
                     const std::string& details) {
  return {oneLine(what), oneLine(where), printable(next, true), printable(details, true)};
}

std::string sentence(const Error::Parts& parts) {
  std::string text = parts.where.empty() ? parts.problem : parts.where + ": " + parts.problem;
  for (size_t begin = 0; begin < parts.details.size();) {
    const size_t end = std::min(parts.details.find('\n', begin), parts.details.size());
    text += "\n    " + parts.details.substr(begin, end - begin);
    begin = end + 1;
  }
  if (!parts.next.empty()) {
    text += "\n  try: " + parts.next;
  }
  return text;
}

}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& next, const std::string& details)
    : Error(cleaned(what, where, next, details)) {}

Error::Error(Parts parts)
    : std::runtime_error(sentence(parts)), parts_(std::make_shared<const Parts>(std::move(parts))) {}

}  // namespace ocelli
