// The sans-serif font of this system, and fonts for characters that it lacks, found through fontconfig. Needs no
// OpenGL.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ocelli {

struct SystemFont {
  std::filesystem::path file;
  int index = 0;     ///< of the face, in files that hold several
  std::string name;  ///< "DejaVu Sans"
};

enum class FontWeight { kRegular, kBold };

/// A font with outlines, so that it can be drawn in any size. Where there is none of that weight, the one that
/// comes closest; nothing where none is installed.
std::optional<SystemFont> findSystemFont(FontWeight weight = FontWeight::kRegular);

/// A font, and which of some characters it is to draw, in their order.
struct FontShare {
  SystemFont font;
  std::u32string characters;
};

struct FontCover {
  std::vector<FontShare> shares;  ///< the first is of findSystemFont(), also where it has none of them
  std::u32string missing;         ///< characters that no font has
};

/// Which installed fonts draw these characters: as many as possible by the first, the others by those that fontconfig
/// holds for the most similar. All have outlines of one colour. Where no font is installed, all are missing.
FontCover coverWithFonts(FontWeight weight, const std::set<char32_t>& characters);

}  // namespace ocelli
