// What a client showed while a path was played over a link: at each frame of the path, which of its views was on the
// screen; and what follows from that: how far behind it was, and for how long.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "oc_core/image/png_file.h"
#include "oc_core/remote_measure/remote_path.h"

namespace ocelli {

struct ShownView {
  std::optional<size_t> frame{};  ///< of the path; nothing before the first picture
  bool isCovered = true;  ///< the client's image covers the view (image_cover.h); frames from a server are exact

  bool operator==(const ShownView&) const = default;
};

struct Playback {
  std::vector<ShownView> shown;                 ///< one for each frame of the path
  size_t bytes = 0;                             ///< sent to the client
  size_t images = 0;                            ///< or frames
  std::optional<double> firstPictureSeconds{};  ///< nothing where no picture came while the path lasted
  double clientFrameSeconds = 0;                ///< to draw a picture; 0 where the client only shows what has come
  double clientDecodeSeconds = 0;  ///< from the bytes of an image to what is drawn from, on average; 0 for frames
};

/// Called with each picture that is to be judged: the frame of the path at which it is on the screen. Before the first
/// picture the screen is black.
using PictureSink = std::function<void(size_t frame, const Image<Rgb8>& picture)>;

inline constexpr double kMaxStillSeconds = 0.1;  ///< more is a stall

/// How old what is shown is at each frame of the path: 0 where the view is the one wanted, and covered. Uncovered, the
/// time since it was covered last; before anything was, since the path began.
std::vector<double> lagsOf(const RemotePath& path, const std::vector<ShownView>& shown);

struct StallFigures {
  double longestSeconds = 0;
  size_t count = 0;
  double totalSeconds = 0;
};
/// Times of more than kMaxStillSeconds in which no other covered view comes on the screen, though the one wanted is not
/// there. What comes late, but on and on, is no stall; the wait for the first picture is one. `onlyCovered` counts
/// those alone in which a covered view is on the screen.
StallFigures stallsOf(const RemotePath& path, const std::vector<ShownView>& shown, bool onlyCovered);

/// Different views that were shown, a second of the path.
double viewsPerSecond(const RemotePath& path, const std::vector<ShownView>& shown);
/// Of the frames that show a picture; 0 where none does.
double coveredShare(const std::vector<ShownView>& shown);

}  // namespace ocelli
