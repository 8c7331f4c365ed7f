#include "oc_core/window/system_font.h"

#include <fontconfig/fontconfig.h>

#include <array>
#include <memory>
#include <string_view>
#include <utility>

namespace ocelli {
namespace {

using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;
using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;

std::string text(const FcPattern& pattern, const char* field) {
  FcChar8* value = nullptr;
  return FcPatternGetString(&pattern, field, 0, &value) == FcResultMatch ? reinterpret_cast<const char*>(value) : "";
}

/// What to look for; nullptr where fontconfig does not work.
Pattern wantedFont(FcConfig* config, FontWeight weight) {
  Pattern wanted(FcPatternCreate(), FcPatternDestroy);
  if (config == nullptr || !wanted) {
    return {nullptr, FcPatternDestroy};
  }
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight == FontWeight::kBold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse);
  FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  return wanted;
}

bool holds(const FcPattern& pattern, const char* field, bool value, bool otherwise) {
  FcBool found = FcFalse;
  return (FcPatternGetBool(&pattern, field, 0, &found) == FcResultMatch ? found != FcFalse : otherwise) == value;
}

/// Whether Dear ImGui reads it: outlines of one colour, in a format that it knows.
bool canBeUsed(const FcPattern& pattern) {
  constexpr std::array<std::string_view, 2> kFormats = {"TrueType", "CFF"};
  const std::string format = text(pattern, FC_FONTFORMAT);
  return holds(pattern, FC_SCALABLE, true, false) && holds(pattern, FC_OUTLINE, true, true) &&
         holds(pattern, FC_COLOR, false, false) && (format == kFormats[0] || format == kFormats[1]);
}

std::optional<SystemFont> fontOf(const FcPattern& pattern) {
  SystemFont font{text(pattern, FC_FILE), 0, text(pattern, FC_FAMILY)};
  FcPatternGetInteger(&pattern, FC_INDEX, 0, &font.index);
  return font.file.empty() ? std::nullopt : std::optional(font);
}

Pattern matched(FcConfig* config, FontWeight weight) {
  const Pattern wanted = wantedFont(config, weight);
  FcResult result = FcResultNoMatch;
  return {wanted ? FcFontMatch(config, wanted.get(), &result) : nullptr, FcPatternDestroy};
}

/// Moves what the font has from `missing` to a share of it.
FontShare shareOf(const FcPattern& pattern, const SystemFont& font, std::u32string& missing) {
  FontShare share{font, {}};
  FcCharSet* has = nullptr;
  if (FcPatternGetCharSet(&pattern, FC_CHARSET, 0, &has) == FcResultMatch) {
    std::u32string left;
    for (const char32_t character : missing) {
      (FcCharSetHasChar(has, character) != FcFalse ? share.characters : left) += character;
    }
    missing = std::move(left);
  }
  return share;
}

}  // namespace

std::optional<SystemFont> findSystemFont(FontWeight weight) {
  // A configuration of our own: fontconfig's shared one would stay behind.
  const Config config(FcInitLoadConfigAndFonts(), FcConfigDestroy);
  const Pattern found = matched(config.get(), weight);
  return found && canBeUsed(*found) ? fontOf(*found) : std::nullopt;
}

FontCover coverWithFonts(FontWeight weight, const std::set<char32_t>& characters) {
  FontCover cover;
  cover.missing.assign(characters.begin(), characters.end());
  const Config config(FcInitLoadConfigAndFonts(), FcConfigDestroy);
  const Pattern first = matched(config.get(), weight);
  const std::optional<SystemFont> own = first && canBeUsed(*first) ? fontOf(*first) : std::nullopt;
  if (!own) {
    return cover;
  }
  cover.shares.push_back(shareOf(*first, *own, cover.missing));
  if (cover.missing.empty()) {
    return cover;
  }
  const Pattern wanted = wantedFont(config.get(), weight);
  FcResult result = FcResultNoMatch;
  const std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)> others(
      FcFontSort(config.get(), wanted.get(), FcFalse, nullptr, &result), FcFontSetDestroy);
  for (int i = 0; others && i < others->nfont && !cover.missing.empty(); ++i) {
    const FcPattern& other = *others->fonts[i];
    const std::optional<SystemFont> font = canBeUsed(other) ? fontOf(other) : std::nullopt;
    if (!font) {
      continue;
    }
    FontShare share = shareOf(other, *font, cover.missing);
    if (!share.characters.empty()) {
      cover.shares.push_back(std::move(share));
    }
  }
  return cover;
}

}  // namespace ocelli
