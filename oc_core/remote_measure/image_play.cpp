#include "oc_core/remote_measure/image_play.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "oc_core/base/steady_time.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote/remote_image.h"
#include "oc_core/remote/remote_message.h"

namespace ocelli {
namespace {

constexpr size_t kPieceHeader = RemotePiece::kHeaderBytes + 4;  ///< of the message, and of WebSocket's frame
constexpr int kSizeSteps = 4;
constexpr size_t kFirstDrawings = 5;

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
    const ReferenceImage drawn =
        scene_.draw(planRemoteImage({wish.sequence, wish.view, screen_, {}}, settings_), settings_.samples);
    const double drawSeconds = now() - from;
    RemoteImage image = encodeRemoteImage(drawn, settings_, ++images_, wish.sequence, drawSeconds);
    double takes = now() - from;
    if (!hasDepth_) {
      // What coding its depth took does not count.
      image.depth.clear();
      const double encodeFrom = now();
      findColorCodec(settings_.color)->encode(srgbFromLinear(drawn.color), settings_.quality);
      takes = drawSeconds + now() - encodeFrom;
    }
    const double ready = begin + seconds_.value_or(takes);
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

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What the client has decoded, and when it is ready: one message after the other.
class ClientDecoder {
 public:
  struct Ready {
    double seconds = 0;
    ClientImage image;
  };

  explicit ClientDecoder(std::optional<double> seconds) : seconds_(seconds) {}

  Ready decode(const Delivery& delivery) {
    const double from = now();
    ClientImage image = clientImageOf(
        delivery.sequence, decodeRemoteImage(delivery.image.headerJson, delivery.image.color, delivery.image.depth),
        delivery.hasAll);
    const double takes = seconds_.value_or(now() - from);
    freeAt_ = std::max(freeAt_, delivery.seconds) + takes;
    total_ += takes;
    images_ += delivery.hasAll;
    return {freeAt_, std::move(image)};
  }
  /// Of an image, with all its messages.
  double meanSeconds() const { return images_ > 0 ? total_ / images_ : 0; }

 private:
  std::optional<double> seconds_;
  double freeAt_ = 0;
  double total_ = 0;
  int images_ = 0;
};

/// What is on the client's screen, and what will be.
class ClientScreen {
 public:
  struct Picture {
    size_t frame = 0;  ///< of the path, whose view it shows
    bool isCovered = false;
    std::shared_ptr<const QuickImage> image;
    double shownAt = 0;
  };

  explicit ClientScreen(double frameSeconds) : frame_(frameSeconds) {}

  /// At a frame of the path, with what the client would draw then; `seconds` is when it can begin at the soonest, and
  /// what drawing takes.
  void at(double seconds, double drawSeconds, Picture next) {
    while (!drawn_.empty() && drawn_.front().shownAt <= seconds + kTimeRounding) {
      onScreen_ = std::move(drawn_.front());
      drawn_.pop_front();
    }
    if (drawSeconds <= frame_ + kTimeRounding && drawn_.empty()) {
      next.shownAt = seconds + drawSeconds;
      onScreen_ = std::move(next);
      freeAt_ = seconds;
      return;
    }
    const double begin = std::max(freeAt_, seconds);
    if (begin < seconds + frame_ - kTimeRounding) {
      freeAt_ = next.shownAt = begin + drawSeconds;
      drawn_.push_back(std::move(next));
    }
  }
  const std::optional<Picture>& picture() const { return onScreen_; }

 private:
  static constexpr double kTimeRounding = 1e-9;

  double frame_;
  std::optional<Picture> onScreen_;
  std::deque<Picture> drawn_;  ///< or being drawn
  double freeAt_ = 0;
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
  return imageBytes + (imageBytes + RemotePiece::kMaxBytes - 1) / RemotePiece::kMaxBytes * kPieceHeader;
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
  ClientDecoder decoder(options.clientDecodeSeconds);
  ClientScreen screen(path.secondsOf(1));
  std::deque<Delivery> deliveries;
  std::deque<ClientDecoder::Ready> decoded;
  std::vector<double> drawings;
  const auto drawn = [&](size_t frame, const QuickImage& image) {
    const double from = now();
    Image<Rgb8> picture = image.draw(PinholeCamera(path.views[frame], options.screen.x, options.screen.y)).color;
    drawings.push_back(now() - from);
    return picture;
  };
  const auto drawSeconds = [&] { return options.clientFrameSeconds.value_or(medianOf(drawings)); };
  Playback playback;
  for (size_t k = 0; k < path.views.size(); ++k) {
    const double seconds = path.secondsOf(k);
    const View& view = path.views[k];
    server.runUntil(seconds, deliveries);
    while (!deliveries.empty() && deliveries.front().seconds <= seconds) {
      decoded.push_back(decoder.decode(deliveries.front()));
      deliveries.pop_front();
    }
    while (!decoded.empty() && decoded.front().seconds <= seconds) {
      client.receive(std::move(decoded.front().image), decoded.front().seconds);
      decoded.pop_front();
    }
    if (const std::optional<ImageWish> wish = client.look(view, seconds)) {
      server.ask(*wish, seconds);
    }
    if (const RemoteClient::Choice choice = client.choose(view); choice.image != nullptr) {
      while (drawings.size() < kFirstDrawings) {
        drawn(k, *choice.image->quick);  // for their time: that of the very first is not what drawing takes
      }
      screen.at(seconds, drawSeconds(), {k, choice.load.isCovered(), choice.image->quick});
    }
    const std::optional<ClientScreen::Picture>& picture = screen.picture();
    playback.shown.push_back(picture ? ShownView{picture->frame, picture->isCovered} : ShownView{});
    if (picture && !playback.firstPictureSeconds) {
      playback.firstPictureSeconds = picture->shownAt;
    }
    if (k % options.every == 0) {
      sink(k, picture ? drawn(picture->frame, *picture->image) : Image<Rgb8>(options.screen.x, options.screen.y));
    }
  }
  playback.clientFrameSeconds = drawings.empty() ? 0 : drawSeconds();
  playback.clientDecodeSeconds = decoder.meanSeconds();
  playback.bytes = server.sentBytes();
  playback.images = server.images();
  return playback;
}

}  // namespace ocelli
