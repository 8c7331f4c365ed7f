#include "display_sim/viewer/effect_work.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "display_sim/viewer/error_message.h"

namespace ocelli {
namespace {

/// Thrown through work that a newer wish has made useless.
struct EffectSuperseded {};

glm::ivec2 scaled(const glm::ivec2& size, double scale) {
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1));
}

double pixelCountOf(const glm::ivec2& size) {
  return static_cast<double>(size.x) * size.y;
}

template <class Draw>
EffectImage timed(const Draw& draw) {
  const auto start = std::chrono::steady_clock::now();
  EffectImage drawn{draw(), 0};
  drawn.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return drawn;
}

}  // namespace

double previewScale(double secondsOfWhole) {
  constexpr double kSmallest = 0.125;
  if (!(secondsOfWhole > 0)) {
    return kSmallest;
  }
  double scale = 1;
  while (scale > kSmallest && secondsOfWhole * scale * scale > EffectWork::kPreviewSeconds) {
    scale /= 2;
  }
  return scale;
}

const Image<Rgb8>* EffectPicture::shown(EffectShown::Content content) const {
  const Image<Rgb8>* image = nullptr;
  switch (content) {
    case EffectShown::Content::kByWay:
      image = &byWay.image;
      break;
    case EffectShown::Content::kByTracing:
      image = &traced.image;
      break;
    case EffectShown::Content::kDifference:
      image = difference ? &difference->heat : nullptr;
      break;
  }
  return image != nullptr && !image->empty() ? image : nullptr;
}

void EffectWork::waitUntilIdle() {
  wishes_.waitUntilIdle([](const EffectWanted& wanted, const EffectStatus& status) {  // what was left out
    return status.picture && (!status.picture->isWhole || !status.picture->difference) && wanted.shows;
  });
}

void EffectWork::make(const EffectWanted& wanted) {
  try {
    makeAll(wanted);
  } catch (const EffectSuperseded&) {  // there is something else to make
  }
  clearStage();
}

Progress EffectWork::progressOf(const EffectWanted& wanted) {
  return [this, wanted](std::string_view stage, double fraction) {
    const bool isOfUse =
        wishes_.changeWhere([&](const EffectWanted& newest) { return newest.on && newest.hasSameWay(wanted); },
                            [&](EffectStatus& status) {
                              status.stage = stage;
                              status.fraction = fraction;
                            });
    if (!isOfUse) {
      throw EffectSuperseded{};
    }
  };
}

void EffectWork::makeAll(const EffectWanted& wanted) {
  if (!wanted.on) {
    model_.clear();
    last_ = {};
    tried_ = {};
    notBuilt_.reset();
    wishes_.change([](EffectStatus& status) { status = {}; });
    return;
  }
  if (notBuilt_ && notBuilt_->hasSameWay(wanted)) {
    return;
  }
  bool isBuilt = false;
  std::exception_ptr error;
  try {
    if (!tried_.hasSameWay(wanted)) {
      secondsPerPixelByWay_ = 0;
      wishes_.change([](EffectStatus& status) { status.error.clear(); });
    }
    if (!tried_.hasSameStage(wanted)) {
      secondsPerPixelTraced_ = 0;
    }
    const bool isNewScene = !tried_.hasSameScene(wanted);
    tried_ = wanted;
    if (isNewScene) {  // a picture of another one goes at once
      last_ = {};
      wishes_.change([](EffectStatus& status) {
        status.picture = nullptr;
        status.home.reset();
        status.effect.clear();
      });
    }
    model_.build(wanted, progressOf(wanted));
    isBuilt = true;
    notBuilt_.reset();
    wishes_.change([&](EffectStatus& status) {
      status.error.clear();
      status.stage.clear();
      status.sceneRevision = wanted.sceneRevision;
      status.effect = model_.effect();
      status.home = model_.home();
    });
    if (wanted.shows && !wanted.effect.empty()) {
      drawAll(wanted);
    }
  } catch (const std::exception&) {
    error = std::current_exception();
  }
  if (error) {
    last_ = {};
    if (!isBuilt) {
      notBuilt_ = wanted;
    }
    const std::string message = errorMessage(error);
    wishes_.change([&](EffectStatus& status) {
      status.picture = nullptr;
      status.error = message;
    });
  }
}

