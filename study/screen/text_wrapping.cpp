#include "study/screen/text_wrapping.h"

#include <algorithm>

namespace ocelli {
namespace {

/// Ideographs, kana, and the signs that stand among them.
bool isIdeographic(char32_t c) {
  return (c >= 0x2e80 && c <= 0x9fff) || (c >= 0xf900 && c <= 0xfaff) || (c >= 0xff00 && c <= 0xffef);
}

/// JIS X 4051, in the main: closing brackets, stops, small kana and the sign for long vowels.
bool mustNotBegin(char32_t c) {
  constexpr std::u32string_view kSigns =
      U")]}、。，．・：；？！）］｝」』】〉》〕ーぁぃぅぇぉっゃゅょゎァィゥェォッャュョヮヵヶ々〜…‥.,:;?!%’”";
  return kSigns.find(c) != std::u32string_view::npos;
}

bool mustNotEnd(char32_t c) {
  constexpr std::u32string_view kSigns = U"([{（［｛「『【〈《〔‘“";
  return kSigns.find(c) != std::u32string_view::npos;
}

/// Whether a line may end before the second of two neighbours.
bool mayBreak(char32_t before, char32_t after) {
  if (after == U' ') {
    return false;  // it stays at the end of the line
  }
  if (before == U' ') {
    return true;
  }
  return (isIdeographic(before) || isIdeographic(after)) && !mustNotBegin(after) && !mustNotEnd(before);
}

}  // namespace

std::vector<std::pair<size_t, size_t>> wrapLines(std::u32string_view text, double width,
                                                 const std::function<double(char32_t character)>& advance) {
  std::vector<std::pair<size_t, size_t>> lines;
  const auto add = [&](size_t from, size_t to) {
    while (to > from && text[to - 1] == U' ') {
      --to;
    }
    lines.emplace_back(from, to);
  };
  size_t from = 0;
  while (from < text.size()) {
    const size_t newline = std::min(text.find(U'\n', from), text.size());
    size_t chance = from;  // the last place where the line may end
    double used = 0;
    size_t at = from;
    for (; at < newline; ++at) {
      if (at > from && mayBreak(text[at - 1], text[at])) {
        chance = at;
      }
      used += advance(text[at]);
      if (used > width && at > from && text[at] != U' ') {
        break;
      }
    }
    if (at < newline) {
      const size_t end = chance > from ? chance : at;
      add(from, end);
      from = end;
      continue;
    }
    add(from, newline);
    from = newline + 1;
  }
  return lines;
}

}  // namespace ocelli
