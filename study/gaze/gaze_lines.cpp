#include "study/gaze/gaze_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "oc_core/base/trimmed.h"

namespace ocelli {
namespace {

/// Farther than that from the screen nobody looks: such a number is a mistake.
constexpr double kMaxPixels = 1e6;

using Cells = std::vector<std::string_view>;

/// Nothing where there are too many.
std::optional<Cells> cellsOf(std::string_view line) {
  Cells cells;
  while (true) {
    const size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) {
      return cells;
    }
    if (cells.size() >= GazeLines::kMaxColumns) {
      return std::nullopt;
    }
    line.remove_prefix(comma + 1);
  }
}

/// Any number of the text, which may be "nan".
std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<double> finiteNumberOf(std::string_view text) {
  const std::optional<double> value = numberOf(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> flagOf(std::string_view text) {
  if (text == "1" || text == "true" || text == "1.0") {
    return true;
  }
  return text == "0" || text == "false" || text == "0.0" ? std::optional(false) : std::nullopt;
}

}  // namespace

GazeLines::GazeLines(GazeUnit unit, int screenWidth, int screenHeight)
    : width_(screenWidth), height_(screenHeight), unit_(unit) {}

std::vector<GazeRecord> GazeLines::read(std::string_view lines, int64_t nanoseconds) {
  std::vector<GazeRecord> samples;
  while (!lines.empty()) {
    const size_t end = lines.find('\n');
    const std::string_view line = trimmed(lines.substr(0, end));
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    if (line.empty() || line.front() == '#') {
      continue;
    }
    GazeRecord sample;
    sample.nanoseconds = nanoseconds;
    if (line.size() <= kMaxLineBytes && readSample(line, sample)) {
      samples.push_back(sample);
    } else if (line.size() > kMaxLineBytes || !readNames(line)) {
      ++malformed_;
    }
  }
  return samples;
}

bool GazeLines::readNames(std::string_view line) {
  const std::optional<Cells> cells = cellsOf(line);
  if (!cells) {
    return false;
  }
  const auto columnOf = [&](std::string_view name) {
    const auto found = std::ranges::find(*cells, name);
    return found == cells->end() ? kNone : static_cast<size_t>(found - cells->begin());
  };
  const bool isPixels = columnOf("x_px") != kNone && columnOf("y_px") != kNone;
  const bool isShares = columnOf("x_norm") != kNone && columnOf("y_norm") != kNone;
  const std::array<size_t, kFields> columns{columnOf("time"), columnOf(isPixels ? "x_px" : "x_norm"),
                                            columnOf(isPixels ? "y_px" : "y_norm"), columnOf("valid"),
                                            columnOf("pupil")};
  if (isPixels == isShares || columns[0] == kNone || columns[3] == kNone) {
    return false;
  }
  columns_ = columns;
  unit_ = isPixels ? GazeUnit::kPixels : GazeUnit::kShares;
  pupilMayLack_ = columns[4] == kNone;
  return true;
}

bool GazeLines::readSample(std::string_view line, GazeRecord& sample) const {
  const std::optional<Cells> cells = cellsOf(line);
  if (!cells) {
    return false;
  }
  const auto has = [&](size_t field) { return columns_[field] < cells->size(); };
  const auto cell = [&](size_t field) { return (*cells)[columns_[field]]; };
  if (!has(0) || !has(1) || !has(2) || !has(3) || (!has(4) && !pupilMayLack_)) {
    return false;
  }
  const std::optional<double> time = finiteNumberOf(cell(0));
  const std::optional<bool> valid = flagOf(cell(3));
  if (!time || !valid) {
    return false;
  }
  sample.deviceTime = *time;
  sample.valid = *valid;
  if (sample.valid) {
    const std::optional<double> x = finiteNumberOf(cell(1));
    const std::optional<double> y = finiteNumberOf(cell(2));
    if (!x || !y) {
      return false;
    }
    const bool isShares = unit_ == GazeUnit::kShares;
    sample.x = *x * (isShares ? width_ : 1);
    sample.y = *y * (isShares ? height_ : 1);
    if (std::abs(sample.x) > kMaxPixels || std::abs(sample.y) > kMaxPixels) {
      return false;
    }
  }
  // A pupil that is not known is empty, or no number.
  sample.pupil = has(4) ? finiteNumberOf(cell(4)) : std::nullopt;
  return !has(4) || cell(4).empty() || numberOf(cell(4)).has_value();
}

}  // namespace ocelli
