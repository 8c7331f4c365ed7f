#include "oc_core/worlds/place_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/worlds/facade.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

constexpr float kLightStep = 0.11f;       // metres between the points where light is worked out on flat faces
constexpr float kRoundLightStep = 0.05f;  // on round ones
constexpr float kHiddenLight = 0.4f;      // of what is hardly ever seen
constexpr float kNothingDarker = 0.024f;  // of the brightest channel, so that displays show it

glm::vec3 finished(const glm::vec3& color, const glm::vec3& light) {
  const glm::vec3 lit = glm::clamp(color * light, glm::vec3(0), glm::vec3(1));
  const float brightest = std::max({lit.x, lit.y, lit.z});
  return brightest < kNothingDarker ? lit + (kNothingDarker - brightest) : lit;
}

std::vector<float> evenSteps(float from, float to, float step) {
  const float count = std::max(1.0f, std::round((to - from) / step));
  std::vector<float> lines = evenLines(from, to, static_cast<size_t>(count));
  lines.front() = from;
  lines.back() = to;
  return lines;
}

/// The lines among `count` + 1 where light is worked out: the first, the last, and every few between.
std::vector<size_t> lightLines(size_t count, float length, float step) {
  const auto parts = std::clamp<size_t>(static_cast<size_t>(std::lround(length / step)), 1, count);
  std::vector<size_t> lines;
  for (size_t k = 0; k <= parts; ++k) {
    lines.push_back(k * count / parts);
  }
  return lines;
}

glm::vec3 pointOf(const glm::mat4& m, const glm::vec3& p) {
  return glm::vec3(m * glm::vec4(p, 1));
}

}  // namespace

void PlaceBuilder::beginObject() {
  object_ = ++objects_;
}

void PlaceBuilder::addFace(const std::array<std::vector<float>, 3>& lines, size_t face, const glm::mat4& worldFromBox,
                           const BoxLook& look) {
  // The axes of u and v of each face, and whether u or v runs downwards; u x v points out.
  struct Axes {
    glm::length_t across, u, v;
    bool uFalls, vFalls;
  };
  static constexpr std::array<Axes, 6> kAxes{{{0, 2, 1, false, false},
                                              {0, 2, 1, true, false},
                                              {1, 0, 2, false, false},
                                              {1, 0, 2, false, true},
                                              {2, 0, 1, true, false},
                                              {2, 0, 1, false, false}}};
  const Axes axes = kAxes[face];
  const auto& across = lines[static_cast<size_t>(axes.across)];
  const float plane = face % 2 == 0 ? across.front() : across.back();
  const std::vector<float> us = lines[static_cast<size_t>(axes.u)];
  const std::vector<float> vs = lines[static_cast<size_t>(axes.v)];
  const size_t columns = us.size() - 1;
  const size_t rows = vs.size() - 1;
  const auto position = [=](size_t i, size_t j) {
    glm::vec3 p;
    p[axes.across] = plane;
    p[axes.u] = us[axes.uFalls ? columns - i : i];
    p[axes.v] = vs[axes.vFalls ? rows - j : j];
    return pointOf(worldFromBox, p);
  };
  const auto metres = [=](size_t i, size_t j) {
    return glm::vec2(axes.uFalls ? us.back() - us[columns - i] : us[i] - us.front(),
                     axes.vFalls ? vs.back() - vs[rows - j] : vs[j] - vs.front());
  };
  if (!look.isPlain[face]) {
    grids_.push_back({columns, rows, position, metres, look.textures[face], look.glow, false, true, object_});
    return;
  }
  Fan fan;
  for (size_t i = 0; i < columns; ++i) {
    fan.rim.push_back(position(i, 0));
  }
  for (size_t j = 0; j < rows; ++j) {
    fan.rim.push_back(position(columns, j));
  }
  for (size_t i = columns; i > 0; --i) {
    fan.rim.push_back(position(i, rows));
  }
  for (size_t j = rows; j > 0; --j) {
    fan.rim.push_back(position(0, j));
  }
  fan.color = look.textures[face](metres(columns / 2, rows / 2));
  // The backs and undersides of small things are hardly ever seen.
  const bool isHidden = face == static_cast<size_t>(BoxFace::kBack) || face == static_cast<size_t>(BoxFace::kBottom);
  fan.isLit = look.glow <= 0 && (look.casts || !isHidden);
  fan.object = object_;
  fans_.push_back(std::move(fan));
}

