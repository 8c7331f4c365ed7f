#include "oc_core/feeds_background/picture_text.h"

#include <opencv2/imgproc.hpp>

namespace ocelli {

void drawPictureText(Image<Rgb8>& image, const std::string& text, const glm::ivec2& left, int height,
                     const Rgb8& color) {
  cv::Mat view(image.height(), image.width(), CV_8UC3, image.data());
  const double scale = cv::getFontScaleFromHeight(cv::FONT_HERSHEY_SIMPLEX, height, 1);
  const cv::Point at(left.x, left.y);
  cv::putText(view, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(0, 0, 0), 3, cv::LINE_AA);
  cv::putText(view, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(color.x, color.y, color.z), 1, cv::LINE_AA);
}

}  // namespace ocelli
