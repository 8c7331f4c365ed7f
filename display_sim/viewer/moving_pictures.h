// Pictures of what moves, on a thread of their own, the newest wish first. While something moves they are as large as
// can be drawn within kFrameSeconds, measured; once it has stood still for kStillSeconds they are whole.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>

#include "display_sim/viewer/error_message.h"
#include "display_sim/viewer/newest_wish.h"
#include "oc_core/base/progress.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

template <class Wanted>
struct MovingPicture {
  Wanted wanted;
  bool isWhole = false;  ///< as large as wanted
  Image<Rgb8> image;
  double milliseconds = 0;  ///< that it took
};

template <class Wanted>
struct MovingPictureStatus {
  bool busy = false;
  std::string error;                                     ///< why there is no picture
  std::shared_ptr<const MovingPicture<Wanted>> picture;  ///< the newest; null: none
};

/// Which of some sizes a moving picture has, each half as wide as the one before, from the seconds that pictures of
/// each took last, whole ones first; 0: not known. The largest that is known, or likely, to take `seconds` at most;
/// else the largest that takes hardly longer than the fastest one.
size_t movingPictureSize(std::span<const double> secondsOfSizes, double seconds);

/// `Wanted`: canBePainted(), the `size` of a whole picture in pixels, and ==. `Painter`:
///   static constexpr std::array kScales{1.0, 0.5, ...};  // widths, as shares of a whole picture's
///   static constexpr bool kStartsSmall;                  // whether the first one is, of which nothing is known
///   Image<Rgb8> paint(const Wanted&, const glm::ivec2& size, const Progress&);   // `progress` may throw
/// A default Painter keeps no memory of what it has painted.
template <class Wanted, class Painter>
class MovingPictures {
 public:
  static constexpr double kFrameSeconds = 0.1;
  static constexpr double kStillSeconds = 0.15;

  MovingPictures() : wishes_([this](const Wanted& wanted) { make(wanted); }) {}

  void want(const Wanted& wanted) { wishes_.want(wanted); }
  MovingPictureStatus<Wanted> status() const { return wishes_.status(); }
  /// Until the whole picture of what is wanted is there.
  void waitUntilIdle() { wishes_.waitUntilIdle(); }

 private:
  using Status = MovingPictureStatus<Wanted>;
  /// Thrown through a whole picture that a newer wish has made useless.
  struct Overtaken {};

  void make(const Wanted& wanted) {
    if (!wanted.canBePainted()) {
      painter_ = {};  // gives its memory back
      seconds_ = {};
      wishes_.change([](Status& status) { status = {}; });
      return;
    }
    try {
      const size_t first = wishes_.someoneWaits() ? 0 : firstSize();
      draw(wanted, first, {});  // never broken off, so that a picture comes of what moves without a rest
      if (first > 0 && wishes_.standsStill(wanted, kStillSeconds)) {
        draw(wanted, 0, [&](std::string_view, double) {
          if (!wishes_.isNewest(wanted)) {
            throw Overtaken{};
          }
        });
      }
    } catch (const Overtaken&) {  // there is something else to draw
    } catch (const std::exception&) {
      const std::string error = errorMessage(std::current_exception());
      wishes_.change([&](Status& status) {
        status.picture = nullptr;
        status.error = error;
      });
    }
  }

  size_t firstSize() const {
    const bool knowsNothing = std::ranges::all_of(seconds_, [](double seconds) { return seconds <= 0; });
    return knowsNothing && Painter::kStartsSmall ? seconds_.size() - 1 : movingPictureSize(seconds_, kFrameSeconds);
  }

  /// Draws one size, and publishes it.
  void draw(const Wanted& wanted, size_t scale, const Progress& progress) {
    const glm::ivec2 size =
        glm::max(glm::ivec2(glm::round(glm::dvec2(wanted.size) * Painter::kScales[scale])), glm::ivec2(1));
    const auto start = std::chrono::steady_clock::now();
    MovingPicture<Wanted> picture{wanted, scale == 0, painter_.paint(wanted, size, progress), 0};
    seconds_[scale] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    picture.milliseconds = 1000 * seconds_[scale];
    const auto drawn = std::make_shared<const MovingPicture<Wanted>>(std::move(picture));
    wishes_.change([&](Status& status) {
      status.picture = drawn;
      status.error.clear();
    });
  }

  // Of the thread alone.
  Painter painter_;
  std::array<double, Painter::kScales.size()> seconds_{};  ///< as of movingPictureSize()
  NewestWish<Wanted, Status> wishes_;
};

}  // namespace ocelli