void PlaceBuilder::addBox(const glm::vec3& size, const glm::mat4& worldFromBox, const BoxLook& look) {
  const float step = texel_ * look.fineness;
  std::array<std::vector<float>, 3> lines;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    lines[static_cast<size_t>(axis)] = evenSteps(-size[axis] / 2, size[axis] / 2, step * look.stretch[axis]);
  }
  for (size_t face = 0; face < 6; ++face) {
    addFace(lines, face, worldFromBox, look);
  }
  if (look.casts) {
    light_.addOccluder(size, worldFromBox);
  }
}

void PlaceBuilder::addWall(const PlaceWall& wall, const glm::mat4& worldFromWall) {
  const float step = texel_ * wall.fineness;
  std::vector<float> xs{0, wall.size.x};
  std::vector<float> ys{0, wall.size.y};
  for (const auto& [lower, upper] : wall.openings) {
    OC_CHECK(lower.x > 0 && lower.y > 0 && upper.x < wall.size.x && upper.y < wall.size.y, "openings leave a rim");
    xs.insert(xs.end(), {lower.x, upper.x});
    ys.insert(ys.end(), {lower.y, upper.y});
  }
  for (std::vector<float>* lines : {&xs, &ys}) {
    std::sort(lines->begin(), lines->end());
    lines->erase(std::unique(lines->begin(), lines->end()), lines->end());
  }
  const std::vector<float> zs = evenSteps(-wall.thickness, 0, std::max(step, 0.03f));
  const auto isOpen = [&](const glm::vec2& p) {
    return std::any_of(wall.openings.begin(), wall.openings.end(),
                       [&](const auto& o) { return o[0].x < p.x && p.x < o[1].x && o[0].y < p.y && p.y < o[1].y; });
  };
  // Each coarse cell between lines, as the faces of a box: the same refined lines on both sides of each border.
  const float width = wall.size.x;
  for (size_t j = 0; j + 1 < ys.size(); ++j) {
    for (size_t i = 0; i + 1 < xs.size(); ++i) {
      const glm::vec2 middle((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2);
      if (isOpen(middle)) {
        continue;
      }
      const std::array<std::vector<float>, 3> lines{evenSteps(xs[i], xs[i + 1], step),
                                                    evenSteps(ys[j], ys[j + 1], step), zs};
      const glm::vec2 corner(xs[i], ys[j]);
      const float fromRight = width - xs[i + 1];
      const SurfaceTexture& front = wall.front;
      const SurfaceTexture& back = wall.back;
      BoxLook look(wall.rim);
      look.with(BoxFace::kFront, [front, corner](const glm::vec2& p) { return front(p + corner); });
      look.with(BoxFace::kBack,
                [back, corner, fromRight](const glm::vec2& p) { return back(p + glm::vec2(fromRight, corner.y)); });
      look.isPlain[static_cast<size_t>(BoxFace::kBack)] = wall.isBackPlain && wall.openings.empty();
      const auto addWhereFree = [&](BoxFace face, const glm::vec2& beside) {
        const bool isRim = beside.x < 0 || beside.y < 0 || beside.x > wall.size.x || beside.y > wall.size.y;
        if (isRim || isOpen(beside)) {
          look.isPlain[static_cast<size_t>(face)] = isRim;
          addFace(lines, static_cast<size_t>(face), worldFromWall, look);
        }
      };
      addFace(lines, static_cast<size_t>(BoxFace::kFront), worldFromWall, look);
      addFace(lines, static_cast<size_t>(BoxFace::kBack), worldFromWall, look);
      const float x0 = i > 0 ? (xs[i - 1] + xs[i]) / 2 : -1;
      const float x1 = i + 2 < xs.size() ? (xs[i + 1] + xs[i + 2]) / 2 : wall.size.x + 1;
      const float y0 = j > 0 ? (ys[j - 1] + ys[j]) / 2 : -1;
      const float y1 = j + 2 < ys.size() ? (ys[j + 1] + ys[j + 2]) / 2 : wall.size.y + 1;
      addWhereFree(BoxFace::kLeft, {x0, middle.y});
      addWhereFree(BoxFace::kRight, {x1, middle.y});
      addWhereFree(BoxFace::kBottom, {middle.x, y0});
      addWhereFree(BoxFace::kTop, {middle.x, y1});
      light_.addOccluder({xs[i + 1] - xs[i], ys[j + 1] - ys[j], wall.thickness},
                         worldFromWall * placedAt({middle.x, middle.y, -wall.thickness / 2}));
    }
  }
}

void PlaceBuilder::addRound(size_t around, size_t rows, const std::function<glm::vec3(size_t, size_t)>& position,
                            float girth, float length, const SurfaceTexture& texture) {
  Grid grid;
  grid.columns = around;
  grid.rows = rows;
  grid.position = [position, around, rows](size_t i, size_t j) {
    return position(j == 0 || j == rows ? 0 : i % around, j);
  };
  const glm::vec2 scale(girth / static_cast<float>(around), length / static_cast<float>(rows));
  grid.metres = [scale](size_t i, size_t j) { return glm::vec2(i, j) * scale; };
  grid.texture = texture;
  grid.hasPoles = true;
  grid.isFlat = false;
  grid.object = object_;
  grids_.push_back(std::move(grid));
}

void PlaceBuilder::addTurned(const std::vector<glm::vec2>& profile, const glm::mat4& worldFromSolid,
                             const SurfaceTexture& texture, float fineness,
                             const std::function<glm::vec3(const glm::vec3&)>& shape) {
  const float step = texel_ * fineness;
  std::vector<glm::vec2> points{profile.front()};
  float length = 0;
  float radius = 0;
  for (size_t k = 0; k + 1 < profile.size(); ++k) {
    const float part = glm::distance(profile[k], profile[k + 1]);
    const auto steps = static_cast<size_t>(std::max(1.0f, std::round(part / step)));
    for (size_t s = 1; s <= steps; ++s) {
      points.push_back(glm::mix(profile[k], profile[k + 1], static_cast<float>(s) / static_cast<float>(steps)));
    }
    length += part;
    radius = std::max(radius, profile[k + 1].x);
  }
  const float girth = 2 * static_cast<float>(kPi) * radius;
  const auto around = static_cast<size_t>(std::max(10.0f, std::round(girth / step)));
  const auto position = [=](size_t i, size_t j) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(around);
    const glm::vec3 p(points[j].x * std::sin(angle), points[j].y, points[j].x * std::cos(angle));
    return pointOf(worldFromSolid, shape ? shape(p) : p);
  };
  addRound(around, points.size() - 1, position, girth, length, texture);
}

