#include "oc_core/base/error.h"

#include <algorithm>

namespace ocelli {
namespace {

// What comes out of a damaged file must neither end the message nor steer the terminal.
std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n'; }, '?');
  return text;
}

std::string sentence(const std::string& what, const std::string& where, const std::string& next) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!next.empty()) {
    text += "\n  try: " + next;
  }
  return printable(text);
}

}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& next)
    : std::runtime_error(sentence(what, where, next)) {}

}  // namespace ocelli
