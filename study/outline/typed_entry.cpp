#include "study/outline/typed_entry.h"

#include <algorithm>

namespace ocelli {
namespace {

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80;
}

/// The character that begins at a place of valid UTF-8.
char32_t characterAt(const std::string& text, size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const unsigned more = lead < 0x80 ? 0 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
  char32_t character = more == 0 ? lead : lead & (0x3fU >> more);
  for (size_t i = at + 1; i <= at + more && i < text.size(); ++i) {
    character = character << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
  }
  return character;
}

}  // namespace

void appendUtf8(std::string& text, char32_t character) {
  const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
  const auto rest = [&](unsigned shift) { add(0x80U | (character >> shift & 0x3fU)); };
  if (character < 0x80) {
    add(character);
  } else if (character < 0x800) {
    add(0xc0U | character >> 6U);
    rest(0);
  } else if (character < 0x10000) {
    add(0xe0U | character >> 12U);
    rest(6);
    rest(0);
  } else {
    add(0xf0U | character >> 18U);
    rest(12);
    rest(6);
    rest(0);
  }
}

size_t countUtf8(const std::string& text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return !continues(c); }));
}

void dropLastUtf8(std::string& text) {
  while (!text.empty() && continues(text.back())) {
    text.pop_back();
  }
  if (!text.empty()) {
    text.pop_back();
  }
}

void pressTyped(const FormField& /*field*/, QuestionEntry& entry, Key key) {
  if (key == Key::kBackspace) {
    dropLastUtf8(entry.typed);
  }
}

std::optional<QuestionStroke> strokeTowardsTyped(const FormField& /*field*/, const QuestionEntry& entry,
                                                 const QuestionEntry& target) {
  if (entry.typed == target.typed) {
    return std::nullopt;
  }
  if (!target.typed.starts_with(entry.typed)) {
    return QuestionStroke{Key::kBackspace};
  }
  return QuestionStroke{std::nullopt, characterAt(target.typed, entry.typed.size())};
}

}  // namespace ocelli
