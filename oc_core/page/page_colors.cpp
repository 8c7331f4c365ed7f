#include "oc_core/page/page_colors.h"

#include <fmt/format.h>

namespace ocelli {
namespace {

// As printed papers have them: Helvetica, Palatino, or what stands for them on this machine.
constexpr std::string_view kFonts = R"css(
  --serif: Charter, "Bitstream Charter", "Palatino Linotype", Palatino, P052, Georgia, "DejaVu Serif", serif;
  --sans: Helvetica, "Nimbus Sans", "Liberation Sans", Arial, system-ui, "DejaVu Sans", sans-serif;
  --mono: ui-monospace, "DejaVu Sans Mono", monospace;
)css";

std::string rootStyle(std::string_view scheme, uint32_t PageColor::*value, std::string_view more) {
  std::string style = fmt::format(":root {{\n  color-scheme: {};", scheme);
  for (const PageColor& color : page_color::kAll) {
    style +=
        fmt::format("{}--{}: #{:06x};", &color == page_color::kAll.data() ? "\n  " : " ", color.name, color.*value);
  }
  return style + fmt::format("{}}}\n", more.empty() ? "\n" : more);
}

}  // namespace

std::string pageColorsStyle(PageScheme scheme) {
  const bool follows = scheme == PageScheme::kFollowsScreen;
  std::string style = scheme == PageScheme::kDark
                          ? rootStyle("dark", &PageColor::dark, kFonts)
                          : rootStyle(follows ? "light dark" : "light", &PageColor::light, kFonts);
  if (follows) {
    style += fmt::format("@media (prefers-color-scheme: dark) {{\n{}}}\n@media print {{\n{}}}\n",
                         rootStyle("dark", &PageColor::dark, ""), rootStyle("light", &PageColor::print, ""));
  }
  return style + "* { box-sizing: border-box; }\ncode { font-family: var(--mono); overflow-wrap: anywhere; }\n";
}

}  // namespace ocelli
