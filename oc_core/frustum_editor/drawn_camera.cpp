#include "oc_core/frustum_editor/drawn_camera.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "oc_core/base/json_document.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/frustum_editor/drawn_volumes.h"

namespace ocelli {
namespace {

using FileJson = nlohmann::json;

constexpr double kMinSlope = 0.2;       // sine between plane and paper, below which a plan sees a plane from the front
constexpr double kRoundedShare = 1e-5;  // of the scene's diagonal: what coordinates are rounded to, at most
constexpr double kInPlaneShare = 1e-7;  // of the diagonal: corners so near to a plane lie in it
constexpr double kSameEndShare = 1e-3;  // of a plane's width: corners so far from its end belong to the end

glm::dvec3 pointOf(const FileJson& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

DrawnPlane planeOf(const FileJson& json) {
  DrawnPlane drawn;
  drawn.point = pointOf(json.at("point"));
  drawn.plane = Plane::through(drawn.point, pointOf(json.at("normal")));
  drawn.middle = drawn.point;
  return drawn;
}

void setPolygon(DrawnPlane& drawn, std::vector<glm::dvec3> polygon) {
  drawn.polygon = std::move(polygon);
  if (!drawn.polygon.empty()) {
    drawn.middle = meanOf(drawn.polygon);
  }
}

/// Of a graph camera: what stands in its file, and then what its frusta are.
class GraphReader {
 public:
  GraphReader(const GraphCamera& camera, const Box& room) : camera_(camera), room_(room) {}

  std::vector<DrawnFrustum> read(const FileJson& operations) {
    DrawnFrustum root;
    root.name = camera_.frusta()[0].name;
    root.operation = "root";
    frusta_.push_back(root);
    for (const FileJson& operation : operations) {
      add(operation);
    }
    for (const FileJson& operation : operations) {
      if (operation.at("operation") == "limit") {
        frusta_[indexOf(operation.at("of").get<std::string>())].limits.push_back(planeOf(operation.at("plane")));
      }
    }
    for (DrawnFrustum& frustum : frusta_) {
      fill(frustum);
    }
    // Parents may stand behind their children in the file.
    for (bool changes = true; changes;) {
      changes = false;
      for (DrawnFrustum& frustum : frusta_) {
        for (const std::string& name : frustum.of) {
          DrawnFrustum& parent = frusta_[indexOf(name)];
          parent.hasChildren = true;
          if (frustum.depth < parent.depth + 1) {
            frustum.depth = parent.depth + 1;
            changes = true;
          }
        }
      }
    }
    return std::move(frusta_);
  }

 private:
  size_t indexOf(const std::string& name) const {
    const auto found =
        std::find_if(frusta_.begin(), frusta_.end(), [&](const DrawnFrustum& each) { return each.name == name; });
    return static_cast<size_t>(found - frusta_.begin());
  }

  void add(const FileJson& operation) {
    if (!operation.contains("into")) {
      return;
    }
    const FileJson& into = operation["into"];
    const FileJson& of = operation.at("of");
    for (const FileJson& each : into.is_array() ? into : FileJson::array({into})) {
      DrawnFrustum frustum;
      frustum.name = each.at("name").get<std::string>();
      frustum.operation = operation.at("operation").get<std::string>();
      frustum.of = of.is_array() ? of.get<std::vector<std::string>>() : std::vector{of.get<std::string>()};
      frustum.begins = planeOf(each.at("plane"));
      frustum.viewpoint = pointOf(each.at("viewpoint"));
      for (const FileJson& corner : each.value("part", FileJson::array())) {
        frustum.part.emplace_back(corner[0].get<double>(), corner[1].get<double>());
      }
      frusta_.push_back(std::move(frustum));
    }
  }

  /// Behind a merge the camera has two frusta for a name of the file: "behind of left" and "behind of right".
  void fill(DrawnFrustum& frustum) const {
    for (size_t i = 0; i < camera_.frusta().size(); ++i) {
      const std::string& name = camera_.frusta()[i].name;
      const bool isOfMerge = name.starts_with(frustum.name + " of ") && indexOf(name) == frusta_.size();
      if (name == frustum.name || isOfMerge) {
        frustum.indices.push_back(static_cast<int>(i));
      }
    }
    if (frustum.operation == "root") {
      frustum.viewpoint = camera_.frusta()[0].viewpoint;
      frustum.begins.plane = camera_.frusta()[0].plane;
    }
    std::vector<glm::dvec3> crossings;
    glm::dvec3 middle(0);
    for (const int i : frustum.indices) {
      const std::vector<glm::dvec3> some = crossingsOf(camera_, i);
      crossings.insert(crossings.end(), some.begin(), some.end());
      const DrawnRay ray = middleRayOf(camera_, i);
      middle += ray.from / static_cast<double>(frustum.indices.size());
      frustum.direction += ray.direction;
      for (DrawnVolume& volume : graphVolumesOf(camera_, i, room_)) {
        frustum.volumes.push_back(std::move(volume));
      }
    }
    const double length = glm::length(frustum.direction);
    frustum.direction = length > 0 ? frustum.direction / length : frustum.begins.plane.normal;
    // Of a merge the polygon is two; only its hull in plans is used.
    setPolygon(frustum.begins, frustum.indices.size() == 1 ? polygonWithin(crossings, room_) : crossings);
    frustum.begins.middle = middle;
    const double slack = static_cast<double>(glm::length(room_.size())) * kInPlaneShare;
    for (DrawnPlane& limit : frustum.limits) {
      setPolygon(limit, cornersIn(frustum.volumes, limit.plane, slack));
    }
  }

  const GraphCamera& camera_;
  const Box& room_;
  std::vector<DrawnFrustum> frusta_;
};

std::vector<DrawnFrustum> curvedFrusta(const CurvedRayCamera& camera, const FileJson& turns, const Box& room) {
  std::vector<DrawnVolume> volumes = curvedVolumesOf(camera, room);
  std::vector<DrawnFrustum> frusta(1);
  frusta[0].name = frusta[0].operation = "root";
  frusta[0].viewpoint = glm::dvec3(camera.root().eye());
  frusta[0].direction = glm::dvec3(camera.root().forward());
  frusta[0].begins.middle = frusta[0].viewpoint;
  frusta[0].begins.plane = Plane::through(frusta[0].viewpoint, frusta[0].direction);
  frusta[0].volumes = {volumes[0]};
  frusta[0].hasChildren = !turns.empty();
  for (size_t k = 0; k < turns.size(); ++k) {
    const RayTransition& bend = camera.bends()[k];
    DrawnFrustum turn;
    turn.name = turns[k].value("name", "");
    turn.operation = "turn";
    turn.of = {frusta.back().name};
    turn.depth = static_cast<int>(k) + 1;
    turn.hasChildren = k + 1 < turns.size();
    turn.indices = {static_cast<int>(k)};
    turn.viewpoint = bend.beyond();
    const std::array<std::vector<glm::dvec3>, 3> crossings = crossingsOfBend(camera, k);
    const std::array<const char*, 3> fields{"from", "middle", "to"};
    for (size_t j = 0; j < fields.size(); ++j) {
      turn.turn.push_back(planeOf(turns[k].at(fields[j])));
      setPolygon(turn.turn.back(), crossings[j]);
    }
    turn.begins = turn.turn[1];
    const glm::dvec3 ahead = turn.begins.middle - turn.viewpoint;
    turn.direction = glm::length(ahead) > 0 ? glm::normalize(ahead) : turn.begins.plane.normal;
    turn.turnLineDirection = glm::normalize(bend.lineDirection());
    turn.turnLine = bend.linePoint() +
                    turn.turnLineDirection * glm::dot(turn.begins.middle - bend.linePoint(), turn.turnLineDirection);
    turn.volumes = {volumes[2 * k + 1], volumes[2 * k + 2]};
    frusta.push_back(std::move(turn));
  }
  return frusta;
}

std::vector<DrawnOverlap> overlapsIn(const GraphCamera& camera, const Box& world) {
  std::vector<DrawnOverlap> drawn;
  for (const FrustumOverlap& overlap : overlapsOf(camera, glm::dvec3(world.lower), glm::dvec3(world.upper))) {
    drawn.push_back({camera.frusta()[static_cast<size_t>(overlap.first)].name,
                     camera.frusta()[static_cast<size_t>(overlap.second)].name, overlap.point,
                     commonVolumesOf(camera, overlap.first, overlap.second, world)});
  }
  return drawn;
}

double crossOf(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

glm::dvec2 DrawnCamera::imageSize() const {
  return std::visit([](const auto& each) { return glm::dvec2(each.width(), each.height()); }, *camera);
}

const DrawnFrustum* DrawnCamera::find(const std::string& name) const {
  const auto found =
      std::find_if(frusta.begin(), frusta.end(), [&](const DrawnFrustum& each) { return each.name == name; });
  return found == frusta.end() ? nullptr : &*found;
}

std::string DrawnCamera::freeName() const {
  const std::string stem = isGraph() ? "frustum " : "turn ";
  for (size_t number = 1;; ++number) {
    if (std::string name = stem + std::to_string(number); find(name) == nullptr) {
      return name;
    }
  }
}

DrawnCamera drawnCamera(const std::string& text, const MultiperspectiveCamera& camera, const Box& world) {
  const FileJson json = FileJson::parse(text, nullptr, true, true);
  DrawnCamera drawn;
  drawn.camera = std::make_shared<const MultiperspectiveCamera>(camera);
  const PinholeCamera& root = std::visit([](const auto& each) -> const PinholeCamera& { return each.root(); }, camera);
  drawn.view = root.view();
  drawn.room = world;
  drawn.room.add(root.eye());
  drawn.rounding = std::pow(
      10.0, std::floor(std::log10(std::max(1e-12, static_cast<double>(glm::length(world.size()))) * kRoundedShare)));
  drawn.overlapAllowed = json.value("overlap", "refused") == "allowed";
  if (drawn.isGraph()) {
    drawn.frusta = GraphReader(drawn.graph(), drawn.room).read(json.at("operations"));
    drawn.overlaps = overlapsIn(drawn.graph(), world);
  } else {
    drawn.frusta = curvedFrusta(std::get<CurvedRayCamera>(*drawn.camera), json.at("turns"), drawn.room);
  }
  return drawn;
}

std::vector<glm::dvec2> outlineOf(const DrawnVolume& points, PlanSide side) {
  std::vector<glm::dvec2> sorted;
  for (const glm::dvec3& point : points) {
    sorted.push_back(paperFromWorld(side, point));
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half) {
    const size_t start = hull.size();
    for (const glm::dvec2& point : sorted) {
      while (hull.size() >= start + 2 && crossOf(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    if (!hull.empty()) {
      hull.pop_back();
    }
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull.size() >= 3 ? hull : std::vector<glm::dvec2>{};
}

bool isWithin(const std::vector<glm::dvec2>& outline, const glm::dvec2& paper) {
  bool within = outline.size() >= 3;
  for (size_t i = 0; i < outline.size() && within; ++i) {
    within = crossOf(outline[(i + 1) % outline.size()] - outline[i], paper - outline[i]) >= 0;
  }
  return within;
}

std::optional<std::array<glm::dvec3, 2>> endsOf(const DrawnPlane& plane, PlanSide side) {
  const glm::dvec3 across = glm::cross(plane.plane.normal, viewAxisOf(side));
  if (plane.polygon.size() < 2 || glm::length(across) < kMinSlope) {
    return std::nullopt;
  }
  const auto along = [&](const glm::dvec3& point) { return glm::dot(point, across); };
  const auto [first, last] = std::minmax_element(plane.polygon.begin(), plane.polygon.end(),
                                                 [&](const auto& a, const auto& b) { return along(a) < along(b); });
  const double low = along(*first);
  const double high = along(*last);
  const double slack = (high - low) * kSameEndShare;
  if (!(high > low)) {
    return std::nullopt;
  }
  std::array<std::vector<glm::dvec3>, 2> ends;
  for (const glm::dvec3& point : plane.polygon) {
    if (along(point) <= low + slack) {
      ends[0].push_back(point);
    } else if (along(point) >= high - slack) {
      ends[1].push_back(point);
    }
  }
  return std::array{meanOf(ends[0]), meanOf(ends[1])};
}

const DrawnFrustum* frustumAt(const DrawnCamera& camera, PlanSide side, const glm::dvec2& paper,
                              const std::string& preferred) {
  const DrawnFrustum* found = nullptr;
  for (const DrawnFrustum& frustum : camera.frusta) {
    const bool holds = std::any_of(frustum.volumes.begin(), frustum.volumes.end(),
                                   [&](const DrawnVolume& volume) { return isWithin(outlineOf(volume, side), paper); });
    if (holds && frustum.name == preferred) {
      return &frustum;
    }
    if (holds && (found == nullptr || frustum.depth > found->depth)) {
      found = &frustum;
    }
  }
  return found;
}

}  // namespace ocelli
