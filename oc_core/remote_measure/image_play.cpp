#include "oc_core/remote_measure/image_play.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "oc_core/base/steady_time.h"
#include "oc_core/remote/remote_image.h"

namespace ocelli {
namespace {

constexpr size_t kPieceBytes = size_t{32} << 10;
constexpr size_t kPieceHeader = 12 + 4;  ///< of the message, and of WebSocket's frame
constexpr int kSizeSteps = 4;

constexpr std::array<ImageMode, 5> kModes{{
    {"gpc", "general pinhole images with depth, wider than the screen and denser in the middle", true,
     [](const RemoteSettings& ours, double) { return ours; }},
    {"di", "plain pinhole images with depth, as wide and of as many bytes", true,
     [](const RemoteSettings& ours, double equalSize) {
       RemoteSettings settings = ours;
       settings.zoom = 1;
       settings.size = equalSize;
       return settings;
     }},
    {"di-pixels", "plain pinhole images with depth, as wide and of as many pixels", true,
     [](const RemoteSettings& ours, double) {
       RemoteSettings settings = ours;
       settings.zoom = 1;
       return settings;
     }},
    {"gpc-zoom", "general pinhole images of the screen's view and size, the middle twice as dense, without depth",
     false,
     [](const RemoteSettings& ours, double) {
       RemoteSettings settings = ours;
       settings.reach = 1;
       settings.size = 1;
       settings.zoom = 2;
       return settings;
     }},
    {"mipmap", "plain images of the screen's view and twice its size along both sides, without depth", false,
     [](const RemoteSettings& ours, double) {
       RemoteSettings settings = ours;
       settings.reach = 1;
       settings.size = 2;
       settings.zoom = 1;
       return settings;
     }},
}};

/// Of a header whose times have as many digits each time.
size_t headerBytes(const std::string& text) {
  RemoteImageHeader header = remoteImageHeaderFromJson(text);
  header.drawSeconds = 0.125;
  header.encodeSeconds = 0.125;
  return jsonText(header).size();
}

double now() {
  return static_cast<double>(steadyNanoseconds()) * 1e-9;
}

/// What is under way to the client.
struct Delivery {
  double seconds = 0;
  uint32_t sequence = 0;
  RemoteImage image;
  bool hasAll = false;
};

/// The server's end of the link.
class ImageServer {
 public:
  ImageServer(const RemoteScene& scene, const RemoteSettings& settings, bool hasDepth, const glm::ivec2& screen,
              std::optional<double> seconds, const LinkSpeed& speed)
      : scene_(scene), settings_(settings), hasDepth_(hasDepth), screen_(screen), seconds_(seconds), link_(speed) {}

  void ask(const ImageWish& wish, double seconds) {
    waiting_.push_back({seconds + link_.speed().oneWaySeconds(), wish});
  }

  /// Begins what it begins by then.
  void runUntil(double seconds, std::deque<Delivery>& deliveries) {
    while (!waiting_.empty()) {
      const double begin = std::max(freeAt_, waiting_.front().arrival);
      if (begin > seconds) {
        return;
      }
      // The newest of those that have come by then.
      while (waiting_.size() > 1 && waiting_[1].arrival <= begin) {
        waiting_.pop_front();
      }
      const ImageWish wish = waiting_.front().wish;
      waiting_.pop_front();
      answer(wish, begin, deliveries);
    }
  }

  size_t sentBytes() const { return link_.sentBytes(); }
  size_t images() const { return images_; }

 private:
  struct Waiting {
    double arrival = 0;
    ImageWish wish;
  };

  void answer(const ImageWish& wish, double begin, std::deque<Delivery>& deliveries) {
    const double from = now();
    RemoteImage image = scene_.answer({wish.sequence, wish.view, screen_, {}}, settings_, ++images_);
    const double ready = begin + seconds_.value_or(now() - from);
    if (!hasDepth_) {
      image.depth.clear();
    }
    const double color =
        link_.arrival(ready, headerBytes(image.headerJson) + kPieceHeader + bytesOnTheWire(image.color.size()));
    const double all = hasDepth_ ? link_.arrival(ready, bytesOnTheWire(image.depth.size())) : color;
    freeAt_ = std::max(ready, link_.freeAt());
    if (hasDepth_) {
      RemoteImage colorOnly = image;
      colorOnly.depth.clear();
      deliveries.push_back({color, wish.sequence, std::move(colorOnly), false});
    }
    deliveries.push_back({all, wish.sequence, std::move(image), true});
  }

