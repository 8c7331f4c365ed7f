// Texts that are written from right to left, or joined: Arabic, Hebrew. Their letters stand in memory in the order in
// which they are read; here they get the forms that they have beside each other (Unicode's presentation forms, which
// fonts have glyphs of) and the order in which they stand on a line, by the Unicode bidirectional algorithm (UAX #9).
// Numbers and words of other scripts within keep their own direction.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// A paragraph. It is cut into lines in the order of reading, and each line then put into that of the screen.
class BidiParagraph {
 public:
  /// The direction of the paragraph is that of most of its letters, or else of the first; of one without letters, that
  /// of its language.
  BidiParagraph(std::string_view utf8, bool rightToLeft);

  /// In the order of reading, in the forms in which they are drawn. A ligature is one character.
  const std::u32string& characters() const { return characters_; }
  /// Those from one to before another, from the left to the right of a line.
  std::u32string visual(size_t from, size_t to) const;

 private:
  std::u32string characters_;
  bool rightToLeft_ = false;
  // Of each character, as FriBidi has them; empty where nothing is to be reordered.
  std::vector<uint32_t> types_{};
  std::vector<signed char> levels_{};
};

/// What fonts must have for a text: the forms of its letters, without line breaks and tabs.
std::set<char32_t> shapedGlyphsOf(std::string_view utf8);
/// The same for all texts that can be made of these letters.
std::set<char32_t> shapedAlphabet(std::string_view letters);

}  // namespace ocelli