double EffectWork::secondsOf(const glm::ivec2& size, bool byWay, bool traced) const {
  if ((byWay && secondsPerPixelByWay_ <= 0) || (traced && secondsPerPixelTraced_ <= 0)) {
    return 0;
  }
  return pixelCountOf(size) * ((byWay ? secondsPerPixelByWay_ : 0) + (traced ? secondsPerPixelTraced_ : 0));
}

double EffectWork::firstScale(const EffectWanted& wanted, bool byWay, bool traced) const {
  return previewScale(secondsOf(wanted.size, byWay, traced));
}

void EffectWork::draw(EffectPicture& picture, const glm::ivec2& size, bool byWay, bool traced) {
  const PinholeCamera camera(picture.wanted.view, size.x, size.y);
  if (byWay && picture.byWay.image.empty()) {
    picture.byWay = timed([&] { return model_.drawByWay(camera); });
    secondsPerPixelByWay_ = picture.byWay.milliseconds / 1000 / pixelCountOf(size);
  }
  if (traced && picture.traced.image.empty()) {
    model_.buildTraced(progressOf(picture.wanted));
    clearStage();
    picture.traced = timed([&] { return model_.drawTraced(camera); });
    secondsPerPixelTraced_ = picture.traced.milliseconds / 1000 / pixelCountOf(size);
  }
  if (!picture.byWay.image.empty() && !picture.traced.image.empty() && !picture.difference) {
    picture.difference = differenceOf(picture.byWay.image, picture.traced.image);
  }
}

void EffectWork::drawAll(const EffectWanted& wanted) {
  const bool byWay = wanted.content != EffectShown::Content::kByTracing;
  const bool traced = wanted.content != EffectShown::Content::kByWay;
  EffectPicture picture{wanted, true, 0, {}, {}, {}};
  const bool sameView = last_.wanted.view == wanted.view && last_.wanted.size == wanted.size;
  if (sameView && last_.wanted.hasSameWay(wanted)) {
    picture.byWay = last_.byWay;
    picture.difference = last_.difference;
  }
  if (sameView && last_.wanted.hasSameStage(wanted)) {
    picture.traced = last_.traced;
  }
  const bool isDrawn = (!byWay || !picture.byWay.image.empty()) && (!traced || !picture.traced.image.empty());
  if (!isDrawn) {
    double still = kStillSeconds;
    double scale = firstScale(wanted, byWay, traced);
    for (; scale < 1 && !wishes_.someoneWaits(); scale *= 2) {
      EffectPicture preview{wanted, false, 0, {}, {}, {}};
      draw(preview, scaled(wanted.size, scale), byWay, traced);
      const double next = secondsOf(scaled(wanted.size, 2 * scale), byWay, traced);
      if (isLeftOut(next)) {
        preview.secondsLeftOut = secondsOf(wanted.size, byWay, traced);
      }
      publish(preview);
      if (!wishes_.standsStill(wanted, still) || (preview.secondsLeftOut > 0 && isLeftOut(next))) {
        return;
      }
      still = 0;
    }
  }
  draw(picture, wanted.size, byWay, traced);
  publish(picture);
  if (picture.difference || !wishes_.standsStill(wanted, kStillSeconds)) {
    return;
  }
  const bool lacksTraced = picture.traced.image.empty();
  if (secondsOf(wanted.size, !lacksTraced, lacksTraced) <= 0) {  // a small one tells how long it takes
    EffectPicture probe{wanted, false, 0, {}, {}, {}};
    draw(probe, scaled(wanted.size, previewScale(0)), !lacksTraced, lacksTraced);
  }
  const double seconds = secondsOf(wanted.size, !lacksTraced, lacksTraced);
  if (isLeftOut(seconds)) {
    picture.secondsLeftOut = seconds;
  } else {
    draw(picture, wanted.size, true, true);
  }
  publish(picture);
}

void EffectWork::clearStage() {
  wishes_.change([](EffectStatus& status) { status.stage.clear(); });
}

void EffectWork::publish(const EffectPicture& picture) {
  if (picture.isWhole) {
    last_ = picture;
  }
  const auto published = std::make_shared<const EffectPicture>(picture);
  wishes_.changeWhere([&](const EffectWanted& newest) { return newest.on && newest.hasSameScene(picture.wanted); },
                      [&](EffectStatus& status) { status.picture = published; });
}

}  // namespace ocelli
