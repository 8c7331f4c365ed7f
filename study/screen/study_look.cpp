#include "study/screen/study_look.h"

#include <algorithm>
#include <cmath>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

double luminance(GuiColor color) {
  return 0.2126 * static_cast<double>(linearFromSrgbByte(color.red)) +
         0.7152 * static_cast<double>(linearFromSrgbByte(color.green)) +
         0.0722 * static_cast<double>(linearFromSrgbByte(color.blue));
}

double pixelsAt1280x800(StudyText text) {
  switch (text) {
    case StudyText::kSmall:
      return 21;
    case StudyText::kBody:
    case StudyText::kStrong:
      return 24;
    case StudyText::kTitle:
      return 42;
  }
  return 0;
}

}  // namespace

double contrastRatio(GuiColor one, GuiColor other) {
  const double a = luminance(one) + 0.05;
  const double b = luminance(other) + 0.05;
  return std::max(a, b) / std::min(a, b);
}

StudyLook::StudyLook(int width, int height) : unit_(std::min(width / 1280.0, height / 800.0)) {}

double StudyLook::textPixels(StudyText text) const {
  return std::round(std::max(kMinTextPixels, unit_ * pixelsAt1280x800(text)));
}

}  // namespace ocelli
