#include "study/screen/drawable_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "oc_core/window/system_font.h"

namespace ocelli {
namespace {

constexpr char32_t kReplacement = 0xfffd;

constexpr const char* kShaped = "its letters are joined or reordered, which these screens cannot do";
constexpr const char* kCombining = "it joins the letter before it: write one character for both (Unicode NFC)";
constexpr const char* kInvisible = "it is a control that shows nothing: delete it";
constexpr const char* kPrivate = "its look is not defined by Unicode";
constexpr const char* kAbove = "these screens draw no characters above U+FFFF, such as emoji";

struct Range {
  char32_t first;
  char32_t last;
  const char* problem;
};

// Blocks of Unicode 15 up to U+FFFF.
constexpr std::array kRanges = {
    Range{0x0000, 0x001f, kInvisible}, Range{0x007f, 0x009f, kInvisible}, Range{0x00ad, 0x00ad, kInvisible},
    Range{0x0300, 0x036f, kCombining}, Range{0x0483, 0x0489, kCombining}, Range{0x0591, 0x05bd, kCombining},
    Range{0x05bf, 0x05bf, kCombining}, Range{0x05c1, 0x05c2, kCombining}, Range{0x05c4, 0x05c5, kCombining},
    Range{0x05c7, 0x05c7, kCombining}, Range{0x0600, 0x0605, kInvisible}, Range{0x0610, 0x061a, kCombining},
    Range{0x061c, 0x061c, kInvisible}, Range{0x064b, 0x065f, kCombining}, Range{0x0670, 0x0670, kCombining},
    Range{0x06d6, 0x06ed, kCombining}, Range{0x0700, 0x08ff, kShaped},    Range{0x0900, 0x0fff, kShaped},
    Range{0x1000, 0x109f, kShaped},    Range{0x1100, 0x11ff, kShaped},    Range{0x135d, 0x135f, kCombining},
    Range{0x1700, 0x18af, kShaped},    Range{0x1900, 0x1cff, kShaped},    Range{0x1ab0, 0x1aff, kCombining},
    Range{0x1dc0, 0x1dff, kCombining}, Range{0x200b, 0x200f, kInvisible}, Range{0x2028, 0x202e, kInvisible},
    Range{0x2060, 0x206f, kInvisible}, Range{0x20d0, 0x20ff, kCombining}, Range{0x2de0, 0x2dff, kCombining},
    Range{0x302a, 0x302f, kCombining}, Range{0x3099, 0x309a, kCombining}, Range{0xa66f, 0xa67d, kCombining},
    Range{0xa800, 0xaaff, kShaped},    Range{0xabc0, 0xabff, kShaped},    Range{0xd7b0, 0xd7ff, kShaped},
    Range{0xe000, 0xf8ff, kPrivate},   Range{0xfb1e, 0xfb1e, kCombining}, Range{0xfe00, 0xfe0f, kInvisible},
    Range{0xfe20, 0xfe2f, kCombining}, Range{0xfeff, 0xfeff, kInvisible}, Range{0xfff0, 0xfffb, kInvisible}};

void append(std::string& utf8, char32_t character) {
  const auto part = [&](unsigned shift, unsigned lead) {
    utf8 += static_cast<char>(lead | (lead == 0x80 ? character >> shift & 0x3fU : character >> shift));
  };
  if (character < 0x80) {
    part(0, 0);
  } else if (character < 0x800) {
    part(6, 0xc0);
    part(0, 0x80);
  } else if (character < 0x10000) {
    part(12, 0xe0);
    part(6, 0x80);
    part(0, 0x80);
  } else {
    part(18, 0xf0);
    part(12, 0x80);
    part(6, 0x80);
    part(0, 0x80);
  }
}

/// How many bytes of 10xxxxxx follow this one; -1 where it begins no character.
int continuationsOf(unsigned char lead) {
  return lead < 0x80                   ? 0
         : lead >= 0xc2 && lead < 0xe0 ? 1
         : lead >= 0xe0 && lead < 0xf0 ? 2
         : lead >= 0xf0 && lead < 0xf5 ? 3
                                       : -1;
}

}  // namespace

std::string utf8Of(std::u32string_view characters) {
  std::string utf8;
  for (const char32_t character : characters) {
    append(utf8, character);
  }
  return utf8;
}

std::u32string charactersOf(std::string_view utf8) {
  std::u32string characters;
  for (size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i++]);
    const int count = continuationsOf(lead);
    char32_t character = count <= 0 ? lead : lead & (0x3fU >> count);
    bool whole = count >= 0;
    for (int k = 0; whole && k < count; ++k) {
      whole = i < utf8.size() && (static_cast<unsigned char>(utf8[i]) & 0xc0U) == 0x80;
      character = whole ? character << 6U | (static_cast<unsigned char>(utf8[i++]) & 0x3fU) : character;
    }
    characters += whole ? character : kReplacement;
  }
  return characters;
}

std::set<char32_t> glyphsOf(std::string_view utf8) {
  std::set<char32_t> glyphs;
  for (const char32_t character : charactersOf(utf8)) {
    if (character != U'\n' && character != U'\t') {
      glyphs.insert(character);
    }
  }
  return glyphs;
}

std::optional<std::string> scriptProblem(char32_t character) {
  if (character > 0xffff) {
    return kAbove;
  }
  const auto* const range = std::ranges::find_if(
      kRanges, [&](const Range& each) { return character >= each.first && character <= each.last; });
  return range == kRanges.end() ? std::nullopt : std::optional<std::string>(range->problem);
}

std::vector<UndrawableCharacters> undrawableOf(const std::set<char32_t>& characters) {
  std::vector<UndrawableCharacters> found;
  const auto add = [&](char32_t character, const std::string& reason) {
    const auto known = std::ranges::find(found, reason, &UndrawableCharacters::reason);
    (known == found.end() ? found.emplace_back(UndrawableCharacters{{}, reason}) : *known).characters += character;
  };
  std::set<char32_t> plain;
  for (const char32_t character : characters) {
    if (const std::optional<std::string> problem = scriptProblem(character)) {
      add(character, *problem);
    } else {
      plain.insert(character);
    }
  }
  std::set<char32_t> missing;
  for (const FontWeight weight : {FontWeight::kRegular, FontWeight::kBold}) {
    const FontCover cover = coverWithFonts(weight, plain);
    missing.insert(cover.missing.begin(), cover.missing.end());
    if (cover.shares.empty()) {
      // Dear ImGui's own font is drawn with then.
      std::erase_if(missing, [](char32_t character) { return character <= 0xff; });
    }
  }
  for (const char32_t character : missing) {
    add(character, "no font that is installed has it");
  }
  return found;
}

std::string namesOf(const std::u32string& characters) {
  constexpr size_t kMaxNames = 12;
  std::string names;
  for (const char32_t character : characters.substr(0, kMaxNames)) {
    names += fmt::format("{}U+{:04X}", names.empty() ? "" : ", ", static_cast<uint32_t>(character));
    const std::optional<std::string> problem = scriptProblem(character);
    // Those would be shown wrongly here too, or show nothing.
    if (!problem || (*problem != kInvisible && *problem != kCombining && *problem != kPrivate)) {
      names += ' ';
      append(names, character);
    }
  }
  return characters.size() > kMaxNames ? fmt::format("{} and {} more", names, characters.size() - kMaxNames) : names;
}

}  // namespace ocelli
