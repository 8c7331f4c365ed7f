#include "oc_core/worlds/maze_mesh.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_graph.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"

namespace ocelli {
namespace {

constexpr size_t kTiles = 8;    // panel cells along a clear cell
constexpr size_t kCourses = 8;  // rows of them on a wall
constexpr size_t kPatterns = 6;

/// How the walls along one corridor look.
struct WallStyle {
  glm::vec3 color{1};
  size_t pattern = 0;

  /// Of the panel cell in column `i`, counted along the whole corridor, and row `j`.
  glm::vec3 at(size_t i, size_t j) const {
    if (j == 0) {
      return color * 0.35f;  // a skirting board
    }
    if (j == kCourses - 1) {
      return palette::ivory() * 0.85f;
    }
    return mix(color, palette::ivory(), isLight(i, j) ? 0.55f : 0.0f);
  }

 private:
  bool isLight(size_t i, size_t j) const {
    switch (pattern) {
      case 0:  // plain, with a band
        return j == 4;
      case 1:  // pillars
        return i % 4 < 2;
      case 2:  // bricks of four cells
        return (i + 2 * (j % 2)) % 8 < 4;
      case 3:  // courses
        return j % 2 == 0;
      case 4:  // diagonals
        return (i + j) % 4 < 2;
      default:  // windows
        return i % 4 != 0 && j >= 3 && j <= 5;
    }
  }
};

/// Of plain walls: greys of the panel cell in column `i` of a wall and row `j`. Cells alternate a little, for the eye
/// to see how fast it goes along them.
glm::vec3 plainWall(bool lookingEastWest, size_t i, size_t j) {
  const float base = lookingEastWest ? 0.56f : 0.68f;
  return glm::vec3(j == 0 ? 0.3f * base : (i / 4 + j / 4) % 2 == 0 ? base : 0.92f * base);
}

glm::vec3 plainFloor(bool dark) {
  return glm::vec3(dark ? 0.16f : 0.19f);
}

/// The rarest hue among those that no corridor has that crosses this one, where there is one, and a pattern that no
/// other corridor of this hue has, as far as they go.
std::vector<WallStyle> stylesOf(const MazeGraph& graph) {
  const std::array<glm::vec3, 7> hues{palette::skyBlue(), palette::orange(), palette::green(),    palette::purple(),
                                      palette::yellow(),  palette::blue(),   palette::vermilion()};
  std::vector<std::set<size_t>> crossed(graph.corridors.size());
  for (const Crossing& crossing : graph.crossings) {
    crossed[crossing.eastWest].insert(crossing.northSouth);
    crossed[crossing.northSouth].insert(crossing.eastWest);
  }
  std::vector<size_t> hueOf(graph.corridors.size(), hues.size());
  std::array<size_t, hues.size()> used{};
  std::vector<WallStyle> styles;
  for (size_t i = 0; i < graph.corridors.size(); ++i) {
    const auto cost = [&](size_t hue) {
      const bool meetsItself =
          std::any_of(crossed[i].begin(), crossed[i].end(), [&](size_t other) { return hueOf[other] == hue; });
      return used[hue] + (meetsItself ? graph.corridors.size() : 0);
    };
    size_t best = 0;
    for (size_t hue = 1; hue < hues.size(); ++hue) {
      best = cost(hue) < cost(best) ? hue : best;
    }
    hueOf[i] = best;
    styles.push_back({hues[best], (used[best]++ + best) % kPatterns});
  }
  return styles;
}

/// The lines of one axis: alternately across a wall (even blocks) and across a cell (odd ones), cells in so many tiles.
struct BlockLines {
  BlockLines(int cells, float origin, float cellSize, float wallThickness, size_t tiles) {
    const float half = wallThickness / 2;
    for (int i = 0; i <= cells; ++i) {
      const float middle = origin + cellSize * static_cast<float>(i);
      first.push_back(lines.size());
      lines.push_back(middle - half);
      first.push_back(lines.size());
      if (i < cells) {
        const std::vector<float> cell = evenLines(middle + half, middle + cellSize - half, tiles);
        lines.insert(lines.end(), cell.begin(), cell.end() - 1);
      } else {
        lines.push_back(middle + half);
      }
    }
  }
  std::vector<float> ofBlock(int block) const {
    const auto at = [&](size_t i) { return lines.begin() + static_cast<std::ptrdiff_t>(first[i]); };
    return {at(static_cast<size_t>(block)), at(static_cast<size_t>(block) + 1) + 1};
  }
  int count() const { return static_cast<int>(first.size()) - 1; }

