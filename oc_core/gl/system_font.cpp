#include "oc_core/gl/system_font.h"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace ocelli {
namespace {

using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;
using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;

std::string text(const FcPattern& pattern, const char* field) {
  FcChar8* value = nullptr;
  return FcPatternGetString(&pattern, field, 0, &value) == FcResultMatch ? reinterpret_cast<const char*>(value) : "";
}

}  // namespace

std::optional<SystemFont> findSystemFont(FontWeight weight) {
  // A configuration of our own: fontconfig's shared one would stay behind.
  const Config config(FcInitLoadConfigAndFonts(), FcConfigDestroy);
  const Pattern wanted(FcPatternCreate(), FcPatternDestroy);
  if (!config || !wanted) {
    return std::nullopt;
  }
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight == FontWeight::kBold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse);
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(config.get(), wanted.get(), &result), FcPatternDestroy);
  FcBool scalable = FcFalse;
  if (!found || FcPatternGetBool(found.get(), FC_SCALABLE, 0, &scalable) != FcResultMatch || scalable == FcFalse) {
    return std::nullopt;
  }
  SystemFont font{text(*found, FC_FILE), 0, text(*found, FC_FAMILY)};
  FcPatternGetInteger(found.get(), FC_INDEX, 0, &font.index);
  return font.file.empty() ? std::nullopt : std::optional(font);
}

}  // namespace ocelli
