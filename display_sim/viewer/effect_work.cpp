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

EffectWork::EffectWork() : thread_([this] { run(); }) {}

EffectWork::~EffectWork() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void EffectWork::want(const EffectWanted& wanted) {
  {
    const std::scoped_lock lock(mutex_);
    if (wanted_ == wanted) {
      return;
    }
    wanted_ = wanted;
    fresh_ = true;
    busy_ = true;
  }
  changed_.notify_all();
}

EffectStatus EffectWork::status() const {
  const std::scoped_lock lock(mutex_);
  EffectStatus status = status_;
  status.busy = busy_;
  return status;
}

void EffectWork::waitUntilIdle() {
  std::unique_lock lock(mutex_);
  hurry_ = true;
  if (status_.picture && (!status_.picture->isWhole || !status_.picture->difference) && wanted_.shows) {
    fresh_ = busy_ = true;  // what was left out
  }
  changed_.notify_all();
  changed_.wait(lock, [this] { return !busy_; });
  hurry_ = false;
}

void EffectWork::run() {
  EffectModel model;
  while (true) {
    EffectWanted wanted;
    {
      std::unique_lock lock(mutex_);
      busy_ = fresh_;
      status_.stage.clear();
      changed_.notify_all();
      changed_.wait(lock, [&] { return stop_ || fresh_; });
      if (stop_) {
        return;
      }
      wanted = wanted_;
      fresh_ = false;
    }
    try {
      makeAll(wanted, model);
    } catch (const EffectSuperseded&) {  // there is something else to make
    }
  }
}

Progress EffectWork::progressOf(const EffectWanted& wanted) {
  return [this, wanted](std::string_view stage, double fraction) {
    const std::scoped_lock lock(mutex_);
    if (stop_ || !wanted_.on || !wanted_.hasSameWay(wanted)) {
      throw EffectSuperseded{};
    }
    status_.stage = stage;
    status_.fraction = fraction;
  };
}

void EffectWork::makeAll(const EffectWanted& wanted, EffectModel& model) {
  if (!wanted.on) {
    model.clear();
    last_ = {};
    tried_ = {};
    notBuilt_.reset();
    const std::scoped_lock lock(mutex_);
    status_ = {};
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
      const std::scoped_lock lock(mutex_);
      status_.error.clear();
    }
    if (!tried_.hasSameStage(wanted)) {
      secondsPerPixelTraced_ = 0;
    }
    const bool isNewScene = !tried_.hasSameScene(wanted);
    tried_ = wanted;
    if (isNewScene) {  // a picture of another one goes at once
      last_ = {};
      const std::scoped_lock lock(mutex_);
      status_.picture = nullptr;
      status_.home.reset();
      status_.effect.clear();
    }
    model.build(wanted, progressOf(wanted));
    isBuilt = true;
    notBuilt_.reset();
    {
      const std::scoped_lock lock(mutex_);
      status_.error.clear();
      status_.stage.clear();
      status_.sceneRevision = wanted.sceneRevision;
      status_.effect = model.effect();
      status_.home = model.home();
    }
    if (wanted.shows && !wanted.effect.empty()) {
      drawAll(wanted, model);
    }
  } catch (const std::exception&) {
    error = std::current_exception();
  }
  if (error) {
    last_ = {};
    if (!isBuilt) {
      notBuilt_ = wanted;
    }
    const std::scoped_lock lock(mutex_);
    status_.picture = nullptr;
    status_.error = errorMessage(error);
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

void EffectWork::draw(EffectPicture& picture, const glm::ivec2& size, bool byWay, bool traced, EffectModel& model) {
  const PinholeCamera camera(picture.wanted.view, size.x, size.y);
  if (byWay && picture.byWay.image.empty()) {
    picture.byWay = timed([&] { return model.drawByWay(camera); });
    secondsPerPixelByWay_ = picture.byWay.milliseconds / 1000 / pixelCountOf(size);
  }
  if (traced && picture.traced.image.empty()) {
    model.buildTraced(progressOf(picture.wanted));
    clearStage();
    picture.traced = timed([&] { return model.drawTraced(camera); });
    secondsPerPixelTraced_ = picture.traced.milliseconds / 1000 / pixelCountOf(size);
  }
  if (!picture.byWay.image.empty() && !picture.traced.image.empty() && !picture.difference) {
    picture.difference = differenceOf(picture.byWay.image, picture.traced.image);
  }
}

void EffectWork::drawAll(const EffectWanted& wanted, EffectModel& model) {
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
    for (; scale < 1 && !someoneWaits(); scale *= 2) {
      EffectPicture preview{wanted, false, 0, {}, {}, {}};
      draw(preview, scaled(wanted.size, scale), byWay, traced, model);
      const double next = secondsOf(scaled(wanted.size, 2 * scale), byWay, traced);
      if (isLeftOut(next)) {
        preview.secondsLeftOut = secondsOf(wanted.size, byWay, traced);
      }
      publish(preview);
      if (!standsStill(wanted, still) || (preview.secondsLeftOut > 0 && isLeftOut(next))) {
        return;
      }
      still = 0;
    }
  }
  draw(picture, wanted.size, byWay, traced, model);
  publish(picture);
  if (picture.difference || !standsStill(wanted, kStillSeconds)) {
    return;
  }
  const bool lacksTraced = picture.traced.image.empty();
  if (secondsOf(wanted.size, !lacksTraced, lacksTraced) <= 0) {  // a small one tells how long it takes
    EffectPicture probe{wanted, false, 0, {}, {}, {}};
    draw(probe, scaled(wanted.size, previewScale(0)), !lacksTraced, lacksTraced, model);
  }
  const double seconds = secondsOf(wanted.size, !lacksTraced, lacksTraced);
  if (isLeftOut(seconds)) {
    picture.secondsLeftOut = seconds;
  } else {
    draw(picture, wanted.size, true, true, model);
  }
  publish(picture);
}

void EffectWork::clearStage() {
  const std::scoped_lock lock(mutex_);
  status_.stage.clear();
}

bool EffectWork::someoneWaits() const {
  const std::scoped_lock lock(mutex_);
  return hurry_;
}

bool EffectWork::standsStill(const EffectWanted& wanted, double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [&] { return stop_ || hurry_ || !(wanted_ == wanted); });
  return !stop_ && wanted_ == wanted;
}

void EffectWork::publish(const EffectPicture& picture) {
  if (picture.isWhole) {
    last_ = picture;
  }
  const std::scoped_lock lock(mutex_);
  if (wanted_.on && wanted_.hasSameScene(picture.wanted)) {
    status_.picture = std::make_shared<const EffectPicture>(picture);
  }
}

}  // namespace ocelli
