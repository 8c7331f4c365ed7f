#include "cli/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/color_text.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& text, const std::string& form,
                       const std::string& example) {
  throw InputError("\"" + text + "\" is not " + form, option, option + " " + example);
}

// The numbers between the separators; empty where any part is not a whole, finite number of type T.
template <class T>
std::vector<T> numbersFromText(std::string_view text, char separator) {
  std::vector<T> numbers;
  while (true) {
    const size_t length = std::min(text.find(separator), text.size());
    const std::optional<T> number = numberFromText<T>(text.substr(0, length));
    if (!number) {
      return {};
    }
    numbers.push_back(*number);
    if (length == text.size()) {
      return numbers;
    }
    text.remove_prefix(length + 1);
  }
}

}  // namespace

ImageSize imageSizeFromText(const std::string& text, const std::string& option) {
  const std::vector<int> sides = numbersFromText<int>(text, 'x');
  if (sides.size() != 2 || sides[0] < 1 || sides[1] < 1 || std::ranges::max(sides) > PinholeCamera::kMaxPixelsASide) {
    fail(option, text, "a size in pixels, WIDTHxHEIGHT, each from 1 to 32768", "720x480");
  }
  if (int64_t{sides[0]} * sides[1] > PinholeCamera::kMaxPixels) {
    throw InputError("\"" + text + "\" has more than 2^26 pixels", option, option + " 8192x8192, or less");
  }
  return {sides[0], sides[1]};
}

glm::vec3 pointFromText(const std::string& text, const std::string& option) {
  const std::vector<float> numbers = numbersFromText<float>(text, ',');
  if (numbers.size() != 3) {
    fail(option, text, "a point X,Y,Z", "0,0.2,9.8");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

float cellSideFromText(const std::string& text, const std::string& option) {
  const bool inches = text.ends_with("in");
  const bool metres = !inches && text.ends_with("m");
  const std::vector<double> numbers =
      numbersFromText<double>(std::string_view(text).substr(0, text.size() - (inches ? 2 : 1)), ',');
  const double side = (inches || metres) && numbers.size() == 1
                          ? numbers[0] * (inches ? kInchMetres : 1) / kReferenceDisplayRadiusMetres
                          : 0;
  constexpr double kMaxRadii = 18;  // beyond it the cell would reach the display from the default eye
  if (!(side > 0) || side > kMaxRadii) {
    fail(option, text, "a length in inches or metres, above 0 and up to 90in", "8in");
  }
  return static_cast<float>(side);
}

size_t frameNumber(int64_t number, const std::string& option) {
  if (number < 0) {
    throw InputError(std::to_string(number) + " is no frame number", option, "frames are counted from 0");
  }
  return static_cast<size_t>(number);
}

double ratioFromText(const std::string& text, const std::string& option) {
  const std::vector<double> numbers = numbersFromText<double>(text, '/');
  if (numbers.empty() || numbers.size() > 2 || (numbers.size() == 2 && numbers[1] == 0)) {
    fail(option, text, "a number or a ratio", "1/25");
  }
  return numbers.size() == 1 ? numbers[0] : numbers[0] / numbers[1];
}

glm::dvec2 rangeFromText(const std::string& text, const std::string& option) {
  const std::vector<double> numbers = numbersFromText<double>(text, ':');
  if (numbers.size() != 2 || numbers[0] > numbers[1]) {
    fail(option, text, "a range of values, LEAST:GREATEST", "300:2000");
  }
  return {numbers[0], numbers[1]};
}

glm::dvec4 halfSpaceFromText(const std::string& text, const std::string& option) {
  constexpr std::string_view kAxes = "xyz";
  const size_t axis = text.empty() ? std::string_view::npos : kAxes.find(text.front());
  if (axis != std::string_view::npos) {
    if (text.size() == 1) {
      throw InputError("\"" + text + "\" is an axis alone: a shell takes < and > for itself", option,
                       option + " '" + text + ">0.2', between quotes");
    }
    const bool isAbove = text[1] == '>';
    const std::vector<double> numbers = numbersFromText<double>(std::string_view(text).substr(2), ',');
    if ((isAbove || text[1] == '<') && numbers.size() == 1) {
      const double sign = isAbove ? 1 : -1;
      glm::dvec4 halfSpace(0, 0, 0, sign * numbers[0]);
      halfSpace[static_cast<int>(axis)] = sign;
      return halfSpace;
    }
  }
  const std::vector<double> numbers = numbersFromText<double>(text, ',');
  const double length = numbers.size() == 4 ? std::hypot(numbers[0], numbers[1], numbers[2]) : 0;
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(numbers[3] / length)) {
    fail(option, text, "a half space, as 'x>0.2', 'z<0' or a normal and a distance, NX,NY,NZ,D", "'x>0.2'");
  }
  return glm::dvec4(numbers[0], numbers[1], numbers[2], numbers[3]) / length;
}

glm::vec3 colorFromText(const std::string& text, const std::string& option) {
  const std::optional<glm::vec3> color = linearFromColorText(text);
  if (!color) {
    fail(option, text, "a colour, #RRGGBB in hexadecimal digits", "'#202830'");
  }
  return *color;
}

size_t textureTrianglesFromText(const std::string& text, const std::string& option) {
  const std::optional<size_t> triangles = text == "full" ? kMaxTextureTriangles : numberFromText<size_t>(text);
  if (!triangles || *triangles > kMaxTextureTriangles) {
    fail(option, text, fmt::format("how many triangles, up to {}, or full", kMaxTextureTriangles), "4000000");
  }
  return *triangles;
}

glm::vec3 directionFromText(const std::string& text, const std::string& option) {
  const std::vector<float> numbers = numbersFromText<float>(text, ',');
  if (numbers.size() != 3 || std::ranges::all_of(numbers, [](float x) { return x == 0; })) {
    fail(option, text, "a direction, three numbers that are not all 0", "0,0,1");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::optional<double> pointWidthFromText(const std::string& text, const std::string& option) {
  if (text == "auto") {
    return std::nullopt;
  }
  const std::vector<double> numbers = numbersFromText<double>(text, ',');
  if (numbers.size() != 1 || !(numbers[0] > 0)) {
    fail(option, text, "a width above 0, in the units of the scene, or auto", "0.01");
  }
  return numbers[0];
}

}  // namespace ocelli