  const RemoteScene& scene_;
  const RemoteSettings& settings_;
  bool hasDepth_;
  glm::ivec2 screen_;
  std::optional<double> seconds_;
  VirtualLink link_;
  std::deque<Waiting> waiting_;
  double freeAt_ = 0;
  uint32_t images_ = 0;
};

ImageCover coverOfPlan(const View& view, const glm::ivec2& screen, const RemoteSettings& settings) {
  const RemotePlan plan = planRemoteImage({0, view, screen, {}}, settings);
  return {plan.reference, plan.layout};
}

/// A client that takes longer than a frame to draw shows the view of the frame at which it began.
class DrawingClock {
 public:
  DrawingClock(double frameSeconds, double drawSeconds) : frame_(frameSeconds), draw_(drawSeconds) {}

  /// The frame whose view is on the screen at this one.
  size_t shownAt(size_t frame) const {
    if (draw_ <= frame_) {
      return frame;
    }
    const double seconds = static_cast<double>(frame) * frame_;
    const double drawings = std::floor(seconds / draw_ + 1e-9);
    // The drawing that ended last began one drawing earlier.
    const double began = std::max(drawings - 1, 0.0) * draw_;
    return static_cast<size_t>(std::floor(began / frame_ + 1e-9));
  }

 private:
  double frame_;
  double draw_;
};

}  // namespace

std::span<const ImageMode> imageModes() {
  return kModes;
}

const ImageMode* findImageMode(std::string_view name) {
  for (const ImageMode& mode : kModes) {
    if (name == mode.name) {
      return &mode;
    }
  }
  return nullptr;
}

size_t bytesOnTheWire(size_t imageBytes) {
  return imageBytes + (imageBytes + kPieceBytes - 1) / kPieceBytes * kPieceHeader;
}

double equalBytesSize(const RemoteScene& scene, const View& view, const glm::ivec2& screen,
                      const RemoteSettings& ours) {
  const RemoteRequest request{0, view, screen, {}};
  const auto bytesOf = [&](const RemoteSettings& settings) {
    const RemoteImage image = scene.answer(request, settings, 0);
    return static_cast<double>(image.color.size() + image.depth.size());
  };
  const double wanted = bytesOf(ours);
  RemoteSettings plain = ours;
  plain.zoom = 1;
  for (int i = 0; i < kSizeSteps; ++i) {
    plain.size = std::clamp(plain.size * std::sqrt(wanted / bytesOf(plain)), 0.1, 4.0);  // what the settings take
  }
  return plain.size;
}

Playback playImages(const RemoteScene& scene, const RemotePath& path, const LinkSpeed& speed, const ImageMode& mode,
                    const RemoteSettings& settings, const ImagePlayOptions& options, const PictureSink& sink) {
  RemoteClient client(
      options.screen, [&](const View& view) { return coverOfPlan(view, options.screen, settings); }, options.rule);
  ImageServer server(scene, settings, mode.hasDepth, options.screen, options.serverSeconds, speed);
  std::deque<Delivery> deliveries;
  Playback playback;
  std::vector<double> drawings;
  for (size_t k = 0; k < path.views.size(); ++k) {
    const double seconds = path.secondsOf(k);
    const View& view = path.views[k];
    server.runUntil(seconds, deliveries);
    while (!deliveries.empty() && deliveries.front().seconds <= seconds) {
      const Delivery& delivery = deliveries.front();
      if (client.heldImages() == 0) {
        playback.firstPictureSeconds = delivery.seconds;
      }
      client.receive(delivery.sequence,
                     decodeRemoteImage(delivery.image.headerJson, delivery.image.color, delivery.image.depth),
                     delivery.hasAll, delivery.seconds);
      deliveries.pop_front();
    }
    if (const std::optional<ImageWish> wish = client.look(view, seconds)) {
      server.ask(*wish, seconds);
    }
    const RemoteClient::Choice choice = client.choose(view);
    ShownView shown;
    if (choice.image != nullptr) {
      shown = {k, choice.load.isCovered()};
      if (k % options.every == 0) {
        const double from = now();
        const Image<Rgb8> picture = client.draw(view);
        drawings.push_back(now() - from);
        sink(k, picture);
      }
    }
    playback.shown.push_back(shown);
  }
  if (!drawings.empty()) {
    const auto middle = drawings.begin() + static_cast<std::ptrdiff_t>(drawings.size() / 2);
    std::nth_element(drawings.begin(), middle, drawings.end());
    playback.clientFrameSeconds = *middle;
  }
  playback.clientFrameSeconds = options.clientFrameSeconds.value_or(playback.clientFrameSeconds);
  const DrawingClock clock(path.secondsOf(1), playback.clientFrameSeconds);
  for (size_t k = 0; k < playback.shown.size(); ++k) {
    ShownView& shown = playback.shown[k];
    if (shown.frame) {
      shown.frame = clock.shownAt(k);
    }
  }
  playback.bytes = server.sentBytes();
  playback.images = server.images();
  return playback;
}

}  // namespace ocelli
