#include "display_sim/observing/eye_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <optional>
#include <string_view>
#include <variant>

#include "display_sim/observing/eye_perspective.h"
#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr double kMaxSeconds = 1e6;
constexpr double kMaxRadii = 1e6;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  ///< spreadsheets begin a table with it

/// Throws where the poses do not make a path.
void check(const std::vector<EyePose>& poses, const std::string& where) {
  if (poses.empty()) {
    throw InputError("this path has no poses", where, "give one at least");
  }
  for (size_t i = 1; i < poses.size(); ++i) {
    if (!(poses[i].seconds > poses[i - 1].seconds)) {
      throw InputError("pose " + std::to_string(i + 1) + " is not later than the one before it", where,
                       "order the poses by their times");
    }
  }
}

constexpr std::array<const char*, 4> kFieldNames = {"time", "x", "y", "z"};

/// Four numbers between commas, perhaps with blanks around them; or what is wrong.
std::variant<std::array<double, 4>, std::string> fourNumbers(std::string_view line) {
  std::array<double, 4> numbers{};
  const auto values = static_cast<size_t>(std::ranges::count(line, ',')) + 1;
  if (values != numbers.size()) {
    return std::to_string(values) + (values == 1 ? " value" : " values") + " instead of 4";
  }
  for (size_t i = 0; i < numbers.size(); ++i) {
    const size_t length = std::min(line.find(','), line.size());
    std::string_view field = line.substr(0, length);
    line.remove_prefix(std::min(length + 1, line.size()));
    field.remove_prefix(std::min(field.find_first_not_of(" \t"), field.size()));
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), numbers[i]);
    const std::string_view rest = field.substr(static_cast<size_t>(end - field.data()));
    if (error != std::errc() || rest.find_first_not_of(" \t") != std::string_view::npos) {
      return std::string(kFieldNames[i]) + " is not a number";
    }
    if (!(std::abs(numbers[i]) <= (i == 0 ? kMaxSeconds : kMaxRadii))) {
      return std::string(kFieldNames[i]) + " is out of range";
    }
  }
  return numbers;
}

}  // namespace

EyePair eyePair(const glm::vec3& eye, double separation) {
  const glm::dvec3 half = EyePerspective({.eye = eye}).right() * (separation / 2);
  return {glm::vec3(glm::dvec3(eye) - half), glm::vec3(glm::dvec3(eye) + half)};
}

std::vector<glm::vec3> turntableEyes(const glm::vec3& eye, int count) {
  OC_CHECK(count >= 1, "a turn has a step at least");
  std::vector<glm::vec3> eyes;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const glm::dvec3 e(eye);
    eyes.emplace_back(glm::dvec3(e.x * cosine + e.z * sine, e.y, e.z * cosine - e.x * sine));
  }
  return eyes;
}

std::optional<EyePose> poseFromLine(std::string_view line) {
  const auto read = fourNumbers(line);
  const auto* const numbers = std::get_if<std::array<double, 4>>(&read);
  if (numbers == nullptr) {
    return std::nullopt;
  }
  return EyePose{(*numbers)[0], glm::vec3((*numbers)[1], (*numbers)[2], (*numbers)[3])};
}

std::string problemOfLine(std::string_view line) {
  const auto read = fourNumbers(line);
  const auto* const problem = std::get_if<std::string>(&read);
  return problem == nullptr ? "" : *problem;
}

std::vector<EyePose> readEyePath(const std::filesystem::path& path) {
  const std::string where = path.string();
  if (where.ends_with(".csv")) {
    return eyePathFromCsv(readFile(path, kMaxTextBytes), where);
  }
  if (where.ends_with(".json")) {
    return eyePathFromJson(readFile(path, kMaxTextBytes), where);
  }
  throw InputError("a path of eyes is a .csv or a .json file", where, "give one of these");
}

std::vector<EyePose> eyePathFromCsv(const std::string& text, const std::string& where) {
  std::vector<EyePose> poses;
  std::string_view rest = text;
  if (rest.starts_with(kByteOrderMark)) {
    rest.remove_prefix(kByteOrderMark.size());
  }
  bool hasHeader = false;
  for (int number = 1; !rest.empty(); ++number) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    if (line.empty()) {
      continue;
    }
    const std::string here = where + ":" + std::to_string(number);
    if (!hasHeader) {
      if (line != kEyePathHeader) {
        throw InputError("the first line is not \"time,x,y,z\"", here, "name the columns so");
      }
      hasHeader = true;
      continue;
    }
    const auto pose = poseFromLine(line);
    if (!pose) {
      throw InputError("this is not a time in seconds and three coordinates in display radii", here,
                       "write lines like 0.5,0,0.2,9.8");
    }
    poses.push_back(*pose);
  }
  check(poses, where);
  return poses;
}

std::vector<EyePose> eyePathFromJson(const std::string& text, const std::string& where) {
  return readAs("docs/observer.md#series", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    const nlohmann::json& list = fields.value("poses");
    fields.rejectUnknown();
    if (!list.is_array()) {
      fields.fail("poses", "must be an array");
    }
    std::vector<EyePose> poses;
    for (const nlohmann::json& item : list) {
      JsonFields pose(item, where + ", pose " + std::to_string(poses.size() + 1));
      const double seconds = pose.number("time", -kMaxSeconds, kMaxSeconds);
      const std::vector<double> eye = pose.numbers("eye", 3, -kMaxRadii, kMaxRadii);
      pose.rejectUnknown();
      poses.push_back({seconds, glm::vec3(eye[0], eye[1], eye[2])});
    }
    check(poses, where);
    return poses;
  });
}

glm::vec3 eyeAt(const std::vector<EyePose>& poses, double seconds) {
  OC_CHECK(!poses.empty(), "a path has poses");
  const auto after = std::ranges::lower_bound(poses, seconds, {}, &EyePose::seconds);
  if (after == poses.begin() || after == poses.end()) {
    return after == poses.begin() ? poses.front().eye : poses.back().eye;
  }
  const EyePose& a = *std::prev(after);
  const EyePose& b = *after;
  const double share = std::clamp((seconds - a.seconds) / (b.seconds - a.seconds), 0.0, 1.0);
  return glm::mix(a.eye, b.eye, static_cast<float>(share));
}

std::vector<glm::vec3> eyesAlong(const std::vector<EyePose>& poses, double framesPerSecond) {
  OC_CHECK(!poses.empty() && framesPerSecond > 0, "a path has poses and a rate");
  // A frame that rounding would lose at the end is seen.
  const double frames = std::floor((poses.back().seconds - poses.front().seconds) * framesPerSecond + 1e-6) + 1;
  if (!(frames <= kMaxFrames)) {
    throw InputError("this path and this rate make more than 100000 frames", "--rate", "give a lower rate");
  }
  std::vector<glm::vec3> eyes;
  for (int i = 0; i < static_cast<int>(frames); ++i) {
    eyes.push_back(eyeAt(poses, poses.front().seconds + i / framesPerSecond));
  }
  return eyes;
}

std::string placeOnWay(const std::vector<EyePose>& poses, double framesPerSecond, size_t frame) {
  const double time = poses.front().seconds + static_cast<double>(frame) / framesPerSecond;
  const auto after = std::ranges::lower_bound(poses, time, {}, &EyePose::seconds);
  const auto number = static_cast<size_t>(after - poses.begin()) + 1;
  if (after == poses.end() || after->seconds == time) {
    return "at pose " + std::to_string(std::min(number, poses.size()));
  }
  return "between poses " + std::to_string(number - 1) + " and " + std::to_string(number);
}

}  // namespace ocelli
