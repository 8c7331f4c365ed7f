#include "oc_core/feeds_background/picture_text.h"

#include <opencv2/imgproc.hpp>

#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

std::string asciiOf(const std::string& text) {
  std::string ascii;
  for (const char32_t code : codePoints(cleanText(text))) {
    ascii += code >= U' ' && code <= U'~' ? static_cast<char>(code) : '?';
  }
  return ascii;
}

}  // namespace

int pictureTextWidth(const std::string& text, int height) {
  int below = 0;
  const double scale = cv::getFontScaleFromHeight(cv::FONT_HERSHEY_SIMPLEX, height, 1);
  return cv::getTextSize(asciiOf(text), cv::FONT_HERSHEY_SIMPLEX, scale, 1, &below).width;
}

void drawPictureText(Image<Rgb8>& image, const std::string& text, const glm::ivec2& left, int height,
                     const Rgb8& color) {
  cv::Mat view(image.height(), image.width(), CV_8UC3, image.data());
  const double scale = cv::getFontScaleFromHeight(cv::FONT_HERSHEY_SIMPLEX, height, 1);
  const cv::Point at(left.x, left.y);
  const std::string drawn = asciiOf(text);
  cv::putText(view, drawn, at, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(0, 0, 0), 3, cv::LINE_AA);
  cv::putText(view, drawn, at, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(color.x, color.y, color.z), 1, cv::LINE_AA);
}

}  // namespace ocelli
