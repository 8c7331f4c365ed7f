// How a study looks: colours, sizes of text, and lengths that grow with the screen.
//
// A calm dark theme, so that nothing outshines the scene. Colours that mean something are those of M. Okabe and K. Ito,
// and never stand alone: a shape or a word says the same.
#pragma once

#include <array>

#include "oc_core/window/gui_style.h"

namespace ocelli {

inline constexpr GuiColor kStudyBackground{22, 24, 28};
inline constexpr GuiColor kStudyCard{33, 36, 42};  ///< behind what belongs together
inline constexpr GuiColor kStudyField{47, 51, 59};
inline constexpr GuiColor kStudyFieldHovered{58, 63, 73};
inline constexpr GuiColor kStudyLine{92, 98, 110};
inline constexpr GuiColor kStudyText{238, 239, 241};
inline constexpr GuiColor kStudyTextDim{184, 189, 197};
inline constexpr GuiColor kStudyAccent = kOkabeItoSkyBlue;
inline constexpr GuiColor kStudyAccentDeep{24, 72, 102};  ///< what is chosen, behind light text
inline constexpr GuiColor kStudyInk{12, 16, 20};          ///< text on the accent and on what is good or bad
inline constexpr GuiColor kStudyGood = kOkabeItoBluishGreen;
inline constexpr GuiColor kStudyBad = kOkabeItoOrange;

/// Of WCAG 2.1: 1 for the same colour, 21 for black on white.
double contrastRatio(GuiColor one, GuiColor other);
/// What text must have (level AA).
inline constexpr double kMinContrast = 4.5;

enum class StudyText { kSmall, kBody, kStrong, kTitle };
inline constexpr std::array<StudyText, 4> kStudyTexts{StudyText::kSmall, StudyText::kBody, StudyText::kStrong,
                                                      StudyText::kTitle};

class StudyLook {
 public:
  /// For a screen of so many pixels.
  StudyLook(int width, int height);

  /// Pixels for a length that is meant for a screen of 1280 x 800.
  double length(double at1280x800) const { return unit_ * at1280x800; }
  /// From the top of the tallest letters to the bottom of the lowest: 1.16 of what is called the size of a font.
  double textPixels(StudyText text) const;

  /// A font of 18 pixels.
  static constexpr double kMinTextPixels = 21;

 private:
  double unit_;
};

}  // namespace ocelli
