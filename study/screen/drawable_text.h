// Which characters the screens of a study can show. They draw one glyph a character, in the forms and the order of
// bidi_text.h: Arabic and Hebrew can be shown, other scripts that are joined or reordered cannot, whatever fonts are
// installed. Needs no OpenGL.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// The characters of a text in UTF-8; U+FFFD for invalid bytes.
std::u32string charactersOf(std::string_view utf8);
/// The other way round.
std::string utf8Of(std::u32string_view characters);
/// Of charactersOf(), without those that are no glyphs: line breaks and tabs.
std::set<char32_t> glyphsOf(std::string_view utf8);

/// Why the screens show a character wrongly in any font: "its letters are joined or reordered". Nothing where they do
/// not.
std::optional<std::string> scriptProblem(char32_t character);

/// Characters that cannot be shown, and why.
struct UndrawableCharacters {
  std::u32string characters;
  std::string reason;
};
/// With the fonts that are installed on this computer. Empty where all can.
std::vector<UndrawableCharacters> undrawableOf(const std::set<char32_t>& characters);

/// For people: "U+4F60 你, U+597D 好 and 12 more".
std::string namesOf(const std::u32string& characters);

}  // namespace ocelli
