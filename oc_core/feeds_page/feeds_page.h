// A page that shows the composed image as it is made, to this computer alone (oc_core/local_server/).
//
// The image is a stream of JPEG files (multipart/x-mixed-replace, "MJPEG"), which browsers show by themselves. Each
// browser is served by a thread of its own and gets the latest image there is, so that a slow one holds nobody up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// What the page says of a feed.
struct PageFeed {
  std::string text;
  bool isGood = true;  ///< others stand out
};

class FeedsPage {
 public:
  /// Serves until it is destroyed. Port 0 takes a free one. `title` is what the page says above the image. Throws
  /// WorkError where the port is in use, or may not be used.
  FeedsPage(int port, const std::string& title);
  ~FeedsPage();
  FeedsPage(const FeedsPage&) = delete;
  FeedsPage& operator=(const FeedsPage&) = delete;

  int port() const;
  /// "http://127.0.0.1:8765/".
  std::string address() const;

  /// The next image, and a line on each feed. Copies them; nobody is waited for.
  void show(const Image<Rgb8>& image, const std::vector<PageFeed>& feeds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
