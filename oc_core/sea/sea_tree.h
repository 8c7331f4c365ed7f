// The hierarchy of a sea (section 3.5.4.2.1): edges of the triangulation collapse, the shortest first, and of the two
// images at its ends one stands for both from then on.
//
// The text's nodes are these: the image that stays is an I-node with an N-node below it, which points back to it; the
// one that goes is a P-node, a residual against it. Here a P-node names its reference, and N-nodes need not be stored.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// The three ways to get an image (section 3.5.4.2.3).
enum class SeaWay : uint8_t {
  kRoot = 0,      ///< residuals against the nearest ancestor; one I-node for all
  kIndirect = 1,  ///< the same; I-nodes every so many levels of the tree
  kDirect = 2,    ///< residuals against the nearest I-node: one addition an image
};

/// How files and options say it.
std::string_view nameOf(SeaWay way);
std::span<const SeaWay> allSeaWays();

struct SeaNode {
  static constexpr uint32_t kNone = 0xffffffffu;

  uint32_t parent = kNone;     ///< the image that it collapsed onto; none: the root of all
  uint32_t reference = kNone;  ///< the image that its residual is against; none: an I-node
  uint32_t additions = 0;      ///< of residuals, to have this image
};

struct SeaTree {
  std::vector<SeaNode> nodes;   ///< one an image
  std::vector<uint32_t> order;  ///< all images, each after its reference, and those of an I-node in a row
};

/// `spacing`: the most levels of the tree below an I-node (text: 4); 0: every image is an I-node. Of kRoot it means
/// nothing. At least one position. The same positions give the same tree.
SeaTree makeSeaTree(std::span<const glm::dvec3> positions, SeaWay way, int spacing);

}  // namespace ocelli
