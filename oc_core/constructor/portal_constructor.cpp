#include "oc_core/constructor/portal_constructor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/constructor/image_parts.h"
#include "oc_core/constructor/maze_openings.h"

namespace ocelli {
namespace {

using Part = GraphCamera::Part;

constexpr double kFadingShare = 0.75;  // of the farthest distance
/// Rays that turn by less than this share of the way show what straight ones do.
constexpr double kMinPieceShare = 1e-9;
constexpr double kSamePlane = 1e-6;  // relative difference of depths
constexpr size_t kMaxPortals = 256;

/// A point in the frame of a portal, in metres along unit vectors.
struct PortalFrame {
  explicit PortalFrame(const Portal& portal)
      : center(portal.center),
        right(glm::normalize(glm::dvec3(portal.halfRight))),
        up(glm::normalize(glm::dvec3(portal.halfUp))),
        normal(portal.normal) {}

  glm::dvec3 inFrame(const glm::dvec3& point) const {
    const glm::dvec3 p = point - center;
    return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, normal)};
  }

  glm::dvec3 center;
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 normal;
};

double rising(double from, double to, double x) {
  return glm::smoothstep(from, to, x);
}

/// The same, evenly in part: its steepest slope is 3/2 of the least possible, or the least.
double rising(double from, double to, double x, double evenness) {
  const double eased = rising(from, to, x);
  return evenness == 0 ? eased : glm::mix(eased, std::clamp((x - from) / (to - from), 0.0, 1.0), evenness);
}

/// By which rays have turned.
double shareOf(double presence, double handOver) {
  return std::max(0.0, (presence - handOver) / (1 - handOver));
}

/// A portal of the image.
struct SeenPortal {
  const Portal* portal;
  Part part;
  double presence;
  Plane plane;  ///< its normal points in
  double handOver;

  double share() const { return shareOf(presence, handOver); }
  /// What it leaves to those behind it.
  double leaves() const { return std::max(0.0, 1 - presence / handOver); }
};

/// A convex piece of the part of a portal, and what those before it leave of it.
struct Piece {
  Part part;
  double left = 1;
};

/// The z, relative to each other, at which the ray through the middle of a part crosses the plane.
double depthOf(const Plane& plane, const Part& part, const PinholeCamera& camera) {
  const glm::dvec2 offset =
      (GraphCamera::middleOf(part) - glm::dvec2(camera.centerPixels())) / static_cast<double>(camera.focalPixels());
  const glm::dvec3 direction =
      glm::dvec3(camera.forward()) + glm::dvec3(camera.right()) * offset.x + glm::dvec3(camera.down()) * offset.y;
  return -plane.height(glm::dvec3(camera.eye())) / glm::dot(plane.normal, direction);
}

/// Whether rays meet `other` first where both are in the image. Of portals in one plane that is the first of the list.
bool isBehind(const SeenPortal& seen, const SeenPortal& other, const Part& both, const PinholeCamera& camera) {
  const double mine = depthOf(seen.plane, both, camera);
  const double theirs = depthOf(other.plane, both, camera);
  return std::abs(mine - theirs) > kSamePlane * mine ? theirs < mine : other.portal < seen.portal;
}

/// What of a portal turns: its part in pieces, each with what the portals before it there leave.
std::vector<Piece> piecesOf(const SeenPortal& seen, const std::vector<SeenPortal>& all, const PinholeCamera& camera) {
  std::vector<Piece> pieces{{seen.part}};
  for (const SeenPortal& other : all) {
    const Part both = &other == &seen ? Part{} : common(seen.part, other.part);
    if (both.empty() || !isBehind(seen, other, both, camera)) {
      continue;
    }
    std::vector<Piece> parted;
    for (const Piece& piece : pieces) {
      for (const Part& part : less(piece.part, other.part)) {
        parted.push_back({part, piece.left});
      }
      const Part behind = common(piece.part, other.part);
      if (!behind.empty() && other.leaves() > 0) {
        parted.push_back({behind, piece.left * other.leaves()});
      }
    }
    pieces = std::move(parted);
  }
  return pieces;
}

