// The fonts of figures and pages, and how wide text is in them. They are what the system has for the families of a
// printed paper; a character that a family lacks is taken from the system's own sans-serif.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

enum class Face { kSans, kSansBold, kSerif, kSerifBold, kSerifItalic, kMono };

/// A piece of text in one font.
struct TextRun {
  std::string text;
  bool substitute = false;  ///< in the system's sans-serif instead of the face's own family
  double width = 0;         ///< at the size that was asked for
};

/// Of clean text (utf8.h), in the unit of `size`. There is no kerning: widths of characters add up.
double textWidth(std::string_view text, Face face, double size);
std::vector<TextRun> textRuns(std::string_view text, Face face, double size);

/// From the baseline up and down, of a usual line.
double ascentOf(double size);
double descentOf(double size);

/// Greedy: as many words on a line as fit. A word wider than a line is broken where it must be; newlines are kept.
std::vector<std::string> brokenLines(std::string_view text, Face face, double size, double width);

/// The text, or its start and an ellipsis.
std::string shortened(std::string_view text, Face face, double size, double width);

/// What Cairo is asked for.
const char* familyOf(Face face);
bool isBold(Face face);
bool isItalic(Face face);
inline constexpr const char* kSubstituteFamily = "sans-serif";

}  // namespace ocelli
