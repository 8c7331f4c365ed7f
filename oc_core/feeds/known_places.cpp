#include "oc_core/feeds/known_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/feeds/feed_fields.h"

namespace ocelli {
namespace {

constexpr const char* kPlacesSchema = "oc_core/feeds/known_places.schema.json";
constexpr double kMaxPixel = 1e5;
constexpr int kMaxTagId = static_cast<int>(kMaxKnownTags) - 1;
/// Sides and diagonals of a tag that was measured agree to within this share.
constexpr double kSquareness = 0.05;

std::array<glm::dvec3, 4> readTagCorners(JsonFields& fields) {
  const std::array<glm::dvec3, 4> corners = readFeedCorners(fields, "corners");
  const double side = glm::distance(corners[0], corners[1]);
  const double diagonal = std::sqrt(2.0) * side;
  const auto differs = [&](double length, double wanted) {
    return !(std::abs(length - wanted) <= kSquareness * wanted);
  };
  bool isSquare = side > 0 && !differs(glm::distance(corners[0], corners[2]), diagonal) &&
                  !differs(glm::distance(corners[1], corners[3]), diagonal);
  for (size_t i = 0; i < corners.size(); ++i) {
    isSquare = isSquare && !differs(glm::distance(corners[i], corners[(i + 1) % corners.size()]), side);
  }
  if (!isSquare) {
    fields.fail("corners", "are no square: give them one after another around the tag, measured to within 5 % of it");
  }
  return corners;
}

std::array<glm::dvec3, 4> readCenteredSquare(JsonFields& fields, double size) {
  const glm::dvec3 center = readFeedPoint(fields, "center");
  const glm::dvec3 normal = readFeedPoint(fields, "normal");
  const glm::dvec3 upGiven = fields.has("up") ? readFeedPoint(fields, "up") : glm::dvec3(0, 1, 0);
  if (!(glm::length(normal) > 0)) {
    fields.fail("normal", "has no length");
  }
  const glm::dvec3 across = glm::cross(upGiven, normal);
  if (!(glm::length(across) > 1e-6 * glm::length(upGiven) * glm::length(normal))) {
    fields.fail("up", "is along the normal, or has no length: give what is up on the tag");
  }
  const glm::dvec3 right = glm::normalize(across) * (size / 2);
  const glm::dvec3 up = glm::normalize(glm::cross(normal, across)) * (size / 2);
  return {center - right + up, center + right + up, center + right - up, center - right - up};
}

KnownTag readTag(JsonFields& fields, double commonSize) {
  KnownTag tag;
  tag.id = fields.integer("id", 0, kMaxTagId);
  const bool hasSize = fields.has("size");
  const double size = hasSize ? fields.number("size", 1e-3, 100) : commonSize;
  tag.seenBy = fields.texts("seen_by", 0, kMaxFeeds, kMaxFeedNameLength);
  if (fields.has("corners")) {
    if (fields.has("center") || fields.has("normal") || hasSize) {
      fields.fail("corners", "say all of a tag: leave out center, normal, up and size, or the corners");
    }
    tag.corners = readTagCorners(fields);
    return tag;
  }
  if (!(size > 0)) {
    fields.fail("size", "is missing, and there is no \"tag_size\" of all tags");
  }
  tag.corners = readCenteredSquare(fields, size);
  return tag;
}

}  // namespace

KnownPlaces readPlacesFields(JsonFields fields) {
  KnownPlaces places;
  const double commonSize = fields.has("tag_size") ? fields.number("tag_size", 1e-3, 100) : 0;
  std::set<int> ids;
  fields.forEach("tags", 0, kMaxKnownTags, [&](JsonFields& each) {
    places.tags.push_back(readTag(each, commonSize));
    if (!ids.insert(places.tags.back().id).second) {
      each.fail("id", fmt::format("is {}, which another tag has", places.tags.back().id));
    }
  });
  fields.forEach("corners", 0, kMaxClickedCorners, [&](JsonFields& each) {
    ClickedCorner corner;
    corner.feed = each.shortText("feed", kMaxFeedNameLength);
    const std::vector<double> pixel = each.numbers("pixel", 2, -kMaxPixel, kMaxPixel);
    corner.pixel = {pixel[0], pixel[1]};
    corner.point = readFeedPoint(each, "point");
    places.corners.push_back(corner);
  });
  fields.rejectUnknown();
  return places;
}

nlohmann::ordered_json jsonOfPlaces(const KnownPlaces& places) {
  auto json = nlohmann::ordered_json::object();
  for (const KnownTag& tag : places.tags) {
    nlohmann::ordered_json each{{"id", tag.id}, {"corners", jsonOfCorners(tag.corners)}};
    if (!tag.seenBy.empty()) {
      each["seen_by"] = tag.seenBy;
    }
    json["tags"].push_back(each);
  }
  for (const ClickedCorner& corner : places.corners) {
    json["corners"].push_back(
        {{"feed", corner.feed}, {"pixel", {corner.pixel.x, corner.pixel.y}}, {"point", jsonOfPoint(corner.point)}});
  }
  return json;
}

const KnownTag* KnownPlaces::tag(int id) const {
  const auto found = std::ranges::find(tags, id, &KnownTag::id);
  return found == tags.end() ? nullptr : &*found;
}

glm::dvec3 frontOf(const KnownTag& tag) {
  return glm::normalize(glm::cross(tag.corners[1] - tag.corners[0], tag.corners[0] - tag.corners[3]));
}

KnownPlaces knownPlacesFromJsonText(const std::string& text, const std::string& where) {
  const JsonDocument document(text, where);
  KnownPlaces places = readAs(kPlacesSchema, [&] { return readPlacesFields(JsonFields(document)); });
  if (places.tags.empty() && places.corners.empty()) {
    throw InputError("it names no tags and no corners", where, std::string("see ") + kPlacesSchema);
  }
  return places;
}

KnownPlaces readKnownPlaces(const std::filesystem::path& path) {
  return knownPlacesFromJsonText(readFile(path, kMaxTextBytes), path.string());
}

}  // namespace ocelli