void PlaceBuilder::addBall(const glm::vec3& half, const glm::mat4& worldFromBall, const SurfaceTexture& texture,
                           float fineness) {
  const float reach = std::max({half.x, half.y, half.z});
  const auto rows = static_cast<size_t>(std::max(6.0, std::round(kPi * reach / (texel_ * fineness))));
  std::vector<glm::vec2> profile;
  for (size_t k = 0; k <= rows; ++k) {
    const double angle = kPi * static_cast<double>(k) / static_cast<double>(rows);
    profile.emplace_back(k == 0 || k == rows ? 0 : std::sin(angle), -std::cos(angle));
  }
  const auto around = std::max<size_t>(10, 2 * rows);
  const auto position = [=](size_t i, size_t j) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(around);
    return pointOf(worldFromBall,
                   half * glm::vec3(profile[j].x * std::sin(angle), profile[j].y, profile[j].x * std::cos(angle)));
  };
  const auto pi = static_cast<float>(kPi);
  addRound(around, rows, position, 2 * pi * reach, pi * reach, texture);
}

void PlaceBuilder::addTube(const std::vector<glm::vec3>& points, float radius, const SurfaceTexture& texture,
                           float fineness) {
  OC_CHECK(points.size() >= 2, "a tube has two ends");
  const float step = texel_ * fineness;
  std::vector<glm::vec3> line{points.front()};
  for (size_t k = 0; k + 1 < points.size(); ++k) {
    const float part = glm::distance(points[k], points[k + 1]);
    const auto steps = static_cast<size_t>(std::max(1.0f, std::round(part / (2 * step))));
    for (size_t s = 1; s <= steps; ++s) {
      line.push_back(glm::mix(points[k], points[k + 1], static_cast<float>(s) / static_cast<float>(steps)));
    }
  }
  const size_t last = line.size() - 1;
  const float girth = 2 * static_cast<float>(kPi) * radius;
  const auto around = static_cast<size_t>(std::max(6.0f, std::round(girth / step)));
  // A frame that turns with the line: across it, as upright as it can be.
  const auto position = [=](size_t i, size_t j) {
    const size_t k = std::clamp<size_t>(j, 1, last + 1) - 1;
    if (j == 0 || j == last + 2) {
      return line[k];
    }
    const glm::vec3 along = glm::normalize(line[std::min(k + 1, last)] - line[k == 0 ? 0 : k - 1]);
    const glm::vec3 up = std::abs(along.y) < 0.95f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 side = glm::normalize(glm::cross(up, along));
    const glm::vec3 over = glm::cross(along, side);
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(around);
    return line[k] + radius * (side * static_cast<float>(std::cos(angle)) + over * static_cast<float>(std::sin(angle)));
  };
  float length = 0;
  for (size_t k = 0; k < last; ++k) {
    length += glm::distance(line[k], line[k + 1]);
  }
  addRound(around, last + 2, position, girth, length, texture);
}