  std::vector<float> lines;
  std::vector<size_t> first;  ///< of each block, the index of its first line; one more at the end
};

std::vector<float> negated(std::vector<float> lines) {
  std::reverse(lines.begin(), lines.end());
  for (float& line : lines) {
    line = -line;
  }
  return lines;
}

/// Blocks of walls (even row or column) and cells (odd both), and the faces between full and empty ones. All faces lie
/// on one grid of lines, so they share whole edges.
class StructureBuilder {
 public:
  StructureBuilder(const Maze& maze, const MazeLook& look)
      : maze_(maze),
        look_(look),
        graph_(maze),
        styles_(stylesOf(graph_)),
        xs_(maze.columns(), maze.origin.x, maze.cellSize, maze.wallThickness, look.coarse ? 1 : kTiles),
        zs_(maze.rows(), maze.origin.z, maze.cellSize, maze.wallThickness, look.coarse ? 1 : kTiles),
        floor_(maze.origin.y),
        wallLines_(evenLines(floor_, floor_ + maze.wallHeight, look.coarse ? 1 : kCourses)),
        slabLines_{floor_ - maze.wallThickness, floor_} {}

  Mesh build() {
    for (int row = 0; row < zs_.count(); ++row) {
      for (int column = 0; column < xs_.count(); ++column) {
        addBlock(row, column);
      }
    }
    return std::move(mesh_);
  }

 private:
  bool isInside(int row, int column) const {
    return row >= 0 && row < zs_.count() && column >= 0 && column < xs_.count();
  }

  bool isFull(int row, int column) const {
    if (row % 2 == 0 && column % 2 == 0) {
      return true;  // a post
    }
    if (row % 2 == 1 && column % 2 == 1) {
      return false;
    }
    // A cell beside the wall, and the side of it on which the wall is.
    const Direction side = row % 2 == 0 ? Direction::kNorth : Direction::kWest;
    const MazeCell cell{row / 2, column / 2};
    const MazeCell before = cell.neighbor(side);
    if (maze_.contains(cell) && maze_.contains(before)) {
      return !maze_.isOpen(cell, side);
    }
    if (look_.closedEntrance) {
      return true;
    }
    const bool isGap = maze_.contains(cell) ? maze_.entrance->cell == cell && opposite(maze_.entrance->heading) == side
                                            : maze_.entrance->cell == before && maze_.entrance->heading == side;
    return !isGap;
  }

  /// The style of a wall that looks in direction `facing` into the empty block; nothing for the outside.
  const WallStyle* styleOf(int row, int column, Direction facing) const {
    if (!isInside(row, column)) {
      return nullptr;
    }
    // A wall runs along the corridor; the end of a dead end does not, but belongs to it too. In a passage only walls
    // along it are seen, and both of its cells have its corridor.
    const MazeCell cell{std::min(row / 2, maze_.rows() - 1), std::min(column / 2, maze_.columns() - 1)};
    const bool eastWest = !isEastWest(facing);
    const std::optional<size_t> along = graph_.corridorOf(cell, eastWest);
    const std::optional<size_t> across = graph_.corridorOf(cell, !eastWest);
    return along ? &styles_[*along] : across ? &styles_[*across] : nullptr;
  }

  glm::vec3 floorColor(int row, int column, bool dark) const {
    if (look_.plain) {
      return plainFloor(dark);
    }
    const MazeCell cell{std::min(row / 2, maze_.rows() - 1), std::min(column / 2, maze_.columns() - 1)};
    const std::optional<size_t> eastWest = graph_.corridorOf(cell, true);
    const std::optional<size_t> northSouth = graph_.corridorOf(cell, false);
    const glm::vec3 plain = dark ? palette::slate() : palette::ivory() * 0.8f;
    const bool isCell = row % 2 == 1 && column % 2 == 1;
    if (isCell && eastWest && northSouth) {
      return plain;  // where corridors meet; elsewhere the floor has something of their colour
    }
    const bool isEastWest = eastWest && (!northSouth || column % 2 == 0);
    return mix(plain, styles_[isEastWest ? *eastWest : *northSouth].color, 0.3f);
  }

