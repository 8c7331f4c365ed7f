// Lets fontconfig find the fonts of one folder alone, for tests of what is not installed.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "oc_core/window/system_font.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {

/// The folder of the font that texts are drawn in; the others lie elsewhere.
inline std::filesystem::path ownFontFolder() {
  const auto font = findSystemFont();
  return font ? font->file.parent_path() : std::filesystem::path();
}

class FontsOf {
 public:
  /// An empty path: no fonts at all.
  explicit FontsOf(const std::filesystem::path& fonts) {
    const std::string list = fonts.empty() ? "" : "<dir>" + fonts.string() + "</dir>";
    const auto file = folder_.write("fonts.conf", "<?xml version=\"1.0\"?><fontconfig>" + list + "<cachedir>" +
                                                      (folder_ / "cache").string() + "</cachedir></fontconfig>");
    setenv("FONTCONFIG_FILE", file.c_str(), 1);
  }
  ~FontsOf() { unsetenv("FONTCONFIG_FILE"); }
  FontsOf(const FontsOf&) = delete;
  FontsOf& operator=(const FontsOf&) = delete;

 private:
  TemporaryFolder folder_;
};

}  // namespace ocelli::test
