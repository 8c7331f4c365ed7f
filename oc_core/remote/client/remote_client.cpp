#include "oc_core/remote/client/remote_client.h"

#include <algorithm>
#include <utility>

namespace ocelli {
namespace {

constexpr double kDetailRounding = 1.001;  ///< an image of as many pixels as the view has a sample for each

}  // namespace

ClientImage clientImageOf(uint32_t sequence, const ReferenceImage& image, bool hasDepth) {
  return {sequence, hasDepth, std::make_shared<QuickImage>(image, hasDepth), ImageCover(image, hasDepth), 0};
}

RemoteClient::RemoteClient(const glm::ivec2& screen, Plan plan, const ClientRule& rule)
    : screen_(screen), plan_(std::move(plan)), rule_(rule), tripSeconds_(rule.firstTripSeconds) {}

ViewMotion RemoteClient::motionAt(const View& view, double seconds) const {
  return past_.empty() ? ViewMotion{} : motionBetween(past_.front().second, view, seconds - past_.front().first);
}

bool RemoteClient::isAskedFor(const View& view) const {
  const Choice now = choose(view);
  const DepthSpan depths = now.image != nullptr ? now.image->cover.depths : DepthSpan{};
  return std::any_of(asked_.begin(), asked_.end(), [&](const Asked& asked) {
    ImageCover cover = asked.cover;
    cover.depths = depths;
    return coverLoad(cover, view, screen_, rule_.limits).isCovered();
  });
}

std::optional<View> RemoteClient::wanted(const View& view, const Choice& now, double seconds) const {
  if (now.image == nullptr) {
    return asked_.empty() ? std::optional(view) : std::nullopt;
  }
  const ViewMotion motion = motionAt(view, seconds);
  if (motion.isResting()) {
    const bool isSharp = now.load.isExact() && now.load.detail <= rule_.limits.leastDetail * kDetailRounding;
    const bool isRested = seconds - restingSince_ >= rule_.restSeconds;
    return !isSharp && isRested && lastWish_ != view ? std::optional(view) : std::nullopt;
  }
  const View ahead = viewAhead(view, motion, std::min(tripSeconds_ + rule_.aheadSeconds, rule_.maxAheadSeconds));
  if (choose(ahead).load.whole() <= rule_.askAt || isAskedFor(ahead)) {
    return std::nullopt;
  }
  return ahead;
}

std::optional<ImageWish> RemoteClient::look(const View& view, double seconds) {
  while (past_.size() > 1 && past_[1].first <= seconds - rule_.motionSeconds) {
    past_.pop_front();
  }
  if (past_.empty() || past_.back().second != view) {
    restingSince_ = seconds;
  }
  const Choice now = choose(view);
  for (ClientImage& each : images_) {
    if (&each == now.image) {
      each.usedAt = seconds;
    }
  }
  const std::optional<View> at = wanted(view, now, seconds);
  past_.emplace_back(seconds, view);
  if (!at || (rule_.maxRequests > 0 && sequence_ >= rule_.maxRequests) ||
      (sequence_ > 0 && seconds - lastAsked_ < rule_.pauseSeconds)) {
    return std::nullopt;
  }
  lastAsked_ = seconds;
  lastWish_ = *at;
  const ImageWish wish{++sequence_, *at};
  asked_.push_back({wish, plan_(*at), seconds});
  return wish;
}

void RemoteClient::receive(ClientImage image, double seconds) {
  while (!asked_.empty() && asked_.front().wish.sequence <= image.sequence) {
    if (asked_.front().wish.sequence == image.sequence) {
      if (!image.hasDepth) {
        break;
      }
      tripSeconds_ = seconds - asked_.front().seconds;
    }
    asked_.pop_front();
  }
  const auto held = std::find_if(images_.begin(), images_.end(),
                                 [&](const ClientImage& each) { return each.sequence == image.sequence; });
  if (held != images_.end()) {
    image.usedAt = held->usedAt;
    *held = std::move(image);
    return;
  }
  if (images_.size() >= rule_.maxImages) {
    images_.erase(std::min_element(images_.begin(), images_.end(),
                                   [](const ClientImage& a, const ClientImage& b) { return a.usedAt < b.usedAt; }));
  }
  image.usedAt = seconds;
  images_.push_back(std::move(image));
}

RemoteClient::Choice RemoteClient::choose(const View& view) const {
  const PinholeCamera camera(view, screen_.x, screen_.y);
  Choice best;
  for (const ClientImage& image : images_) {
    const CoverLoad load = coverLoad(image.cover, camera, rule_.limits);
    const bool isBetter = load.isExact() == best.load.isExact() ? load.whole() <= best.load.whole() : load.isExact();
    // Later ones are newer.
    if (best.image == nullptr || isBetter) {
      best = {&image, load};
    }
  }
  return best;
}

Image<Rgb8> RemoteClient::draw(const View& view) const {
  const Choice choice = choose(view);
  if (choice.image == nullptr) {
    return Image<Rgb8>(screen_.x, screen_.y);
  }
  return choice.image->quick->draw(PinholeCamera(view, screen_.x, screen_.y)).color;
}

}  // namespace ocelli