  glm::vec3 topColor() const { return look_.plain ? glm::vec3(0.08f) : palette::slate() * 0.8f; }

  void addBlock(int row, int column) {
    const bool full = isFull(row, column);
    const size_t firstX = xs_.first[static_cast<size_t>(column)];
    const size_t firstZ = zs_.first[static_cast<size_t>(row)];
    const std::vector<float> xs = xs_.ofBlock(column);
    const std::vector<float> zs = zs_.ofBlock(row);
    // Panel (x, y) is world (x, -z) above and (x, z) below.
    const float top = full ? wallLines_.back() : floor_;
    addPanel(mesh_, xs, negated(zs), frame({1, 0, 0}, {0, 0, -1}, {0, top, 0}), [&](size_t i, size_t j) {
      const size_t k = zs.size() - 2 - j;
      return full ? topColor() : floorColor(row, column, ((firstX + i) / 2 + (firstZ + k) / 2) % 2 == 0);
    });
    addPanel(mesh_, xs, zs, frame({1, 0, 0}, {0, 0, 1}, {0, slabLines_.front(), 0}),
             [&](size_t, size_t) { return look_.plain ? topColor() : palette::slate(); });
    for (const Direction facing : kDirections) {
      const glm::vec3 step = vectorOf(facing);
      const int nextRow = row + static_cast<int>(step.z);
      const int nextColumn = column + static_cast<int>(step.x);
      const bool outside = !isInside(nextRow, nextColumn);
      if (full && (outside || !isFull(nextRow, nextColumn))) {
        addSide(row, column, facing, wallLines_, styleOf(nextRow, nextColumn, facing));
      }
      if (outside) {
        addSide(row, column, facing, slabLines_, nullptr);
      }
    }
  }

  void addSide(int row, int column, Direction facing, const std::vector<float>& heights, const WallStyle* style) {
    const bool alongX = !isEastWest(facing);
    const BlockLines& axis = alongX ? xs_ : zs_;
    const int block = alongX ? column : row;
    const std::vector<float> lines = axis.ofBlock(block);
    // Seen from in front of the face, right is the left of where it looks.
    const glm::vec3 right = vectorOf(leftOf(facing));
    const bool ascending = right.x + right.z > 0;
    const std::vector<float> across = alongX ? zs_.ofBlock(row) : xs_.ofBlock(column);
    const bool farSide = facing == Direction::kEast || facing == Direction::kSouth;
    const float plane = farSide ? across.back() : across.front();
    const glm::vec3 origin = alongX ? glm::vec3(0, 0, plane) : glm::vec3(plane, 0, 0);
    const size_t first = axis.first[static_cast<size_t>(block)];
    addPanel(
        mesh_, ascending ? lines : negated(lines), heights, frame(right, {0, 1, 0}, origin), [&](size_t i, size_t j) {
          const size_t along = first + (ascending ? i : lines.size() - 2 - i);
          if (look_.plain) {
            return plainWall(isEastWest(facing), along, j);
          }
          return style != nullptr ? style->at(along, j) : palette::ivory() * (j % 2 == along / 4 % 2 ? 0.55f : 0.7f);
        });
  }

  static glm::mat4 frame(const glm::vec3& right, const glm::vec3& up, const glm::vec3& origin) {
    return {glm::vec4(right, 0), glm::vec4(up, 0), glm::vec4(glm::cross(right, up), 0), glm::vec4(origin, 1)};
  }

  const Maze& maze_;
  const MazeLook look_;
  MazeGraph graph_;
  std::vector<WallStyle> styles_;
  BlockLines xs_;
  BlockLines zs_;
  float floor_;
  std::vector<float> wallLines_;
  std::vector<float> slabLines_;  ///< the floor is a slab, so that the structure is closed
  Mesh mesh_;
};

}  // namespace

Scene makeMazeScene(const Maze& maze, const MazeLook& look) {
  Scene scene;
  scene.add(StructureBuilder(maze, look).build());
  for (size_t i = 0; i < maze.landmarks.size(); ++i) {
    scene.add(makeLandmark(maze, maze.landmarks[i]));
    scene.instances.back().tint = colorOf(maze.landmarks[i].color);
    scene.instances.back().object = static_cast<uint32_t>(i + 1);
  }
  scene.guides.maze = maze;
  return scene;
}

}  // namespace ocelli
