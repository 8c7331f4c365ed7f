#include "study/screen/study_canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "oc_core/base/check.h"
#include "study/screen/bidi_text.h"
#include "study/screen/drawable_text.h"
#include "study/screen/text_wrapping.h"

namespace ocelli {
namespace {

constexpr double kLineSpacing = 1.25;  // of the height of letters

ImVec2 vec(const glm::dvec2& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}
ImVec2 topLeft(const PixelRect& rect) {
  return {static_cast<float>(rect.left), static_cast<float>(rect.top)};
}
ImVec2 bottomRight(const PixelRect& rect) {
  return {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())};
}

std::vector<GuiFont> fontsOf(const StudyLook& look) {
  std::vector<GuiFont> fonts;
  for (const StudyText text : kStudyTexts) {
    const bool bold = text == StudyText::kStrong || text == StudyText::kTitle;
    fonts.push_back({look.textPixels(text), bold ? FontWeight::kBold : FontWeight::kRegular});
  }
  return fonts;
}

/// Those, and all that the texts of a language are made of.
std::set<char32_t> drawable(std::set<char32_t> characters, const SubjectTexts& texts) {
  for (const auto& [id, text] : texts.catalogue().texts) {
    characters.merge(shapedGlyphsOf(text));
  }
  characters.merge(shapedAlphabet(texts.catalogue().letters));
  std::erase_if(characters, [](char32_t character) { return scriptProblem(character).has_value(); });
  return characters;
}

}  // namespace

StudyCanvas::StudyCanvas(GlContext& context, int width, int height, const std::set<char32_t>& characters,
                         const SubjectTexts& texts)
    : width_(width),
      height_(height),
      look_(width, height),
      texts_(texts),
      gui_(context, 1, fontsOf(look_), drawable(characters, texts)) {
  gui_.handle(ResizeEvent{width, height, 1, 1});
}

void StudyCanvas::handle(const InputEvent& event) {
  if (std::holds_alternative<PointerMoveEvent>(event) || std::holds_alternative<PointerButtonEvent>(event) ||
      std::holds_alternative<ScrollEvent>(event)) {
    gui_.handle(event);
  }
}