/// Those in front of the eye that are present.
std::vector<SeenPortal> seenPortals(const std::vector<Portal>& portals, const PinholeCamera& camera,
                                    const PortalOptions& options) {
  std::vector<SeenPortal> seen;
  for (const Portal& portal : portals) {
    const double presence = portalPresence(portal, glm::dvec3(camera.eye()), options);
    if (presence > 0) {
      std::vector<glm::dvec3> corners;
      for (const glm::vec3& corner : portal.corners()) {
        corners.emplace_back(corner);
      }
      const Plane plane = Plane::through(glm::dvec3(portal.center), -glm::dvec3(portal.normal));
      SeenPortal each{&portal, imagePart(corners, camera), presence, plane, options.handOver};
      if (!each.part.empty()) {
        seen.push_back(std::move(each));
      }
    }
  }
  return seen;
}

void requireBefore(const Portal& portal, const glm::dvec3& eye, size_t number) {
  const glm::dvec3 p = PortalFrame(portal).inFrame(eye);
  const std::string name = "portal " + std::to_string(number);
  if (p.z < 0 && std::abs(p.z) > 1e-3 * glm::length(p)) {
    throw InputError("the eye is behind the plane of a portal", "portal camera, " + name,
                     "turn its normal to the side of the eye, move the eye, or leave it out");
  }
  if (p.z <= 1e-3 * glm::length(p)) {
    throw InputError("the eye sees a portal edge on", "portal camera, " + name, "move the eye, or leave it out");
  }
}

Portal readPortal(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  Portal portal;
  portal.center = glm::vec3(readVector(fields, "center"));
  const glm::dvec3 normal = readVector(fields, "normal");
  const glm::dvec3 up = fields.has("up") ? readVector(fields, "up") : glm::dvec3(0, 1, 0);
  const double width = fields.number("width", 1e-6, 1e6);
  const double height = fields.number("height", 1e-6, 1e6);
  fields.rejectUnknown();
  if (!(glm::length(normal) > 0) || !(glm::length(glm::cross(normal, up)) > 1e-6 * glm::length(normal))) {
    throw InputError("\"normal\" has no length, or is parallel to \"up\"", where, "turn them apart");
  }
  portal.normal = glm::vec3(glm::normalize(normal));
  const glm::dvec3 right = glm::normalize(glm::cross(up, normal));
  portal.halfRight = glm::vec3(right * (width / 2));
  portal.halfUp = glm::vec3(glm::normalize(glm::cross(normal, right)) * (height / 2));
  return portal;
}

}  // namespace

const std::vector<PortalCurve>& portalCurves() {
  static const std::vector<PortalCurve> curves{
      {"beyond", "bends every portal in view, but for those that are near, or that the eye faces", {}},
      {"band",
       "bends portals in a band of distances and angles, none that is far or nearly edge on",
       {.portals = {},
        .straightWithin = 0.1,
        .bentBeyond = 3,
        .farthest = 12,
        .straightDegrees = 5,
        .bentDegrees = 65,
        .edgeDegrees = 87,
        .edgeFadeDegrees = 4,
        .evenness = 0,
        .handOver = 0.5}},
      {"calm",
       "as \"beyond\", but evenly and farther away, so that images change less from step to step",
       {.portals = {},
        .straightWithin = 0.1,
        .bentBeyond = 3,
        .straightDegrees = 10,
        .bentDegrees = 65,
        .evenness = 1,
        .handOver = 0.75}},
  };
  return curves;
}

const PortalOptions& portalCurve(const std::string& name) {
  const auto found = std::find_if(portalCurves().begin(), portalCurves().end(),
                                  [&](const PortalCurve& curve) { return curve.name == name; });
  if (found == portalCurves().end()) {
    std::string names;
    for (const PortalCurve& curve : portalCurves()) {
      names += names.empty() ? curve.name : std::string(" or ") + curve.name;
    }
    throw InputError("there is no curve of portals \"" + name + "\"", "portal camera, \"curve\"", "use " + names);
  }
  return found->options;
}

double portalPresence(const Portal& portal, const glm::dvec3& eye, const PortalOptions& options) {
  const glm::dvec3 p = PortalFrame(portal).inFrame(eye);
  if (!(p.z > 0)) {
    return 0;
  }
  const glm::dvec2 half(glm::length(portal.halfRight), glm::length(portal.halfUp));
  const glm::dvec2 beside = glm::max(glm::abs(glm::dvec2(p)) - half, 0.0);
  const double distance = glm::length(glm::dvec3(beside, p.z)) / (2 * std::min(half.x, half.y));
  const double degrees = degreesFromRadians(std::atan2(std::abs(p.x), p.z));
  return rising(options.straightWithin, options.bentBeyond, distance, options.evenness) *
         (1 - rising(kFadingShare * options.farthest, options.farthest, distance)) *
         rising(options.straightDegrees, options.bentDegrees, degrees, options.evenness) *
         (1 - rising(options.edgeDegrees - options.edgeFadeDegrees, options.edgeDegrees, degrees));
}

