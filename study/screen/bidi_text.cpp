#include "study/screen/bidi_text.h"

#include <fribidi.h>

#include <algorithm>

#include "oc_core/base/check.h"
#include "study/screen/drawable_text.h"

namespace ocelli {
namespace {

bool isRightToLeft(char32_t character) {
  return (character >= 0x0590 && character <= 0x08ff) || (character >= 0xfb1d && character <= 0xfdff) ||
         (character >= 0xfe70 && character <= 0xfefc);
}

/// A key or a name may stand first in a text of another script. Where both are as many it is for the first letter.
FriBidiParType directionOf(const std::vector<FriBidiCharType>& types, bool rightToLeft) {
  const auto fromTheRight = std::ranges::count_if(
      types, [](FriBidiCharType type) { return FRIBIDI_IS_STRONG(type) && FRIBIDI_IS_RTL(type); });
  const auto letters = std::ranges::count_if(types, [](FriBidiCharType type) { return FRIBIDI_IS_STRONG(type); });
  if (2 * fromTheRight == letters) {
    return rightToLeft ? FRIBIDI_PAR_WRTL : FRIBIDI_PAR_WLTR;
  }
  return 2 * fromTheRight > letters ? FRIBIDI_PAR_RTL : FRIBIDI_PAR_LTR;
}

}  // namespace

BidiParagraph::BidiParagraph(std::string_view utf8, bool rightToLeft) : characters_(charactersOf(utf8)) {
  if (characters_.empty() || (!rightToLeft && std::ranges::none_of(characters_, isRightToLeft))) {
    return;
  }
  const auto count = static_cast<FriBidiStrIndex>(characters_.size());
  std::vector<FriBidiChar> text(characters_.begin(), characters_.end());
  std::vector<FriBidiCharType> types(text.size());
  std::vector<FriBidiBracketType> brackets(text.size());
  std::vector<FriBidiLevel> levels(text.size());
  fribidi_get_bidi_types(text.data(), count, types.data());
  FriBidiParType direction = directionOf(types, rightToLeft);
  fribidi_get_bracket_types(text.data(), count, types.data(), brackets.data());
  const FriBidiLevel known =
      fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &direction, levels.data());
  OC_CHECK(known != 0, "the levels of a text can be found");
  rightToLeft_ = FRIBIDI_IS_RTL(direction);
  std::vector<FriBidiArabicProp> joining(text.size());
  fribidi_get_joining_types(text.data(), count, joining.data());
  fribidi_join_arabic(types.data(), count, levels.data(), joining.data());
  fribidi_shape(FRIBIDI_FLAGS_DEFAULT | FRIBIDI_FLAGS_ARABIC, levels.data(), count, joining.data(), text.data());
  characters_.clear();
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != FRIBIDI_CHAR_FILL) {  // the second letter of a ligature
      characters_ += static_cast<char32_t>(text[i]);
      types_.push_back(types[i]);
      levels_.push_back(levels[i]);
    }
  }
}

std::u32string BidiParagraph::visual(size_t from, size_t to) const {
  if (levels_.empty() || from >= to) {
    return characters_.substr(from, to - from);
  }
  std::vector<FriBidiChar> text(characters_.begin(), characters_.end());
  std::vector<FriBidiLevel> levels(levels_.begin(), levels_.end());
  const FriBidiLevel known = fribidi_reorder_line(
      FRIBIDI_FLAGS_DEFAULT, types_.data(), static_cast<FriBidiStrIndex>(to - from), static_cast<FriBidiStrIndex>(from),
      rightToLeft_ ? FRIBIDI_PAR_RTL : FRIBIDI_PAR_LTR, levels.data(), text.data(), nullptr);
  OC_CHECK(known != 0, "a line can be put in order");
  return {text.begin() + static_cast<std::ptrdiff_t>(from), text.begin() + static_cast<std::ptrdiff_t>(to)};
}

std::set<char32_t> shapedGlyphsOf(std::string_view utf8) {
  std::set<char32_t> glyphs;
  const BidiParagraph paragraph(utf8, false);
  for (const char32_t character : paragraph.characters()) {
    if (character != U'\n' && character != U'\t') {
      glyphs.insert(character);
    }
  }
  return glyphs;
}

std::set<char32_t> shapedAlphabet(std::string_view letters) {
  std::set<char32_t> glyphs;
  const std::u32string all = charactersOf(letters);
  for (const char32_t letter : all) {
    // Alone; first, in the middle and last between letters of its own; last after one that joins.
    const std::u32string alone(1, letter);
    for (const std::u32string& text : {alone, std::u32string(3, letter), U"\u0628" + alone}) {
      const bool joins = text.size() != 2 || isRightToLeft(letter);
      glyphs.merge(joins ? shapedGlyphsOf(utf8Of(text)) : std::set<char32_t>());
    }
  }
  if (all.find(U'\u0644') != std::u32string::npos) {
    // Lam and alef are one letter, alone and after one that joins.
    for (const char32_t alef : std::u32string_view(U"\u0622\u0623\u0625\u0627")) {
      glyphs.merge(shapedGlyphsOf(utf8Of(std::u32string(U"\u0644") + alef + U" \u0628\u0644" + alef)));
    }
  }
  return glyphs;
}

}  // namespace ocelli
