// How panels look: a calm dark theme with one accent colour, and colours that mean the same to colour-blind people.
#pragma once

#include <array>
#include <cstdint>

namespace ocelli {

/// An opaque colour, sRGB.
struct GuiColor {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;

  bool operator==(const GuiColor&) const = default;
  /// As the drawing functions of Dear ImGui take it (ImU32).
  constexpr uint32_t packed(uint8_t alpha = 255) const {
    return red | static_cast<uint32_t>(green) << 8U | static_cast<uint32_t>(blue) << 16U |
           static_cast<uint32_t>(alpha) << 24U;
  }
  /// Red, green and blue, from 0 to 1 (sRGB).
  constexpr std::array<float, 3> floats() const {
    return {static_cast<float>(red) / 255, static_cast<float>(green) / 255, static_cast<float>(blue) / 255};
  }
};

/// The theme. Text on each of the backgrounds has a contrast of at least 4.5 (WCAG 2.1, level AA).
inline constexpr GuiColor kGuiText{230, 231, 233};
inline constexpr GuiColor kGuiTextDim{168, 172, 178};
inline constexpr GuiColor kGuiBackground{20, 21, 23};  ///< behind the panels
inline constexpr GuiColor kGuiPanel{30, 31, 34};
inline constexpr GuiColor kGuiField{44, 46, 50};
inline constexpr GuiColor kGuiFieldHovered{54, 57, 62};
inline constexpr GuiColor kGuiFieldActive{64, 67, 73};
inline constexpr GuiColor kGuiBorder{68, 71, 77};
inline constexpr GuiColor kGuiAccent{86, 180, 233};
inline constexpr GuiColor kGuiAccentDeep{31, 78, 107};  ///< what is chosen, behind text

/// The palette of M. Okabe and K. Ito, Color Universal Design (2008): told apart by people with any colour vision.
inline constexpr GuiColor kOkabeItoBlack{0, 0, 0};
inline constexpr GuiColor kOkabeItoOrange{230, 159, 0};
inline constexpr GuiColor kOkabeItoSkyBlue{86, 180, 233};
inline constexpr GuiColor kOkabeItoBluishGreen{0, 158, 115};
inline constexpr GuiColor kOkabeItoYellow{240, 228, 66};
inline constexpr GuiColor kOkabeItoBlue{0, 114, 178};
inline constexpr GuiColor kOkabeItoVermillion{213, 94, 0};
inline constexpr GuiColor kOkabeItoReddishPurple{204, 121, 167};

/// Those that are seen well on the dark panels, for lines and dots of different kinds.
inline constexpr std::array<GuiColor, 6> kGuiSeries{kOkabeItoOrange, kOkabeItoSkyBlue,    kOkabeItoBluishGreen,
                                                    kOkabeItoYellow, kOkabeItoVermillion, kOkabeItoReddishPurple};

/// Size of text at a scale of 1.
inline constexpr double kGuiTextPixels = 15;

/// Gives the current context of Dear ImGui this look, its lengths times `scale`.
void applyGuiStyle(double scale);

}  // namespace ocelli