double portalShare(const Portal& portal, const glm::dvec3& eye, const PortalOptions& options) {
  return shareOf(portalPresence(portal, eye, options), options.handOver);
}

glm::dvec3 portalViewpoint(const Portal& portal, const glm::dvec3& eye, double share) {
  const PortalFrame frame(portal);
  const glm::dvec3 p = frame.inFrame(eye);
  const double angle = std::atan2(p.x, p.z) * (1 - share);
  const double distance = std::hypot(p.x, p.z);
  return frame.center + frame.right * (distance * std::sin(angle)) + frame.up * p.y +
         frame.normal * (distance * std::cos(angle));
}

GraphCamera buildPortalCamera(const PortalOptions& options, const SceneGuides& guides, const PinholeCamera& reference) {
  const glm::dvec3 eye(reference.eye());
  for (size_t i = 0; i < options.portals.size(); ++i) {
    requireBefore(options.portals[i], eye, i + 1);
  }
  std::vector<Portal> portals = options.portals.empty() ? guides.portals : options.portals;
  if (portals.empty()) {
    if (!guides.maze) {
      throw InputError("the scene has no portals of its own", "portal camera",
                       "name some in \"portals\", or choose a scene such as builtin:town or builtin:maze");
    }
    portals = openingsInSight(*guides.maze, reference.eye());
  }
  const std::vector<SeenPortal> seen = seenPortals(portals, reference, options);
  GraphCamera camera(reference);
  for (const SeenPortal& each : seen) {
    const std::string name = "portal " + std::to_string(each.portal - portals.data() + 1);
    for (const Piece& piece : each.share() > 0 ? piecesOf(each, seen, reference) : std::vector<Piece>{}) {
      const double share = each.share() * piece.left;
      if (share > kMinPieceShare) {
        camera.bend(GraphCamera::kRoot, {each.plane, portalViewpoint(*each.portal, eye, share)}, name, piece.part);
      }
    }
  }
  return camera;
}

PortalOptions readPortalOptions(JsonFields& fields) {
  PortalOptions options = portalCurve(fields.has("curve") ? fields.text("curve") : portalCurves().front().name);
  options.edgeFadeDegrees = fields.number("edge_fade_degrees", 0.01, 10, options.edgeFadeDegrees);
  options.evenness = fields.number("evenness", 0, 1, options.evenness);
  options.handOver = fields.number("hand_over", 0.01, 0.99, options.handOver);
  return readPortalOptions(fields, options);
}

PortalOptions readPortalOptions(JsonFields& fields, const PortalOptions& curve) {
  PortalOptions options = curve;
  if (fields.has("portals")) {
    const nlohmann::json& list = fields.value("portals");
    if (!list.is_array() || list.empty() || list.size() > kMaxPortals) {
      fields.fail("portals", "must be a list of 1 to 256 portals");
    }
    for (size_t i = 0; i < list.size(); ++i) {
      options.portals.push_back(readPortal(list[i], fields.where() + ", \"portals\" " + std::to_string(i + 1)));
    }
  }
  options.straightWithin = fields.number("straight_within", 0, 1000, options.straightWithin);
  options.bentBeyond = fields.number("bent_beyond", 1e-3, 1001, options.bentBeyond);
  options.farthest = fields.number("farthest", 1e-3, 1e6, options.farthest);
  options.straightDegrees = fields.number("straight_degrees", 0, 89, options.straightDegrees);
  options.bentDegrees = fields.number("bent_degrees", 0.1, 90, options.bentDegrees);
  options.edgeDegrees = fields.number("edge_degrees", 10, 90, options.edgeDegrees);
  const auto checkOrder = [&](double less, const char* lessName, double more, const char* moreName) {
    if (!(less < more)) {
      throw InputError(fmt::format("\"{}\" must be less than \"{}\"", lessName, moreName), fields.where(),
                       "change one of them");
    }
  };
  checkOrder(options.straightWithin, "straight_within", options.bentBeyond, "bent_beyond");
  checkOrder(options.bentBeyond, "bent_beyond", options.farthest, "farthest");
  checkOrder(options.straightDegrees, "straight_degrees", options.bentDegrees, "bent_degrees");
  checkOrder(options.bentDegrees, "bent_degrees", options.edgeDegrees, "edge_degrees");
  return options;
}

}  // namespace ocelli