void PlaceBuilder::color(const Grid& grid, glm::vec3* positions, glm::vec3* colors) const {
  const size_t width = grid.columns + 1;
  for (size_t j = 0; j <= grid.rows; ++j) {
    for (size_t i = 0; i < width; ++i) {
      positions[j * width + i] = grid.position(i, j);
    }
  }
  const glm::vec2 size = grid.metres(grid.columns, grid.rows) - grid.metres(0, 0);
  // Coarse places need no finer light.
  const float lightStep = std::max(grid.isFlat ? kLightStep : kRoundLightStep, 2 * texel_);
  const std::vector<size_t> is = lightLines(grid.columns, size.x, lightStep);
  const std::vector<size_t> js = lightLines(grid.rows, size.y, lightStep);
  std::vector<glm::vec3> lights(is.size() * js.size(), glm::vec3(grid.glow));
  for (size_t b = 0; b < js.size() && grid.glow <= 0; ++b) {
    for (size_t a = 0; a < is.size(); ++a) {
      const size_t j = js[b];
      const size_t row = grid.hasPoles ? std::clamp<size_t>(j, 1, grid.rows - 1) : j;
      const auto at = [&](size_t column, size_t line) { return positions[line * width + column]; };
      // Around a round solid the first column follows the last one.
      const size_t left = is[a] > 0 ? is[a] - 1 : grid.hasPoles ? grid.columns - 1 : 0;
      const size_t right = is[a] < grid.columns ? is[a] + 1 : grid.hasPoles ? 1 : grid.columns;
      const glm::vec3 du = at(right, row) - at(left, row);
      const glm::vec3 dv = at(is[a], std::min(row + 1, grid.rows)) - at(is[a], row == 0 ? 0 : row - 1);
      const glm::vec3 normal = glm::cross(du, dv);
      const float length = glm::length(normal);
      lights[b * is.size() + a] = light_.at(at(is[a], j), length > 0 ? normal / length : glm::vec3(0, 1, 0));
    }
  }
  size_t b = 0;
  for (size_t j = 0; j <= grid.rows; ++j) {
    b += b + 2 < js.size() && j > js[b + 1] ? 1 : 0;
    const float t = static_cast<float>(j - js[b]) / static_cast<float>(js[b + 1] - js[b]);
    size_t a = 0;
    for (size_t i = 0; i < width; ++i) {
      a += a + 2 < is.size() && i > is[a + 1] ? 1 : 0;
      const float s = static_cast<float>(i - is[a]) / static_cast<float>(is[a + 1] - is[a]);
      const glm::vec3* low = &lights[b * is.size() + a];
      const glm::vec3* high = low + is.size();
      const glm::vec3 light = glm::mix(glm::mix(low[0], low[1], s), glm::mix(high[0], high[1], s), t);
      colors[j * width + i] = finished(grid.texture(grid.metres(i, j)), light);
    }
  }
}

