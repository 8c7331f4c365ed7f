// What a client holds, which image it draws a view from, and when it asks for another one (section 5.2.1): the
// reference for the client of the page, without sockets, clocks and windows. It is told the wanted view at each frame,
// and each image when its bytes have come.
//
// Which image. Of those it holds one that covers the view from its own eye, as there pictures are exact; else, or of
// several, the one with the least load for the view (image_cover.h); of equals the newest. It holds `maxImages`, and
// gives up the one that was drawn from longest ago.
//
// When it asks. At each frame, with the view V wanted now, and its motion over the last `motionSeconds`:
//   1. Nothing held and nothing asked: ask for V.
//   2. Moving. P is where V will be after `trip` + `aheadSeconds`, at most `maxAheadSeconds`, as viewAhead() has it;
//      `trip` is how long the last image took from the request to its last byte. If the best held image has a load of
//      more than `askAt` at P, and no image that was asked for will cover P, ask for P.
//   3. At rest for `restSeconds`, where the best held image has another eye, fewer samples than a pixel in the middle,
//      or does not cover V, and V was not asked for already: ask for V.
// A request follows the last one by at least `pauseSeconds`, but for the first, and there are at most `maxRequests`.
// The server draws the newest one that it has not begun (docs/remote_protocol.md), so those in between cost nothing.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "oc_core/remote/client/image_cover.h"
#include "oc_core/remote/client/quick_image.h"
#include "oc_core/remote/client/view_motion.h"

namespace ocelli {

struct ClientRule {
  CoverLimits limits;
  double askAt = 0.95;            ///< of the load that ends what is covered
  double firstTripSeconds = 0.5;  ///< taken for the trip until an image has come
  double aheadSeconds = 0.25;
  double maxAheadSeconds = 4;
  double restSeconds = 0.3;
  double motionSeconds = 0.1;
  double pauseSeconds = 0.25;
  size_t maxImages = 4;
  size_t maxRequests = 0;  ///< 0: as many as it takes
};

/// A request as the client makes it; the caller adds what else goes into a message.
struct ImageWish {
  uint32_t sequence = 0;
  View view;
};

struct ClientImage {
  uint32_t sequence = 0;  ///< of the request that it answers
  bool hasDepth = false;
  std::shared_ptr<const QuickImage> quick;
  ImageCover cover;
  double usedAt = 0;
};

/// What a client draws from, of an answer: most of what taking one in costs. Any thread may make it.
ClientImage clientImageOf(uint32_t sequence, const ReferenceImage& image, bool hasDepth);

class RemoteClient {
 public:
  /// What an image that is asked for at a view will cover: its pinhole and its layout.
  using Plan = std::function<ImageCover(const View& view)>;
  RemoteClient(const glm::ivec2& screen, Plan plan, const ClientRule& rule = {});

  /// The view wanted at a moment that is no earlier than the one before; a request to send, or nothing.
  std::optional<ImageWish> look(const View& view, double seconds);
  /// The answer to a request; without depth first, then once more with it.
  void receive(ClientImage image, double seconds);
  void receive(uint32_t sequence, const ReferenceImage& image, bool hasDepth, double seconds) {
    receive(clientImageOf(sequence, image, hasDepth), seconds);
  }

  /// The image that a view is drawn from, and its load; null where there is none.
  struct Choice {
    const ClientImage* image = nullptr;
    CoverLoad load;
  };
  Choice choose(const View& view) const;
  /// A picture of the view from that image; background alone where there is none.
  Image<Rgb8> draw(const View& view) const;

  const glm::ivec2& screen() const { return screen_; }
  const ClientRule& rule() const { return rule_; }
  size_t heldImages() const { return images_.size(); }
  double tripSeconds() const { return tripSeconds_; }

 private:
  struct Asked {
    ImageWish wish;
    ImageCover cover;
    double seconds = 0;
  };
  std::optional<View> wanted(const View& view, const Choice& now, double seconds) const;
  bool isAskedFor(const View& view) const;
  ViewMotion motionAt(const View& view, double seconds) const;

  glm::ivec2 screen_;
  Plan plan_;
  ClientRule rule_;
  std::vector<ClientImage> images_;
  std::deque<Asked> asked_;  ///< those that have not been answered, nor overtaken by an answer
  std::deque<std::pair<double, View>> past_;
  double tripSeconds_;
  double lastAsked_ = 0;
  double restingSince_ = 0;
  std::optional<View> lastWish_;
  uint32_t sequence_ = 0;
};

}  // namespace ocelli
