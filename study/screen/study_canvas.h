// What the screens of a study are drawn with: texts, shapes and places that react to the mouse, in pixels of the
// screen. It notes where each line of text stands and on what, so that a test can tell whether all of it can be read.
//
// Screens in a language that is written from the right to the left are laid out as all others are, and drawn mirrored:
// what is said to be at the left is drawn at the right, by the canvas alone. Images, maps and signs keep their shape.
#pragma once

#include <glm/vec2.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "oc_core/window/gui_layer.h"
#include "study/outline/subject_texts.h"
#include "study/screen/study_look.h"
#include "study/task/pixel_rect.h"

struct ImDrawList;

namespace ocelli {

/// A line of text that was drawn.
struct TextBox {
  PixelRect place;
  double pixels = 0;  ///< as StudyLook::textPixels()
  GuiColor color;
  GuiColor background;  ///< what it is drawn on
  std::string text;
};

/// Mirrored, left is right.
enum class TextAlign { kLeft, kCenter, kRight };

/// How text is written.
struct Ink {
  StudyText text = StudyText::kBody;
  GuiColor color = kStudyText;
  GuiColor background = kStudyBackground;
  TextAlign align = TextAlign::kLeft;
};

/// What the mouse does to a place.
struct Touch {
  bool hovered = false;
  bool held = false;
  bool clicked = false;
  double share = 0;  ///< of the place, from its left, where the mouse is
};

class StudyCanvas {
 public:
  /// A screen of so many pixels, for texts of these characters besides those of Europe and of the catalogue. Throws
  /// GlError.
  StudyCanvas(GlContext& context, int width, int height, const std::set<char32_t>& characters = {},
              const SubjectTexts& texts = SubjectTexts());

  int width() const { return width_; }
  int height() const { return height_; }
  const StudyLook& look() const { return look_; }
  double length(double at1280x800) const { return look_.length(at1280x800); }
  const SubjectTexts& texts() const { return texts_; }

  /// Whether what follows is drawn mirrored; at first it is where the language says so. Returns what it was before.
  bool setMirrored(bool mirrored);
  /// Where something is on the screen that is drawn there: both ways.
  PixelRect onScreen(const PixelRect& place) const;
  glm::dvec2 onScreen(const glm::dvec2& point) const;

  /// The mouse. Other events are not for what is drawn here.
  void handle(const InputEvent& event);
  bool hasWaitingEvents() const { return gui_.hasWaitingEvents(); }
  void begin(double secondsSinceLast);
  /// Into the bound framebuffer. Hold a GlScope. Throws GlError.
  void end();

  // Between begin() and end().
  double lineHeight(StudyText text) const;
  double widthOf(const std::string& text, StudyText style) const;
  /// One line. `at` is its top left, middle of the top, or top right, as aligned. Returns its right end.
  double writeLine(const Ink& ink, const glm::dvec2& at, const std::string& text);
  /// As many lines as it takes, in a column of this width. Returns the lower end.
  double write(const Ink& ink, const PixelRect& column, const std::string& text);
  double heightOf(const std::string& text, StudyText style, double width) const;

  /// Whether a text is shown as it is written.
  bool canShow(const std::string& text) const;

  void fill(const PixelRect& place, GuiColor color, double rounding = 0);
  void outline(const PixelRect& place, GuiColor color, double thickness, double rounding = 0);
  void line(std::span<const glm::dvec2> points, GuiColor color, double thickness);
  void disc(const glm::dvec2& center, double radius, GuiColor color);
  void ring(const glm::dvec2& center, double radius, GuiColor color, double thickness);
  /// A part of a ring, clockwise from the top, shares of the whole.
  void arc(const glm::dvec2& center, double radius, double share, GuiColor color, double thickness);
  void triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, GuiColor color);
  /// Row 0 of the texture is the top.
  void image(const GlObject& texture, const PixelRect& place);

  /// What is drawn until endClip() is cut off at the borders of `place`; lines of text that are cut are left out.
  void beginClip(const PixelRect& place);
  void endClip();

  /// Of the part of the place that the clip leaves, where there is one.
  Touch touch(const std::string& name, const PixelRect& place);
  /// Steps of the wheel since the last frame, up is positive.
  double wheel() const;

  const std::vector<TextBox>& textBoxes() const { return textBoxes_; }

 private:
  ImFont* fontOf(StudyText text) const;
  double widthOf(const std::u32string& text, StudyText style) const;
  /// Cut where a line would be wider, and at newlines; each as it stands on the screen.
  std::vector<std::u32string> lines(const std::string& text, StudyText style, double width) const;
  double drawLine(const Ink& ink, const glm::dvec2& at, const std::u32string& visual);

  int width_;
  int height_;
  StudyLook look_;
  SubjectTexts texts_;
  bool mirrored_ = false;
  GuiLayer gui_;
  ImDrawList* list_ = nullptr;
  std::vector<PixelRect> clips_;
  std::vector<TextBox> textBoxes_;
};

/// Draws mirrored or not until it ends.
class MirrorScope {
 public:
  MirrorScope(StudyCanvas& canvas, bool mirrored) : canvas_(canvas), before_(canvas.setMirrored(mirrored)) {}
  ~MirrorScope() { canvas_.setMirrored(before_); }
  MirrorScope(const MirrorScope&) = delete;
  MirrorScope& operator=(const MirrorScope&) = delete;

 private:
  StudyCanvas& canvas_;
  bool before_;
};

}  // namespace ocelli
