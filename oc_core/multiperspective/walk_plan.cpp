#include "oc_core/multiperspective/walk_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/drawing/series_style.h"
#include "oc_core/multiperspective/plan_section.h"

namespace ocelli {
namespace {

constexpr double kWalkMargin = 24;
constexpr double kWalkTitle = 34;
constexpr double kWalkLegend = 30;
constexpr double kSmallestNumber = 5;  // points
constexpr double kLargestNumber = 14;

class WalkDrawing {
 public:
  WalkDrawing(const WalkMap& map, const Mesh& mesh, const WalkPlanOptions& options) : map_(map), options_(options) {
    const Box bounds = boundsOf(mesh);
    lower_ = {bounds.lower.x, bounds.lower.z};
    const glm::vec2 size(bounds.size().x, bounds.size().z);
    scale_ = options.planPixels / static_cast<double>(std::max({size.x, size.y, 1e-6f}));
    top_ = kWalkMargin + (options.title.empty() ? 0 : kWalkTitle);
    size_ = {size.x * scale_, size.y * scale_};
  }

  Figure figure(const Mesh& mesh) {
    for (const SectionLine& line : sectionOf(mesh, PlanSide::kTop, cutOf())) {
      drawing_.line("wall", at(line[0]), at(line[1]), {paintOf(page_color::kText), 1});
    }
    for (size_t i = 0; i < map_.cells.size(); ++i) {
      if (isShown(map_.cells[i])) {
        cell(i);
      }
    }
    for (const WalkPortal& portal : map_.portals) {
      if (!isShown(map_.cells[portal.from]) && !isShown(map_.cells[portal.to])) {
        continue;
      }
      const glm::vec3& c = portal.opening.center;
      const glm::vec3& r = portal.opening.halfRight;
      const Pen pen = portal.isJoint ? Pen{seriesStyle(1).paint.faded(0.5), 1.2} : Pen{seriesStyle(1).paint, 3.5};
      drawing_.line(portal.isJoint ? "joint" : "portal", at({c.x - r.x, c.z - r.z}), at({c.x + r.x, c.z + r.z}), pen);
    }
    for (size_t i = 0; i < map_.cells.size(); ++i) {
      if (isShown(map_.cells[i])) {
        number(i);
      }
    }
    const std::string counts = fmt::format("{} cells, {} of them tunnels, {} rooms, {} openings, {} joints, {} parts",
                                           map_.cells.size(), tunnelCount(), map_.roomCount(), map_.openingCount(),
                                           map_.portals.size() - map_.openingCount(), map_.partCount());
    Figure figure;
    figure.title = options_.title.empty() ? "Where one can walk" : options_.title;
    figure.description = counts + ", over a section of the scene.";
    figure.width = size_.x + 2 * kWalkMargin;
    figure.height = size_.y + top_ + kWalkMargin + kWalkLegend;
    TextLook look;
    look.size = 19;
    if (!options_.title.empty()) {
      drawing_.text("title", {kWalkMargin, kWalkMargin + 16}, options_.title, look);
    }
    look.size = 14;
    drawing_.text("legend", {kWalkMargin, top_ + size_.y + kWalkLegend - 6}, counts, look);
    figure.drawing = std::move(drawing_);
    return figure;
  }

 private:
  PlotPoint at(const glm::vec2& p) const {
    return {kWalkMargin + (p.x - lower_.x) * scale_, top_ + (p.y - lower_.y) * scale_};
  }

  bool isShown(const WalkCell& cell) const {
    const float rise = std::abs(cell.floorRise) / 2;
    return !options_.floor || std::abs(cell.center.y - *options_.floor) <= rise + options_.metre / 2;
  }

  float cutOf() const {
    float floor = options_.floor ? *options_.floor : map_.cells.empty() ? 0 : map_.cells.front().center.y;
    for (const WalkCell& cell : map_.cells) {
      floor = options_.floor ? floor : std::min(floor, cell.center.y);
    }
    return floor + options_.cutHeight * options_.metre;
  }

  size_t tunnelCount() const {
    return static_cast<size_t>(std::count_if(map_.cells.begin(), map_.cells.end(),
                                             [](const WalkCell& c) { return c.kind == WalkCellKind::kTunnel; }));
  }

  /// In the middle of its cell, as large as fits into it.
  void number(size_t index) {
    const WalkCell& cell = map_.cells[index];
    const std::string text = std::to_string(index);
    const double across = 2 * static_cast<double>(std::min(cell.halfLength, cell.halfWidth)) * scale_;
    TextLook look;
    look.size = std::clamp(across / static_cast<double>(text.size() + 1), kSmallestNumber, kLargestNumber);
    look.across = Across::kMiddle;
    const PlotPoint middle = at({cell.center.x, cell.center.z});
    drawing_.text("number", {middle.x, middle.y + look.size / 3}, text, look);
  }

  void cell(size_t index) {
    const WalkCell& cell = map_.cells[index];
    const glm::vec2 center(cell.center.x, cell.center.z);
    const glm::vec2 axis(cell.axis.x, cell.axis.z);
    const glm::vec2 right(cell.right().x, cell.right().z);
    const auto corner = [&](float u, float v) { return at(center + u * axis + v * right); };
    std::vector<PlotPoint> outline;
    const bool isTunnel = cell.kind == WalkCellKind::kTunnel;
    if (isTunnel) {
      for (const WalkRing& ring : cell.rings) {
        outline.push_back(corner(ring.along - cell.halfLength, ring.right));
      }
      for (size_t i = cell.rings.size(); i-- > 0;) {
        outline.push_back(corner(cell.rings[i].along - cell.halfLength, -cell.rings[i].left));
      }
    } else {
      outline = {corner(-cell.halfLength, -cell.halfWidth), corner(cell.halfLength, -cell.halfWidth),
                 corner(cell.halfLength, cell.halfWidth), corner(-cell.halfLength, cell.halfWidth)};
    }
    const size_t part = map_.partOfCell.empty() ? 0 : map_.partOfCell[index];
    const Paint paint = seriesStyle((isTunnel ? 0 : 2) + part % 2 * 3).paint;
    PathShape shape;
    shape.lines = {outline};
    shape.closed = true;
    shape.fill = paint.faded(0.3);
    shape.pen = Pen{paint, 1};
    drawing_.path(isTunnel ? "tunnel" : "room", shape);
    for (const WalkRing& ring : cell.rings) {
      drawing_.line("ring", corner(ring.along - cell.halfLength, -ring.left),
                    corner(ring.along - cell.halfLength, ring.right), {paint, 0.8});
    }
  }

  const WalkMap& map_;
  const WalkPlanOptions& options_;
  glm::vec2 lower_{0};
  double scale_ = 1;
  double top_ = 0;
  glm::dvec2 size_{0};
  Drawing drawing_;
};

}  // namespace

Figure walkPlanFigure(const WalkMap& map, const Mesh& mesh, const WalkPlanOptions& options) {
  return WalkDrawing(map, mesh, options).figure(mesh);
}

}  // namespace ocelli
