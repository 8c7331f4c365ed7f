// The colours of all pages, figures and plans, in one place: sRGB, as 0xRRGGBB. A page gets them as custom properties
// ("--text"), a drawing as paints (oc_core/drawing/drawing.h).
//
//   Okabe and Ito 2008      Color Universal Design: colours that colour-blind people tell apart
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ocelli {

struct PageColor {
  std::string_view name;
  uint32_t light = 0;  ///< on light screens; of figures and plans, which are light everywhere
  uint32_t dark = 0;   ///< on dark screens
  uint32_t print = 0;
};

namespace page_color {

// Grounds.
inline constexpr PageColor kGround{"ground", 0xfbfaf7, 0x14171a, 0xffffff};
inline constexpr PageColor kCard{"card", 0xffffff, 0x1d2125, 0xffffff};
inline constexpr PageColor kTint{"tint", 0xe7f1f8, 0x20394c, 0xe4eef5};  ///< of what stands out

// Text keeps a contrast of at least 4.5 : 1 to all grounds.
inline constexpr PageColor kText{"text", 0x1c2126, 0xe8eaec, 0x000000};
inline constexpr PageColor kSoft{"soft", 0x56606b, 0xa7b0b9, 0x444444};
inline constexpr PageColor kAccent{"accent", 0x00558c, 0x7cc4f5, 0x00558c};
inline constexpr PageColor kCaution{"caution", 0x8f3e00, 0xf0a070, 0x8f3e00};

// Lines.
inline constexpr PageColor kLine{"line", 0xd9d9d2, 0x363c43, 0x999999};
inline constexpr PageColor kGrid{"grid", 0xe5e5e0, 0x2b3036, 0xdddddd};

// Series: after Okabe and Ito, dark enough for lines on the light grounds and without their yellow.
inline constexpr PageColor kBlue{"blue", 0x0072b2, 0x4aa3df, 0x0072b2};
inline constexpr PageColor kVermilion{"vermilion", 0xd55e00, 0xf0803a, 0xd55e00};
inline constexpr PageColor kGreen{"green", 0x00785a, 0x2fbd94, 0x00785a};
inline constexpr PageColor kPurple{"purple", 0xa8487f, 0xdf9dc0, 0xa8487f};
inline constexpr PageColor kOchre{"ochre", 0xa86f00, 0xe6a93c, 0xa86f00};
inline constexpr PageColor kSky{"sky", 0x2b83b8, 0x8fcdf2, 0x2b83b8};

inline constexpr std::array<PageColor, 15> kAll{kGround, kCard, kTint,      kText,  kSoft,   kAccent, kCaution, kLine,
                                                kGrid,   kBlue, kVermilion, kGreen, kPurple, kOchre,  kSky};

}  // namespace page_color

/// The style that defines the colours and the fonts (--sans, --serif, --mono): of a page that is light everywhere, dark
/// everywhere, or follows the screen and the printer.
enum class PageScheme { kLight, kDark, kFollowsScreen };
std::string pageColorsStyle(PageScheme scheme);

}  // namespace ocelli
