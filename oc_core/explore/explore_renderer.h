// Pictures of the explorer's frames, on the CPU: as rasterisation gives them, with what is kept from frame to frame.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "oc_core/explore/explore_frame.h"
#include "oc_core/explore/explore_scene.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// A frame, drawn.
struct ExplorePicture {
  Image<Rgb8> image;
  std::optional<Image<Rgb8>> pinhole;  ///< where it was asked for
  int frame = -1;                      ///< its number
};

class ExploreRenderer {
 public:
  /// The scene must outlive it.
  explicit ExploreRenderer(const ExploreScene& scene);

  /// Remembers the picture: frames dissolve from those before, so they come in their order.
  ExplorePicture draw(const ExploreFrame& frame, bool pinholeBeside = false);
  /// How many images of cameras draw(frame) has drawn: one that stands still takes one.
  int drawnCameras() const { return drawnCameras_; }
  /// One camera by itself.
  Image<Rgb8> draw(const MultiperspectiveCamera& camera) const;

 private:
  /// Of the frame's camera, which may be known.
  Image<Rgb8> imageOf(const ExploreFrame& frame);

  const ExploreScene& scene_;
  std::vector<Rgb8> vertexColors_;  ///< sRGB
  /// Of the camera that stands still, without what is drawn over it.
  std::shared_ptr<const void> still_;
  Image<Rgb8> stillImage_;
  Image<Rgb8> last_;
  Image<Rgb8> dissolving_;
  int dissolvingFrom_ = -1;
  int drawnCameras_ = 0;
};

/// Draws on a thread of its own, the newest frame first, so that who walks never waits.
class ExploreDrawing {
 public:
  explicit ExploreDrawing(const ExploreScene& scene);
  /// Waits for what is being drawn.
  ~ExploreDrawing();
  ExploreDrawing(const ExploreDrawing&) = delete;
  ExploreDrawing& operator=(const ExploreDrawing&) = delete;

  void want(const ExploreFrame& frame, bool pinholeBeside = false);
  /// The newest picture since the last call; nothing where there is none.
  std::optional<ExplorePicture> take();
  /// Until the newest frame is drawn.
  void waitUntilIdle();

 private:
  void run();

  ExploreRenderer renderer_;
  std::mutex mutex_;  ///< guards what follows
  std::condition_variable changed_;
  std::optional<ExploreFrame> wanted_;
  bool pinholeBeside_ = false;
  bool busy_ = false;
  bool stop_ = false;
  std::optional<ExplorePicture> done_;
  std::thread thread_;
};

}  // namespace ocelli
