#include "oc_core/feeds_stitch/stitch_feeds.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/stitching.hpp>

#include "oc_core/base/steady_time.h"

namespace ocelli {
namespace {

cv::Mat matOf(const Image<Rgb8>& image) {
  cv::Mat mat;
  // OpenCV only reads it.
  cv::cvtColor(cv::Mat(image.height(), image.width(), CV_8UC3, const_cast<Rgb8*>(image.data())), mat,
               cv::COLOR_RGB2BGR);
  return mat;
}

/// Labels in the first channel, 1 + the index of the feed in the second.
cv::Mat labelMatOf(const Image<uint8_t>& labels, size_t feed) {
  cv::Mat mat(labels.height(), labels.width(), CV_8UC3);
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      mat.at<cv::Vec3b>(y, x) = {labels(x, y), static_cast<uint8_t>(feed + 1), 0};
    }
  }
  return mat;
}

bool hasUsualLenses(cv::Stitcher& stitcher, const std::vector<cv::Mat>& frames) {
  for (const cv::detail::CameraParams& camera : stitcher.cameras()) {
    // In pixels of the images that features are looked for in.
    if (!(camera.focal < kMaxStitchFocal * frames.front().cols * stitcher.workScale())) {
      return false;
    }
  }
  return true;
}

void composeLabels(cv::Stitcher& stitcher, const std::vector<Image<uint8_t>>& labels, StitchedFeeds& result) {
  std::vector<cv::Mat> mats;
  for (size_t i = 0; i < labels.size(); ++i) {
    mats.push_back(labelMatOf(labels[i], i));
  }
  stitcher.setExposureCompensator(cv::makePtr<cv::detail::NoExposureCompensator>());
  stitcher.setBlender(cv::makePtr<cv::detail::Blender>());
  stitcher.setInterpolationFlags(cv::INTER_NEAREST);
  cv::Mat composed;
  if (stitcher.composePanorama(mats, composed) != cv::Stitcher::OK) {
    result.feeds.clear();
    return;
  }
  const cv::Mat covered = stitcher.resultMask().getMat(cv::ACCESS_READ);
  result.labels = Image<uint8_t>(composed.cols, composed.rows);
  result.owner = result.labels;
  for (int y = 0; y < composed.rows; ++y) {
    for (int x = 0; x < composed.cols; ++x) {
      if (covered.at<uint8_t>(y, x) > 0) {
        const auto& pixel = composed.at<cv::Vec3b>(y, x);
        result.labels(x, y) = pixel[0];
        result.owner(x, y) = pixel[1];
      }
    }
  }
}

}  // namespace

StitchedFeeds stitchFeeds(const std::vector<Image<Rgb8>>& frames, const std::vector<Image<uint8_t>>& labels) {
  StitchedFeeds result;
  const int64_t began = steadyNanoseconds();
  const auto finish = [&] { result.seconds = 1e-9 * static_cast<double>(steadyNanoseconds() - began); };
  std::vector<cv::Mat> mats;
  for (const Image<Rgb8>& frame : frames) {
    mats.push_back(matOf(frame));
  }
  cv::setRNGSeed(1);
  const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
  stitcher->setSeamFinder(cv::makePtr<cv::detail::VoronoiSeamFinder>());
  try {
    cv::Mat composed;
    if (stitcher->estimateTransform(mats) == cv::Stitcher::OK && hasUsualLenses(*stitcher, mats) &&
        stitcher->composePanorama(composed) == cv::Stitcher::OK) {
      finish();
      for (const int feed : stitcher->component()) {
        result.feeds.push_back(static_cast<size_t>(feed));
      }
      result.image = Image<Rgb8>(composed.cols, composed.rows);
      cv::cvtColor(composed, cv::Mat(composed.rows, composed.cols, CV_8UC3, result.image.data()), cv::COLOR_BGR2RGB);
      composeLabels(*stitcher, labels, result);
      return result;
    }
  } catch (const cv::Exception&) {
    // It throws for cameras that it cannot make sense of: no picture either.
    result = {};
  }
  finish();
  return result;
}

}  // namespace ocelli
