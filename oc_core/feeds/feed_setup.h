// The setup of a graph camera from video (section 4.3.3): which feeds there are, where their cameras stand, and which
// frustum each one is. The JSON form is what `ocelli feeds run SETUP.json` takes; feeds_setup.schema.json describes it.
//
// A frustum is a feed: the rays of its camera, beyond its near face. The near face is a quad in the world, such as the
// opening of a corridor; it is seen by the frustum's parent, in whose image it is filled with the feed. The root has no
// near face. Lengths are in metres, y is up.
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/feeds/feed_lens.h"
#include "oc_core/feeds/known_places.h"

namespace ocelli {

inline constexpr int kMaxFeedPixels = 8192;  ///< a side

/// Where a camera stands and how it is turned.
struct FeedPose {
  glm::dvec3 eye{0};
  glm::dvec3 target{0, 0, -1};
  glm::dvec3 up{0, 1, 0};

  /// The axes of the camera: unit vectors in the world.
  glm::dvec3 forward() const;
  glm::dvec3 right() const;
  glm::dvec3 down() const;
  bool operator==(const FeedPose&) const = default;
};

struct Feed {
  std::string name;
  /// A file, whose relative path begins at the setup, "v4l2:/dev/video0", or a URL, as FFmpeg takes it.
  std::string source;
  std::vector<std::string> ffmpegOptions;  ///< "name=value": how FFmpeg opens it
  double framesPerSecond = 0;              ///< what a v4l2 camera is asked for; 0 leaves it to the camera
  int width = 640;
  int height = 480;
  FeedLens lens;
  FeedPose pose;
  double clockOffsetSeconds = 0;  ///< its timestamps are the time of the place plus this
  std::string background;         ///< an image of what it sees without subjects; empty: it learns one

  bool operator==(const Feed&) const = default;
};

/// One frustum of the graph camera.
struct FeedFrustum {
  std::string feed;                  ///< by name; each feed is one frustum or none
  std::string parent;                ///< the feed of the frustum before it; empty for the root
  std::array<glm::dvec3, 4> near{};  ///< corners of its near face, around it; nothing for the root

  bool isRoot() const { return parent.empty(); }
  bool operator==(const FeedFrustum&) const = default;
};

/// The composed image: a pinhole at the place of the root's camera.
struct FeedOutput {
  int width = 640;
  int height = 480;
  double fovVerticalDegrees = 45;
  glm::dvec3 target{0};  ///< where it looks

  bool operator==(const FeedOutput&) const = default;
};

struct FeedSetup {
  std::vector<Feed> feeds;
  std::vector<FeedFrustum> frusta;  ///< once read: parents before children, the root first
  FeedOutput output;
  double floorHeight = 0;   ///< y of the floor that subjects stand on
  double fadeMetres = 0.3;  ///< subjects fade over this far before and beyond a near face
  KnownPlaces places;       ///< what poses were found by, so that runs see whether cameras have moved

  /// The index of a feed by its name; -1 where there is none.
  int feedIndex(const std::string& name) const;
  bool operator==(const FeedSetup&) const = default;
};

/// Whether a source is a file, and neither empty, a camera nor a URL.
bool isFeedFile(const std::string& source);

/// Throws InputError, naming the field, where a file is no setup: also where there is no root or more than one, where
/// frusta are their own ancestors, where a feed or a parent is unknown, places name no feed, or where a near face is
/// not flat.
FeedSetup readFeedSetup(const std::filesystem::path& path);
FeedSetup feedSetupFromJsonText(const std::string& text, const std::string& where);
std::string jsonText(const FeedSetup& setup);
/// Its files stay those that they are: relative paths begin at the folder of `path`. Throws WorkError where it cannot
/// be written.
void writeFeedSetup(FeedSetup setup, const std::filesystem::path& path);

/// Puts frusta into the order of the tree. Throws as above for what is no tree.
void orderFrusta(FeedSetup& setup, const std::string& where);

}  // namespace ocelli