Scene PlaceBuilder::build() {
  Scene scene;
  std::vector<Mesh> meshes(objects_ + 1);
  // Where each grid and fan begins in the mesh of its identity.
  std::vector<size_t> firstOfGrid;
  for (const Grid& grid : grids_) {
    Mesh& mesh = meshes[grid.object];
    const size_t first = mesh.positions.size();
    firstOfGrid.push_back(first);
    mesh.positions.resize(first + (grid.columns + 1) * (grid.rows + 1));
    const auto vertex = [&](size_t i, size_t j) { return static_cast<uint32_t>(first + j * (grid.columns + 1) + i); };
    for (size_t j = 0; j < grid.rows; ++j) {
      for (size_t i = 0; i < grid.columns; ++i) {
        // Triangles at a pole, but for those between two of its vertices, which have no area.
        if (!grid.hasPoles || j > 0) {
          mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        }
        if (!grid.hasPoles || j + 1 < grid.rows) {
          mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
      }
    }
  }
  std::vector<size_t> firstOfFan;
  for (const Fan& fan : fans_) {
    Mesh& mesh = meshes[fan.object];
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    firstOfFan.push_back(first);
    glm::vec3 middle(0);
    for (const glm::vec3& p : fan.rim) {
      mesh.positions.push_back(p);
      middle += p / static_cast<float>(fan.rim.size());
    }
    mesh.positions.push_back(middle);
    const auto count = static_cast<uint32_t>(fan.rim.size());
    for (uint32_t k = 0; k < count; ++k) {
      mesh.triangles.push_back({first + k, first + (k + 1) % count, first + count});
    }
  }
  for (Mesh& mesh : meshes) {
    mesh.colors.resize(mesh.positions.size());
  }
  parallelFor(grids_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      Mesh& mesh = meshes[grids_[k].object];
      color(grids_[k], &mesh.positions[firstOfGrid[k]], &mesh.colors[firstOfGrid[k]]);
    }
  });
  parallelFor(fans_.size(), 64, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const Fan& fan = fans_[k];
      Mesh& mesh = meshes[fan.object];
      const size_t count = fan.rim.size();
      const glm::vec3& middle = mesh.positions[firstOfFan[k] + count];
      const glm::vec3 normal = glm::cross(fan.rim[0] - middle, fan.rim[count / 3] - middle);
      const float length = glm::length(normal);
      const glm::vec3 light = fan.isLit && length > 0 ? light_.at(middle, normal / length) : glm::vec3(kHiddenLight);
      const glm::vec3 color = finished(fan.color, light);
      std::fill_n(mesh.colors.begin() + static_cast<std::ptrdiff_t>(firstOfFan[k]), count + 1, color);
    }
  });
  for (size_t object = 0; object < meshes.size(); ++object) {
    if (meshes[object].positions.empty()) {
      continue;
    }
    scene.add(std::move(meshes[object]));
    scene.instances.back().object = static_cast<uint32_t>(object);
    scene.instances.back().isLit = false;
  }
  return scene;
}

}  // namespace ocelli
