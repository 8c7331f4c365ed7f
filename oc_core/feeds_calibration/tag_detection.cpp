#include "oc_core/feeds_calibration/tag_detection.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <map>
#include <memory>

namespace ocelli {
namespace {

constexpr int kMaxHamming = 1;    ///< bits that are put right: more gives tags that are not there
constexpr float kMinMargin = 20;  ///< grey levels between bits and the threshold
/// Where AprilTag's corner stands, by name: it begins at the bottom left and goes around to the right.
constexpr std::array<size_t, 4> kCornerOrder{3, 2, 1, 0};

struct FreeDetector {
  void operator()(apriltag_detector_t* detector) const { apriltag_detector_destroy(detector); }
  void operator()(apriltag_family_t* family) const { tag36h11_destroy(family); }
  void operator()(zarray_t* found) const { apriltag_detections_destroy(found); }
};

}  // namespace

std::vector<SeenTag> tagsIn(const Image<Rgb8>& image) {
  const std::unique_ptr<apriltag_family_t, FreeDetector> family(tag36h11_create());
  const std::unique_ptr<apriltag_detector_t, FreeDetector> detector(apriltag_detector_create());
  apriltag_detector_add_family_bits(detector.get(), family.get(), kMaxHamming);
  detector->quad_decimate = 1;  // at full resolution: corners count, not speed
  detector->nthreads = 1;
  std::vector<uint8_t> gray(image.size());
  for (size_t i = 0; i < gray.size(); ++i) {
    const Rgb8& p = image[i];
    gray[i] = static_cast<uint8_t>((299 * p.r + 587 * p.g + 114 * p.b + 500) / 1000);
  }
  image_u8_t view{image.width(), image.height(), image.width(), gray.data()};
  const std::unique_ptr<zarray_t, FreeDetector> found(apriltag_detector_detect(detector.get(), &view));
  std::map<int, std::vector<SeenTag>> byId;
  for (int i = 0; i < zarray_size(found.get()); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found.get(), i, static_cast<void*>(&detection));
    if (detection->decision_margin < kMinMargin) {
      continue;
    }
    SeenTag tag;
    tag.id = detection->id;
    for (size_t c = 0; c < tag.corners.size(); ++c) {
      const auto& p = detection->p[kCornerOrder[c]];
      tag.corners[c] = {p[0], p[1]};
    }
    byId[tag.id].push_back(tag);
  }
  std::vector<SeenTag> tags;
  for (const auto& [id, seen] : byId) {
    if (seen.size() == 1) {
      tags.push_back(seen[0]);
    }
  }
  return tags;
}

std::vector<SeenTag> meanTags(const std::vector<std::vector<SeenTag>>& images) {
  std::map<int, std::pair<SeenTag, size_t>> sums;
  for (const auto& tags : images) {
    for (const SeenTag& tag : tags) {
      auto& [sum, count] = sums[tag.id];
      sum.id = tag.id;
      ++count;
      for (size_t c = 0; c < tag.corners.size(); ++c) {
        sum.corners[c] += tag.corners[c];
      }
    }
  }
  std::vector<SeenTag> means;
  for (auto& [id, entry] : sums) {
    auto& [sum, count] = entry;
    if (2 * count >= images.size()) {
      for (glm::dvec2& corner : sum.corners) {
        corner /= static_cast<double>(count);
      }
      means.push_back(sum);
    }
  }
  return means;
}

}  // namespace ocelli
