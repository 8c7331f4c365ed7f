#include "oc_core/feeds_background/feed_background.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kPrimingFrames = 30;
constexpr double kVarianceThreshold = 25;  ///< squared deviations, per channel sum, as MOG2 counts them
/// A shadow leaves at least so much of the light: darker pixels of the same colour are trousers on a floor.
constexpr double kShadowLight = 0.8;
constexpr int kGainStep = 4;            ///< the median takes each fourth mask pixel along both axes
constexpr int kDarkest = 24;            ///< darker pixels tell nothing of a ratio
constexpr int kCutRows = 2;             ///< a blob that comes this near to the lower border is cut, in mask pixels
constexpr double kCoveredShare = 0.75;  ///< of a mask that is no background: no subjects fill so much
constexpr int kCoveredFrames = 5;
constexpr double kMinNewGain = 0.4;
constexpr double kMaxNewGain = 2.5;

cv::Mat viewOf(const Image<Rgb8>& image) {
  return {image.height(), image.width(), CV_8UC3, const_cast<Rgb8*>(image.data())};
}

/// The mean of each `scale` by `scale` pixels. Halving is much the fastest step.
cv::Mat reduced(const cv::Mat& image, int scale) {
  cv::Mat result = image;
  const auto divide = [&](int by) {
    cv::Mat smaller;
    cv::resize(result, smaller, {result.cols / by, result.rows / by}, 0, 0, cv::INTER_AREA);
    result = smaller;
  };
  for (; scale % 2 == 0; scale /= 2) {
    divide(2);
  }
  if (scale > 1) {
    divide(scale);
  }
  return result;
}

double medianOf(std::vector<float>& values) {
  if (values.empty()) {
    return 1;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

/// Per channel: the median of frame / background.
cv::Scalar gainsBetween(const cv::Mat& frame, const cv::Mat& background) {
  cv::Scalar gains(1, 1, 1);
  std::vector<float> ratios;
  for (int channel = 0; channel < 3; ++channel) {
    ratios.clear();
    for (int y = 0; y < frame.rows; y += kGainStep) {
      for (int x = 0; x < frame.cols; x += kGainStep) {
        const int before = background.at<cv::Vec3b>(y, x)[channel];
        const int now = frame.at<cv::Vec3b>(y, x)[channel];
        if (before >= kDarkest && before <= 240 && now < 250) {
          ratios.push_back(static_cast<float>(now) / static_cast<float>(before));
        }
      }
    }
    gains[channel] = std::clamp(medianOf(ratios), kMinNewGain, kMaxNewGain);
  }
  return gains;
}

cv::Mat scaled(const cv::Mat& image, const cv::Scalar& gains) {
  cv::Mat result;
  cv::multiply(image, gains, result);
  return result;
}

SubjectBlob blobOf(const cv::Mat& stats, const cv::Mat& labels, int label, int scale) {
  const int left = stats.at<int>(label, cv::CC_STAT_LEFT);
  const int top = stats.at<int>(label, cv::CC_STAT_TOP);
  const int right = left + stats.at<int>(label, cv::CC_STAT_WIDTH);
  const int bottom = top + stats.at<int>(label, cv::CC_STAT_HEIGHT);
  SubjectBlob blob;
  blob.lower = glm::dvec2(left, top) * static_cast<double>(scale);
  blob.upper = glm::dvec2(right, bottom) * static_cast<double>(scale);
  blob.isCutBelow = bottom >= labels.rows - kCutRows;
  // The middle of the lowest eighth: two feet, of which one may be in the air.
  const int from = std::max(top, bottom - std::max(2, (bottom - top) / 8));
  double sum = 0;
  double count = 0;
  for (int y = from; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      if (labels.at<int>(y, x) == label) {
        sum += x + 0.5;
        ++count;
      }
    }
  }
  blob.foot = {(count > 0 ? sum / count : (left + right) / 2.0) * scale, bottom * scale};
  return blob;
}

}  // namespace

struct FeedBackground::Impl {
  int width;
  int height;
  int scale;
  FeedBackgroundOptions options;
  cv::Ptr<cv::BackgroundSubtractorMOG2> model;
  cv::Mat reference;  ///< half size: what gains are measured against
  Image<Rgb8> still;  ///< full size: the background, in the light of the reference
  cv::Scalar gains{1, 1, 1};
  size_t frames = 0;
  int coveredFrames = 0;
  bool isKnown = false;

  /// A background that was not known follows what MOG2 holds, enlarged: less sharp than a known one.
  void takeLearnt(const cv::Mat& frame, const cv::Mat& isSubject) {
    // Pixels that are no subject now are the sharpest background that there is.
    cv::Mat large;
    cv::resize(isSubject, large, {width, height}, 0, 0, cv::INTER_NEAREST);
    if (still.empty()) {
      cv::Mat learnt;
      model->getBackgroundImage(learnt);
      still = Image<Rgb8>(width, height);
      cv::resize(learnt, viewOf(still), {width, height}, 0, 0, cv::INTER_LINEAR);
    }
    cv::Mat blended;
    cv::addWeighted(viewOf(still), 0.95, frame, 0.05, 0, blended);
    blended.copyTo(viewOf(still), large == 0);
  }

