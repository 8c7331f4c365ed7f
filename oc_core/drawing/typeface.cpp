#include "oc_core/drawing/typeface.h"

#include <cairo.h>

#include <array>
#include <memory>
#include <utility>

#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr size_t kFaces = 6;
constexpr size_t kAscii = 128;
// Widths are measured at this size, where the fonts' own units are whole to three digits and more.
constexpr double kMeasuredSize = 1000;

struct DestroyFont {
  void operator()(cairo_scaled_font_t* font) const { cairo_scaled_font_destroy(font); }
};
using ScaledFont = std::unique_ptr<cairo_scaled_font_t, DestroyFont>;

ScaledFont scaledFont(const char* family, bool bold, bool italic) {
  cairo_font_face_t* face =
      cairo_toy_font_face_create(family, italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                                 bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_matrix_t size;
  cairo_matrix_init_scale(&size, kMeasuredSize, kMeasuredSize);
  cairo_matrix_t identity;
  cairo_matrix_init_identity(&identity);
  ScaledFont font(cairo_scaled_font_create(face, &size, &identity, options));
  cairo_font_options_destroy(options);
  cairo_font_face_destroy(face);
  return font;
}

struct Advance {
  double width;  ///< at size 1
  bool has;      ///< whether the font has this character
};

class MeasuredFont {
 public:
  MeasuredFont(const char* family, bool bold, bool italic) : font_(scaledFont(family, bold, italic)) {
    for (size_t code = 0; code < kAscii; ++code) {
      ascii_[code] = measure(static_cast<char32_t>(code));
    }
  }
  Advance advance(char32_t code) const { return code < kAscii ? ascii_[code] : measure(code); }

 private:
  Advance measure(char32_t code) const {
    if (code < 0x20) {
      return {0, true};
    }
    const std::string text = utf8FromCodePoint(code);
    cairo_glyph_t* glyphs = nullptr;
    int count = 0;
    const cairo_status_t status = cairo_scaled_font_text_to_glyphs(
        font_.get(), 0, 0, text.c_str(), static_cast<int>(text.size()), &glyphs, &count, nullptr, nullptr, nullptr);
    if (status != CAIRO_STATUS_SUCCESS) {
      return {0, false};
    }
    const bool has = count > 0 && glyphs[0].index != 0;
    cairo_text_extents_t extents;
    cairo_scaled_font_glyph_extents(font_.get(), glyphs, count, &extents);
    cairo_glyph_free(glyphs);
    return {extents.x_advance / kMeasuredSize, has};
  }

  ScaledFont font_;
  std::array<Advance, kAscii> ascii_{};
};

const MeasuredFont& fontOf(Face face) {
  static const std::array<MeasuredFont, kFaces> kFonts{
      MeasuredFont(familyOf(Face::kSans), false, false),       MeasuredFont(familyOf(Face::kSansBold), true, false),
      MeasuredFont(familyOf(Face::kSerif), false, false),      MeasuredFont(familyOf(Face::kSerifBold), true, false),
      MeasuredFont(familyOf(Face::kSerifItalic), false, true), MeasuredFont(familyOf(Face::kMono), false, false)};
  return kFonts[static_cast<size_t>(face)];
}

const MeasuredFont& substituteOf(Face face) {
  static const std::array<MeasuredFont, 2> kFonts{MeasuredFont(kSubstituteFamily, false, false),
                                                  MeasuredFont(kSubstituteFamily, true, false)};
  return kFonts[isBold(face) ? 1 : 0];
}

struct Character {
  double width;  ///< at size 1
  bool substitute;
};

Character characterOf(char32_t code, Face face) {
  const Advance own = fontOf(face).advance(code);
  if (own.has) {
    return {own.width, false};
  }
  return {substituteOf(face).advance(code).width, true};
}

}  // namespace

const char* familyOf(Face face) {
  switch (face) {
    case Face::kSans:
    case Face::kSansBold:
      return "Helvetica";
    case Face::kSerif:
    case Face::kSerifBold:
    case Face::kSerifItalic:
      return "Palatino Linotype";
    case Face::kMono:
      return "Courier";
  }
  return kSubstituteFamily;
}

bool isBold(Face face) {
  return face == Face::kSansBold || face == Face::kSerifBold;
}

bool isItalic(Face face) {
  return face == Face::kSerifItalic;
}

double ascentOf(double size) {
  return 0.74 * size;
}

double descentOf(double size) {
  return 0.22 * size;
}

double textWidth(std::string_view text, Face face, double size) {
  double width = 0;
  for (const char32_t code : codePoints(text)) {
    width += characterOf(code, face).width;
  }
  return width * size;
}

std::vector<TextRun> textRuns(std::string_view text, Face face, double size) {
  std::vector<TextRun> runs;
  for (const char32_t code : codePoints(text)) {
    const Character character = characterOf(code, face);
    if (runs.empty() || runs.back().substitute != character.substitute) {
      runs.push_back({"", character.substitute, 0});
    }
    runs.back().text += utf8FromCodePoint(code);
    runs.back().width += character.width * size;
  }
  return runs;
}

std::vector<std::string> brokenLines(std::string_view text, Face face, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  std::string word;
  double lineWidth = 0;
  double wordWidth = 0;
  const double spaceWidth = textWidth(" ", face, size);
  const auto endLine = [&] {
    lines.push_back(std::exchange(line, ""));
    lineWidth = 0;
  };
  const auto endWord = [&] {
    if (!word.empty()) {
      if (!line.empty() && lineWidth + spaceWidth + wordWidth > width) {
        endLine();
      }
      lineWidth += (line.empty() ? 0 : spaceWidth) + wordWidth;
      if (!line.empty()) {
        line += ' ';
      }
      line += std::exchange(word, "");
      wordWidth = 0;
    }
  };
  for (const char32_t code : codePoints(text)) {
    if (code == ' ' || code == '\t' || code == '\n') {
      endWord();
      if (code == '\n') {
        endLine();
      }
      continue;
    }
    const double advance = characterOf(code, face).width * size;
    if (!word.empty() && wordWidth + advance > width) {
      endWord();
    }
    word += utf8FromCodePoint(code);
    wordWidth += advance;
  }
  endWord();
  if (!line.empty() || lines.empty()) {
    endLine();
  }
  return lines;
}

std::string shortened(std::string_view text, Face face, double size, double width) {
  if (textWidth(text, face, size) <= width) {
    return std::string(text);
  }
  const std::string ellipsis = "\u2026";
  double used = textWidth(ellipsis, face, size);
  std::string start;
  for (const char32_t code : codePoints(text)) {
    used += characterOf(code, face).width * size;
    if (used > width) {
      break;
    }
    start += utf8FromCodePoint(code);
  }
  return start + ellipsis;
}

}  // namespace ocelli
