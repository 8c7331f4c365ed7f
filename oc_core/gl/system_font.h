// The sans-serif font of this system, found through fontconfig.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

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

}  // namespace ocelli
