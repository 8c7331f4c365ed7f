#include "oc_core/feeds_measure/walkers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/scene/shading.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr double kStepLength = 0.72;  ///< metres
constexpr double kSwing = 0.45;       ///< radians, of a leg
constexpr double kTurnReach = 0.35;   ///< metres over which a walker turns
constexpr int kStripes = 5;

double inRange(Random& random, double least, double most) {
  return static_cast<double>(random.inRange(static_cast<float>(least), static_cast<float>(most)));
}

void addPart(Mesh& figure, const glm::vec3& half, const glm::mat4& figureFromPart, const glm::vec3& color) {
  Mesh part = makeBox(half);
  paint(part, color);
  append(figure, part, figureFromPart);
}

/// A limb of a length that hangs from a joint and swings forwards by an angle.
void addLimb(Mesh& figure, const glm::vec3& joint, float length, float width, double angle, const glm::vec3& color,
             const glm::vec3& endColor) {
  const glm::mat4 swung = glm::rotate(glm::translate(glm::mat4(1), joint), static_cast<float>(-angle), {1, 0, 0});
  const float half = length / 2;
  addPart(figure, {width, half * 0.85f, width}, glm::translate(swung, {0, -half * 0.85f, 0}), color);
  addPart(figure, {width * 0.95f, half * 0.15f, width * 1.4f},
          glm::translate(swung, {0, -length + half * 0.15f, width * 0.4f}), endColor);
}

/// 1.75 m high, on the floor, looking towards +z.
Mesh figureAt(double phase, const glm::vec3& shirt, const glm::vec3& trousers) {
  Mesh figure;
  const glm::vec3 skin = palette::fromSrgbBytes(214, 164, 130);
  const glm::vec3 shoe = palette::fromSrgbBytes(40, 36, 34);
  const double swing = kSwing * std::sin(phase);
  addLimb(figure, {-0.1f, 0.84f, 0}, 0.84f, 0.075f, swing, trousers, shoe);
  addLimb(figure, {0.1f, 0.84f, 0}, 0.84f, 0.075f, -swing, trousers, shoe);
  addLimb(figure, {-0.25f, 1.42f, 0}, 0.62f, 0.05f, -0.8 * swing, shirt * 0.8f, skin);
  addLimb(figure, {0.25f, 1.42f, 0}, 0.62f, 0.05f, 0.8 * swing, shirt * 0.8f, skin);
  for (int k = 0; k < kStripes; ++k) {
    const float half = 0.62f / kStripes / 2;
    addPart(figure, {0.19f, half, 0.12f},
            glm::translate(glm::mat4(1), {0, 0.84f + half * static_cast<float>(2 * k + 1), 0}),
            k % 2 == 0 ? shirt : shirt * 0.55f);
  }
  Mesh head = makeSphere(12);
  paint(head, skin);
  append(figure, head, glm::scale(glm::translate(glm::mat4(1), {0, 1.61f, 0}), glm::vec3(0.1f, 0.14f, 0.12f)));
  addPart(figure, {0.095f, 0.05f, 0.1f}, glm::translate(glm::mat4(1), {0, 1.7f, -0.03f}), shoe);
  return figure;
}

}  // namespace

Walkers::Walkers(const WalkWays& ways, size_t count, double seconds, uint64_t seed) {
  const std::array looks{palette::vermilion(), palette::skyBlue(), palette::green(),  palette::yellow(),
                         palette::purple(),    palette::blue(),    palette::orange(), palette::ivory()};
  const std::array trousers{palette::slate(), palette::fromSrgbBytes(70, 60, 50), palette::fromSrgbBytes(44, 48, 66),
                            palette::fromSrgbBytes(96, 92, 88)};
  for (size_t k = 0; k < count; ++k) {
    Random random(seed * 0x9e3779b9u + k);
    Walk walk;
    walk.speed = inRange(random, 0.9, 1.5);
    walk.beside = {inRange(random, -ways.halfWidth, ways.halfWidth), inRange(random, -ways.halfWidth, ways.halfWidth)};
    walk.height = inRange(random, 1.6, 1.88);
    walk.shirt = looks[(k + random.below(2)) % looks.size()];
    walk.trousers = trousers[random.below(trousers.size())];
    size_t from = random.below(ways.places.size());
    size_t to = ways.neighbours[from][random.below(ways.neighbours[from].size())];
    // It begins somewhere on its first way.
    const double begin = inRange(random, 0, 0.9);
    walk.points = {ways.places[from] + (ways.places[to] - ways.places[from]) * begin};
    walk.lengths = {0};
    while (walk.lengths.back() < walk.speed * seconds + 1) {
      walk.lengths.push_back(walk.lengths.back() + glm::length(ways.places[to] - walk.points.back()));
      walk.points.push_back(ways.places[to]);
      const std::vector<size_t>& next = ways.neighbours[to];
      size_t choice = next[random.below(next.size())];
      if (choice == from && next.size() > 1) {
        choice = next[(random.below(next.size() - 1) + 1 +
                       static_cast<size_t>(std::find(next.begin(), next.end(), from) - next.begin())) %
                      next.size()];
      }
      from = to;
      to = choice;
    }
    walks_.push_back(std::move(walk));
  }
}

glm::dvec2 Walkers::placeAlong(const Walk& walk, double length) const {
  const double along = std::clamp(length, 0.0, walk.lengths.back());
  const auto after = std::upper_bound(walk.lengths.begin() + 1, walk.lengths.end() - 1, along);
  const auto i = static_cast<size_t>(after - walk.lengths.begin());
  const double share = (along - walk.lengths[i - 1]) / std::max(walk.lengths[i] - walk.lengths[i - 1], 1e-9);
  return walk.points[i - 1] + (walk.points[i] - walk.points[i - 1]) * share + walk.beside;
}

WalkerState Walkers::at(size_t walker, double seconds) const {
  const Walk& walk = walks_[walker];
  const double length = walk.speed * seconds;
  WalkerState state;
  state.place = placeAlong(walk, length);
  const glm::dvec2 ahead = placeAlong(walk, length + kTurnReach) - placeAlong(walk, length - kTurnReach);
  state.heading = std::atan2(ahead.x, ahead.y);
  state.phase = kPi * length / kStepLength;
  return state;
}

Mesh Walkers::meshAt(double seconds, std::vector<uint8_t>& walkerOfTriangle) const {
  Mesh all;
  walkerOfTriangle.clear();
  for (size_t k = 0; k < walks_.size(); ++k) {
    const WalkerState state = at(k, seconds);
    Mesh figure = figureAt(state.phase, walks_[k].shirt, walks_[k].trousers);
    const auto scale = static_cast<float>(walks_[k].height / 1.75);
    glm::mat4 worldFromFigure = glm::translate(glm::mat4(1), {state.place.x, 0, state.place.y});
    worldFromFigure = glm::rotate(worldFromFigure, static_cast<float>(state.heading), {0, 1, 0});
    append(all, figure, glm::scale(worldFromFigure, glm::vec3(scale)));
    walkerOfTriangle.resize(all.triangles.size(), static_cast<uint8_t>(k));
  }
  if (!all.empty()) {
    bakeLambert(all);
  }
  return all;
}

}  // namespace ocelli
