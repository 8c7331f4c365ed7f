#include "oc_core/explore_window/explore_drawing_painter.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

ImU32 packedPaint(const Paint& paint) {
  const auto byte = [](double share) { return static_cast<float>(std::clamp(share, 0.0, 1.0)); };
  return ImGui::ColorConvertFloat4ToU32({byte(paint.red), byte(paint.green), byte(paint.blue), byte(paint.opacity)});
}

class DrawingPainter {
 public:
  DrawingPainter(ImDrawList& list, const glm::vec2& corner, float scale)
      : list_(list), corner_(corner), scale_(scale) {}
  ~DrawingPainter() { leaveClip(); }
  DrawingPainter(const DrawingPainter&) = delete;
  DrawingPainter& operator=(const DrawingPainter&) = delete;

  void operator()(const PathShape& shape) {
    for (const std::vector<PlotPoint>& line : shape.lines) {
      take(line);
      if (shape.fill && points_.size() >= 3) {
        list_.AddConvexPolyFilled(points_.data(), count(), packedPaint(*shape.fill));
      }
      if (shape.pen && points_.size() >= 2) {
        stroke(*shape.pen, shape.closed);
      }
    }
  }

  void operator()(const MarkerShape& shape) {
    constexpr int kCircleCorners = 20;
    points_.clear();
    const ImVec2 at = onScreen(shape.at);
    const float radius = length(shape.radius);
    const auto corners = cornersOf(shape.marker);
    if (corners.empty()) {
      for (int i = 0; i < kCircleCorners; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / kCircleCorners;
        points_.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
      }
    }
    for (const glm::vec2& corner : corners) {
      points_.push_back({at.x + radius * corner.x, at.y + radius * corner.y});
    }
    if (shape.marker == Marker::kPlus || shape.marker == Marker::kCross) {
      const ImU32 color = packedPaint(shape.pen ? shape.pen->paint : shape.fill.value_or(Paint()));
      const float width = shape.pen ? length(shape.pen->width) : scale_;
      list_.AddLine(points_[0], points_[2], color, width);
      list_.AddLine(points_[1], points_[3], color, width);
      return;
    }
    if (shape.fill) {
      list_.AddConvexPolyFilled(points_.data(), count(), packedPaint(*shape.fill));
    }
    if (shape.pen) {
      stroke(*shape.pen, true);
    }
  }

  void operator()(const TextShape& shape) {
    const ImFont* const font = ImGui::GetFont();
    const float size = length(shape.size) * kLinesPerText;
    ImVec2 at = onScreen(shape.start);
    at.y -= font->Ascent * size / font->FontSize;
    list_.AddText(font, size, at, packedPaint(shape.paint), shape.text.c_str());
  }

  void operator()(const ImageShape&) {}

  void operator()(const ClipShape& shape) {
    leaveClip();
    if (shape.box) {
      list_.PushClipRect(onScreen({shape.box->left, shape.box->top}), onScreen({shape.box->right, shape.box->bottom}),
                         true);
      isClipped_ = true;
    }
  }

 private:
  /// Dear ImGui takes a font's lines for its size, a drawing its letters.
  static constexpr float kLinesPerText = 1.16f;

  static std::vector<glm::vec2> cornersOf(Marker marker) {
    switch (marker) {
      case Marker::kCircle:
        return {};
      case Marker::kSquare:
        return {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0.9f, 0.9f}, {-0.9f, 0.9f}};
      case Marker::kTriangle:
        return {{0, -1.2f}, {1.1f, 0.8f}, {-1.1f, 0.8f}};
      case Marker::kTriangleDown:
        return {{0, 1.2f}, {-1.1f, -0.8f}, {1.1f, -0.8f}};
      case Marker::kDiamond:
      case Marker::kPlus:
        return {{0, -1.2f}, {1.2f, 0}, {0, 1.2f}, {-1.2f, 0}};
      case Marker::kCross:
        return {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0.9f, 0.9f}, {-0.9f, 0.9f}};
    }
    return {};
  }

  ImVec2 onScreen(const PlotPoint& point) const {
    return {corner_.x + static_cast<float>(point.x) * scale_, corner_.y + static_cast<float>(point.y) * scale_};
  }
  float length(double of) const { return static_cast<float>(of) * scale_; }
  int count() const { return static_cast<int>(points_.size()); }

  void take(const std::vector<PlotPoint>& line) {
    points_.clear();
    for (const PlotPoint& point : line) {
      points_.push_back(onScreen(point));
    }
  }

  void stroke(const Pen& pen, bool closed) {
    const ImU32 color = packedPaint(pen.paint);
    const float width = std::max(length(pen.width), 1.0f);
    if (pen.dash.empty()) {
      list_.AddPolyline(points_.data(), count(), color, closed ? ImDrawFlags_Closed : 0, width);
      return;
    }
    // Lengths on and off go on around corners.
    size_t step = 0;
    float left = length(pen.dash[0]);
    const size_t segments = points_.size() - (closed ? 0 : 1);
    for (size_t i = 0; i < segments; ++i) {
      const glm::vec2 from(points_[i].x, points_[i].y);
      const ImVec2& next = points_[(i + 1) % points_.size()];
      const glm::vec2 to(next.x, next.y);
      const float whole = glm::distance(from, to);
      for (float done = 0; done < whole;) {
        const float piece = std::min(std::max(left, 0.5f), whole - done);
        if (step % 2 == 0) {
          const glm::vec2 a = from + (to - from) * (done / whole);
          const glm::vec2 b = from + (to - from) * ((done + piece) / whole);
          list_.AddLine({a.x, a.y}, {b.x, b.y}, color, width);
        }
        done += piece;
        left -= piece;
        if (left <= 0) {
          ++step;
          left = length(pen.dash[step % pen.dash.size()]);
        }
      }
    }
  }

  void leaveClip() {
    if (isClipped_) {
      list_.PopClipRect();
      isClipped_ = false;
    }
  }

  ImDrawList& list_;
  glm::vec2 corner_;
  float scale_;
  std::vector<ImVec2> points_;
  bool isClipped_ = false;
};

}  // namespace

void paintExploreDrawing(ImDrawList& list, const Drawing& drawing, const glm::vec2& corner, float scale) {
  DrawingPainter painter(list, corner, scale);
  for (const Shape& shape : drawing.shapes()) {
    std::visit(painter, shape.what);
  }
}

}  // namespace ocelli
