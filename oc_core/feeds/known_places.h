// What is known of the place that cameras are registered to: tags of known size at known places, and corners of the
// box proxy that somebody clicked in the feeds. Metres, y up. The JSON form
// (known_places.schema.json):
//
//   {"tag_size": 0.2,
//    "tags": [{"id": 0, "center": [0, 1.5, -3], "normal": [0, 0, 1], "up": [0, 1, 0]},
//             {"id": 1, "corners": [[...], [...], [...], [...]]}],
//    "corners": [{"feed": "stem", "pixel": [320.5, 200], "point": [0, 0, -3]}]}
//
// "tag_size" is the side of the black border; a tag may have a "size" of its own. Corners of a tag are those of its
// border as printed upright and seen from the front: top left, top right, bottom right, bottom left.
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ocelli {

inline constexpr size_t kMaxFeeds = 64;
inline constexpr size_t kMaxKnownTags = 587;  ///< as many as the family 36h11 has
inline constexpr size_t kMaxClickedCorners = 10000;

struct KnownTag {
  int id = 0;
  std::array<glm::dvec3, 4> corners{};
  std::vector<std::string> seenBy = {};  ///< feeds that saw it when their poses were found

  bool operator==(const KnownTag&) const = default;
};

struct ClickedCorner {
  std::string feed;
  glm::dvec2 pixel{0};  ///< from the top left corner of the image
  glm::dvec3 point{0};

  bool operator==(const ClickedCorner&) const = default;
};

struct KnownPlaces {
  std::vector<KnownTag> tags;
  std::vector<ClickedCorner> corners;

  const KnownTag* tag(int id) const;
  bool operator==(const KnownPlaces&) const = default;
};

/// The unit vector out of the front of a tag.
glm::dvec3 frontOf(const KnownTag& tag);

/// Throws InputError, naming the field, for what is none: a tag twice, without a size, whose up is along its normal, or
/// whose corners are no square.
KnownPlaces readKnownPlaces(const std::filesystem::path& path);
KnownPlaces knownPlacesFromJsonText(const std::string& text, const std::string& where);

}  // namespace ocelli