void StudyCanvas::begin(double secondsSinceLast) {
  gui_.beginFrame(secondsSinceLast);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(width_), static_cast<float>(height_)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("study", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  list_ = ImGui::GetWindowDrawList();
  textBoxes_.clear();
  mirrored_ = texts_.rightToLeft();
}

void StudyCanvas::end() {
  OC_CHECK(clips_.empty(), "every clip ends");
  ImGui::End();
  ImGui::PopStyleVar(2);
  list_ = nullptr;
  gui_.endFrame();
}

ImFont* StudyCanvas::fontOf(StudyText text) const {
  return gui_.font(static_cast<size_t>(text));
}

double StudyCanvas::lineHeight(StudyText text) const {
  return std::round(kLineSpacing * look_.textPixels(text));
}

bool StudyCanvas::setMirrored(bool mirrored) {
  return std::exchange(mirrored_, mirrored);
}

PixelRect StudyCanvas::onScreen(const PixelRect& place) const {
  return {mirrored_ ? width_ - place.right() : place.left, place.top, place.width, place.height};
}

glm::dvec2 StudyCanvas::onScreen(const glm::dvec2& point) const {
  return {mirrored_ ? width_ - point.x : point.x, point.y};
}

double StudyCanvas::widthOf(const std::u32string& text, StudyText style) const {
  const ImFont& font = *fontOf(style);
  double width = 0;
  for (const char32_t character : text) {
    width += static_cast<double>(font.GetCharAdvance(static_cast<ImWchar>(character)));
  }
  // Fonts have the size that they are drawn in.
  return width * look_.textPixels(style) / static_cast<double>(font.FontSize);
}

double StudyCanvas::widthOf(const std::string& text, StudyText style) const {
  return widthOf(BidiParagraph(text, texts_.rightToLeft()).characters(), style);
}

std::vector<std::u32string> StudyCanvas::lines(const std::string& text, StudyText style, double width) const {
  const BidiParagraph paragraph(text, texts_.rightToLeft());
  std::vector<std::u32string> lines;
  for (const auto& [from, to] : wrapLines(paragraph.characters(), width, [&](char32_t character) {
         return widthOf(std::u32string(1, character), style);
       })) {
    lines.push_back(paragraph.visual(from, to));
  }
  return lines;
}

double StudyCanvas::writeLine(const Ink& ink, const glm::dvec2& at, const std::string& text) {
  const BidiParagraph paragraph(text, texts_.rightToLeft());
  return drawLine(ink, at, paragraph.visual(0, paragraph.characters().size()));
}

double StudyCanvas::drawLine(const Ink& ink, const glm::dvec2& at, const std::u32string& visual) {
  const double pixels = look_.textPixels(ink.text);
  const double width = widthOf(visual, ink.text);
  const double shift = ink.align == TextAlign::kLeft ? 0 : (ink.align == TextAlign::kCenter ? width / 2 : width);
  const PixelRect meant{std::round(at.x - shift), std::round(at.y), width, pixels};
  if (!clips_.empty() && (meant.top < clips_.back().top || meant.bottom() > clips_.back().bottom())) {
    return meant.right();
  }
  PixelRect place = onScreen(meant);
  place.left = std::round(place.left);
  const std::string text = utf8Of(visual);
  list_->AddText(fontOf(ink.text), static_cast<float>(pixels), topLeft(place), ink.color.packed(), text.data(),
                 text.data() + text.size());
  if (!text.empty()) {
    textBoxes_.push_back({place, pixels, ink.color, ink.background, text});
  }
  return meant.right();
}

double StudyCanvas::write(const Ink& ink, const PixelRect& column, const std::string& text) {
  const double x = ink.align == TextAlign::kLeft
                       ? column.left
                       : (ink.align == TextAlign::kCenter ? column.center().x : column.right());
  double y = column.top;
  for (const std::u32string& one : lines(text, ink.text, column.width)) {
    drawLine(ink, {x, y}, one);
    y += lineHeight(ink.text);
  }
  return y;
}

bool StudyCanvas::canShow(const std::string& text) const {
  return std::ranges::all_of(shapedGlyphsOf(text),
                             [this](char32_t character) { return !scriptProblem(character) && gui_.holds(character); });
}

double StudyCanvas::heightOf(const std::string& text, StudyText style, double width) const {
  return static_cast<double>(lines(text, style, width).size()) * lineHeight(style);
}

void StudyCanvas::fill(const PixelRect& place, GuiColor color, double rounding) {
  list_->AddRectFilled(topLeft(onScreen(place)), bottomRight(onScreen(place)), color.packed(),
                       static_cast<float>(rounding));
}

void StudyCanvas::outline(const PixelRect& place, GuiColor color, double thickness, double rounding) {
  list_->AddRect(topLeft(onScreen(place)), bottomRight(onScreen(place)), color.packed(), static_cast<float>(rounding),
                 0, static_cast<float>(thickness));
}

void StudyCanvas::line(std::span<const glm::dvec2> points, GuiColor color, double thickness) {
  std::vector<ImVec2> path;
  for (const glm::dvec2& p : points) {
    path.push_back(vec(onScreen(p)));
  }
  list_->AddPolyline(path.data(), static_cast<int>(path.size()), color.packed(), 0, static_cast<float>(thickness));
}

void StudyCanvas::disc(const glm::dvec2& center, double radius, GuiColor color) {
  list_->AddCircleFilled(vec(onScreen(center)), static_cast<float>(radius), color.packed(), 48);
}

void StudyCanvas::ring(const glm::dvec2& center, double radius, GuiColor color, double thickness) {
  list_->AddCircle(vec(onScreen(center)), static_cast<float>(radius), color.packed(), 48,
                   static_cast<float>(thickness));
}

void StudyCanvas::arc(const glm::dvec2& center, double radius, double share, GuiColor color, double thickness) {
  constexpr double kTop = -std::numbers::pi / 2;
  list_->PathArcTo(vec(onScreen(center)), static_cast<float>(radius), static_cast<float>(kTop),
                   static_cast<float>(kTop + 2 * std::numbers::pi * std::clamp(share, 0.0, 1.0)), 64);
  list_->PathStroke(color.packed(), 0, static_cast<float>(thickness));
}

void StudyCanvas::triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, GuiColor color) {
  list_->AddTriangleFilled(vec(onScreen(a)), vec(onScreen(b)), vec(onScreen(c)), color.packed());
}

void StudyCanvas::image(const GlObject& texture, const PixelRect& place) {
  list_->AddImage(GuiLayer::imageOf(texture), topLeft(onScreen(place)), bottomRight(onScreen(place)));
}

void StudyCanvas::beginClip(const PixelRect& place) {
  clips_.push_back(place);
  list_->PushClipRect(topLeft(onScreen(place)), bottomRight(onScreen(place)), true);
}

void StudyCanvas::endClip() {
  clips_.pop_back();
  list_->PopClipRect();
}

Touch StudyCanvas::touch(const std::string& name, const PixelRect& place) {
  Touch touch;
  PixelRect shown = onScreen(place);
  if (!clips_.empty()) {
    // What is scrolled away must not take clicks from what stands there now.
    const double top = std::max(shown.top, clips_.back().top);
    shown.height = std::min(shown.bottom(), clips_.back().bottom()) - top;
    shown.top = top;
    if (shown.height < 1) {
      return touch;
    }
  }
  ImGui::SetCursorScreenPos(topLeft(shown));
  const ImVec2 size{static_cast<float>(std::max(shown.width, 1.0)), static_cast<float>(std::max(shown.height, 1.0))};
  touch.clicked = ImGui::InvisibleButton(name.c_str(), size);
  touch.hovered = ImGui::IsItemHovered();
  touch.held = ImGui::IsItemActive();
  const double mouse = onScreen(glm::dvec2(static_cast<double>(ImGui::GetIO().MousePos.x), 0)).x;
  touch.share = std::clamp((mouse - place.left) / std::max(place.width, 1.0), 0.0, 1.0);
  return touch;
}

double StudyCanvas::wheel() const {
  return static_cast<double>(ImGui::GetIO().MouseWheel);
}

}  // namespace ocelli
