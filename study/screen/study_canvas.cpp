#include "study/screen/study_canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oc_core/base/check.h"
#include "study/screen/drawable_text.h"

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

std::set<char32_t> drawable(std::set<char32_t> characters) {
  std::erase_if(characters, [](char32_t character) { return scriptProblem(character).has_value(); });
  return characters;
}

}  // namespace

StudyCanvas::StudyCanvas(GlContext& context, int width, int height, const std::set<char32_t>& characters)
    : width_(width), height_(height), look_(width, height), gui_(context, 1, fontsOf(look_), drawable(characters)) {
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

double StudyCanvas::widthOf(const std::string& text, StudyText style) const {
  const auto pixels = static_cast<float>(look_.textPixels(style));
  return static_cast<double>(
      fontOf(style)->CalcTextSizeA(pixels, FLT_MAX, 0, text.data(), text.data() + text.size()).x);
}

std::vector<std::string> StudyCanvas::lines(const std::string& text, StudyText style, double width) const {
  std::vector<std::string> lines;
  const char* from = text.data();
  const char* const end = from + text.size();
  while (from < end) {
    const char* const newline = std::find(from, end, '\n');
    // Fonts have the size that they are drawn in: a scale of 1.
    const char* to = fontOf(style)->CalcWordWrapPositionA(1, from, newline, static_cast<float>(width));
    if (to == from && to < newline) {  // not one letter fits
      do {
        ++to;
      } while (to < newline && (static_cast<unsigned char>(*to) & 0xc0U) == 0x80);
    }
    lines.emplace_back(from, to);
    from = to;
    while (from < newline && *from == ' ') {
      ++from;
    }
    if (from == newline && newline < end) {
      ++from;
    }
  }
  return lines;
}

double StudyCanvas::writeLine(const Ink& ink, const glm::dvec2& at, const std::string& text) {
  const double pixels = look_.textPixels(ink.text);
  const double width = widthOf(text, ink.text);
  const double shift = ink.align == TextAlign::kLeft ? 0 : (ink.align == TextAlign::kCenter ? width / 2 : width);
  const PixelRect place{std::round(at.x - shift), std::round(at.y), width, pixels};
  if (!clips_.empty() && (place.top < clips_.back().top || place.bottom() > clips_.back().bottom())) {
    return place.right();
  }
  list_->AddText(fontOf(ink.text), static_cast<float>(pixels), topLeft(place), ink.color.packed(), text.data(),
                 text.data() + text.size());
  if (!text.empty()) {
    textBoxes_.push_back({place, pixels, ink.color, ink.background, text});
  }
  return place.right();
}

double StudyCanvas::write(const Ink& ink, const PixelRect& column, const std::string& text) {
  const double x = ink.align == TextAlign::kLeft
                       ? column.left
                       : (ink.align == TextAlign::kCenter ? column.center().x : column.right());
  double y = column.top;
  for (const std::string& one : lines(text, ink.text, column.width)) {
    writeLine(ink, {x, y}, one);
    y += lineHeight(ink.text);
  }
  return y;
}

bool StudyCanvas::canShow(const std::string& text) const {
  return std::ranges::all_of(glyphsOf(text),
                             [this](char32_t character) { return !scriptProblem(character) && gui_.holds(character); });
}

double StudyCanvas::heightOf(const std::string& text, StudyText style, double width) const {
  return static_cast<double>(lines(text, style, width).size()) * lineHeight(style);
}

void StudyCanvas::fill(const PixelRect& place, GuiColor color, double rounding) {
  list_->AddRectFilled(topLeft(place), bottomRight(place), color.packed(), static_cast<float>(rounding));
}

void StudyCanvas::outline(const PixelRect& place, GuiColor color, double thickness, double rounding) {
  list_->AddRect(topLeft(place), bottomRight(place), color.packed(), static_cast<float>(rounding), 0,
                 static_cast<float>(thickness));
}

void StudyCanvas::line(std::span<const glm::dvec2> points, GuiColor color, double thickness) {
  std::vector<ImVec2> path;
  for (const glm::dvec2& p : points) {
    path.push_back(vec(p));
  }
  list_->AddPolyline(path.data(), static_cast<int>(path.size()), color.packed(), 0, static_cast<float>(thickness));
}

void StudyCanvas::disc(const glm::dvec2& center, double radius, GuiColor color) {
  list_->AddCircleFilled(vec(center), static_cast<float>(radius), color.packed(), 48);
}

void StudyCanvas::ring(const glm::dvec2& center, double radius, GuiColor color, double thickness) {
  list_->AddCircle(vec(center), static_cast<float>(radius), color.packed(), 48, static_cast<float>(thickness));
}

void StudyCanvas::arc(const glm::dvec2& center, double radius, double share, GuiColor color, double thickness) {
  constexpr double kTop = -std::numbers::pi / 2;
  list_->PathArcTo(vec(center), static_cast<float>(radius), static_cast<float>(kTop),
                   static_cast<float>(kTop + 2 * std::numbers::pi * std::clamp(share, 0.0, 1.0)), 64);
  list_->PathStroke(color.packed(), 0, static_cast<float>(thickness));
}

void StudyCanvas::triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, GuiColor color) {
  list_->AddTriangleFilled(vec(a), vec(b), vec(c), color.packed());
}

void StudyCanvas::image(const GlObject& texture, const PixelRect& place) {
  list_->AddImage(GuiLayer::imageOf(texture), topLeft(place), bottomRight(place));
}

void StudyCanvas::beginClip(const PixelRect& place) {
  clips_.push_back(place);
  list_->PushClipRect(topLeft(place), bottomRight(place), true);
}

void StudyCanvas::endClip() {
  clips_.pop_back();
  list_->PopClipRect();
}

Touch StudyCanvas::touch(const std::string& name, const PixelRect& place) {
  ImGui::SetCursorScreenPos(topLeft(place));
  const ImVec2 size{static_cast<float>(std::max(place.width, 1.0)), static_cast<float>(std::max(place.height, 1.0))};
  Touch touch;
  touch.clicked = ImGui::InvisibleButton(name.c_str(), size);
  touch.hovered = ImGui::IsItemHovered();
  touch.held = ImGui::IsItemActive();
  return touch;
}

double StudyCanvas::wheel() const {
  return static_cast<double>(ImGui::GetIO().MouseWheel);
}

}  // namespace ocelli