  FeedBlobs blobsIn(const cv::Mat& mask) const {
    cv::Mat closed;
    cv::Mat core;
    cv::morphologyEx(mask, core, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {2, 2}));
    // Legs and heads that are parted from a body belong to it.
    cv::morphologyEx(core, closed, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {3, 7}));
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centers;
    const int count = cv::connectedComponentsWithStats(closed, labels, stats, centers, 8, CV_32S);
    FeedBlobs blobs;
    blobs.scale = scale;
    blobs.core = Image<uint16_t>(mask.cols, mask.rows);
    std::vector<uint16_t> numbers(static_cast<size_t>(count), 0);
    for (int label = 1; label < count; ++label) {
      if (stats.at<int>(label, cv::CC_STAT_AREA) * scale * scale >= options.minBlobPixels) {
        blobs.blobs.push_back(blobOf(stats, labels, label, scale));
        numbers[static_cast<size_t>(label)] = static_cast<uint16_t>(blobs.blobs.size());
      }
    }
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        blobs.core(x, y) = numbers[static_cast<size_t>(labels.at<int>(y, x))];
      }
    }
    cv::Mat_<uint16_t> core16(mask.rows, mask.cols, blobs.core.data());
    blobs.wide = Image<uint16_t>(mask.cols, mask.rows);
    cv::Mat_<uint16_t> wide16(mask.rows, mask.cols, blobs.wide.data());
    cv::dilate(core16, wide16, cv::getStructuringElement(cv::MORPH_RECT, {7, 7}));
    return blobs;
  }
};

FeedBackground::FeedBackground(int width, int height, const Image<Rgb8>& known, const FeedBackgroundOptions& options)
    : impl_(std::make_unique<Impl>()) {
  cv::setNumThreads(1);  // feeds have threads of their own
  impl_->width = width;
  impl_->height = height;
  impl_->scale = maskScaleOf(width);
  impl_->options = options;
  const int history = std::max(2, static_cast<int>(options.learnSeconds * options.framesPerSecond));
  impl_->model = cv::createBackgroundSubtractorMOG2(history, kVarianceThreshold, true);
  impl_->model->setShadowThreshold(kShadowLight);
  if (!known.empty()) {
    OC_CHECK(known.width() == width && known.height() == height, "the caller has checked the size");
    impl_->isKnown = true;
    impl_->still = known;
    impl_->reference = reduced(viewOf(known), impl_->scale);
    cv::Mat ignored;
    for (int i = 0; i < kPrimingFrames; ++i) {
      impl_->model->apply(impl_->reference, ignored, 1.0 / (i + 1));
    }
  }
}

FeedBackground::~FeedBackground() = default;

FeedBlobs FeedBackground::update(const Image<Rgb8>& frame) {
  Impl& self = *impl_;
  const cv::Mat small = reduced(viewOf(frame), self.scale);
  if (self.reference.empty()) {
    self.reference = small.clone();
  }
  const cv::Scalar gains = gainsBetween(small, self.reference);
  const cv::Mat level = scaled(small, {1 / gains[0], 1 / gains[1], 1 / gains[2]});
  const double history = self.options.learnSeconds * self.options.framesPerSecond;
  const bool isBeginning = !self.isKnown && self.frames < kPrimingFrames;
  cv::Mat mask;
  const double rate = self.coveredFrames > 0 ? 0 : 1 / history;
  self.model->apply(level, mask, isBeginning ? 1.0 / static_cast<double>(self.frames + 1) : rate);
  cv::threshold(mask, mask, 200, 255, cv::THRESH_BINARY);  // 127 are shadows
  const bool isAway = !isBeginning && cv::countNonZero(mask) >= kCoveredShare * static_cast<double>(mask.total());
  self.coveredFrames = isAway ? self.coveredFrames + 1 : 0;
  if (isAway) {
    mask = cv::Scalar(0);
  } else {
    self.gains = gains;
  }
  FeedBlobs blobs = self.blobsIn(mask);
  blobs.colors = Image<Rgb8>(level.cols, level.rows);
  level.copyTo(viewOf(blobs.colors));
  if (!self.isKnown && !isAway) {
    const cv::Mat isSubject(mask.rows, mask.cols, CV_16U, blobs.wide.data());
    cv::Mat subject8;
    cv::compare(isSubject, 0, subject8, cv::CMP_GT);
    self.takeLearnt(scaled(viewOf(frame), {1 / gains[0], 1 / gains[1], 1 / gains[2]}), subject8);
  }
  ++self.frames;
  return blobs;
}

const Image<Rgb8>& FeedBackground::image() const {
  return impl_->still;
}

bool FeedBackground::isCovered() const {
  return impl_->coveredFrames >= kCoveredFrames;
}

glm::dvec3 FeedBackground::light() const {
  return {impl_->gains[0], impl_->gains[1], impl_->gains[2]};
}

}  // namespace ocelli
