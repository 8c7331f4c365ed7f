// The pictures of the lens pane, on a thread of their own, the newest wish first. While something moves they are as
// large as can be drawn within kLensFrameSeconds, measured; then whole.
#pragma once

#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "display_sim/viewer/lens_painter.h"

namespace ocelli {

struct LensPicture {
  LensWanted wanted;
  bool isWhole = false;  ///< as large as wanted
  Image<Rgb8> image;
  double milliseconds = 0;  ///< that it took
};

struct LensStatus {
  bool busy = false;
  std::string error;                           ///< why there is no picture
  std::shared_ptr<const LensPicture> picture;  ///< the newest; null: none
};

/// Which of these sizes a moving picture has, from the seconds that pictures of each took last, whole ones first; 0:
/// not known. The largest that is known, or likely, to take `seconds` at most; else the largest that takes hardly
/// longer than the fastest one.
size_t lensPreviewSize(std::span<const double> secondsOfSizes, double seconds);

class LensWork {
 public:
  static constexpr double kLensFrameSeconds = 0.1;
  static constexpr std::array kLensScales{1.0, 0.5, 0.25};

  LensWork();
  /// Waits for the picture that is under way.
  ~LensWork();
  LensWork(const LensWork&) = delete;
  LensWork& operator=(const LensWork&) = delete;

  void want(const LensWanted& wanted);
  LensStatus status() const;
  /// Until the whole picture of what is wanted is there.
  void waitUntilIdle();

 private:
  void run();
  void make(const LensWanted& wanted, LensPainter& painter);
  /// Draws one size, and publishes it.
  void draw(const LensWanted& wanted, size_t scale, LensPainter& painter);
  bool isStillWanted(const LensWanted& wanted) const;

  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable changed_;
  LensWanted wanted_;
  bool fresh_ = false;  ///< wanted_ has not been looked at
  bool busy_ = false;
  bool hurry_ = false;  ///< someone waits
  bool stop_ = false;
  LensStatus status_;

  // Of the thread alone.
  std::array<double, kLensScales.size()> seconds_{};  ///< as of lensPreviewSize()
  std::thread thread_;
};

}  // namespace ocelli
