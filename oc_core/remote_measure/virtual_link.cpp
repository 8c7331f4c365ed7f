#include "oc_core/remote_measure/virtual_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct RateUnit {
  const char* name;
  double bytes;
};
constexpr std::array<RateUnit, 3> kUnits{{{"KB/s", 1e3}, {"MB/s", 1e6}, {"GB/s", 1e9}}};
constexpr double kMinRate = 1e3;
constexpr double kMaxRate = 1e10;
constexpr double kMaxMilliseconds = 1e4;

/// The number that a text begins with, which is cut off it; negative where there is none.
double takeNumber(std::string_view& text) {
  double number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) {
    return -1;
  }
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

}  // namespace

std::string LinkSpeed::name() const {
  const std::string rate = bytesPerSecond >= 1e9   ? fmt::format("{:g} GB/s", bytesPerSecond / 1e9)
                           : bytesPerSecond >= 1e6 ? fmt::format("{:g} MB/s", bytesPerSecond / 1e6)
                                                   : fmt::format("{:g} KB/s", bytesPerSecond / 1e3);
  return fmt::format("{}, {:g} ms", rate, roundTripSeconds * 1e3);
}

std::vector<LinkSpeed> defaultLinks() {
  std::vector<LinkSpeed> links;
  for (const double rate : {300e3, 1e6, 12.5e6}) {
    for (const double delay : {0.02, 0.2}) {
      links.push_back({rate, delay});
    }
  }
  return links;
}

LinkSpeed linkSpeedFromText(const std::string& text) {
  std::string_view rest = text;
  const double rate = takeNumber(rest);
  for (const RateUnit& unit : kUnits) {
    if (rest.starts_with(unit.name)) {
      rest.remove_prefix(std::string_view(unit.name).size());
      const bool hasColon = rest.starts_with(':');
      rest.remove_prefix(hasColon ? 1 : 0);
      const double milliseconds = takeNumber(rest);
      const double bytes = rate * unit.bytes;
      if (hasColon && rest == "ms" && bytes >= kMinRate && bytes <= kMaxRate && milliseconds >= 0 &&
          milliseconds <= kMaxMilliseconds) {
        return {bytes, milliseconds / 1e3};
      }
    }
  }
  throw InputError("\"" + text + "\" is not a link: its bytes a second and its round trip", "--link",
                   "for example --link 300KB/s:200ms, from 1KB/s to 10GB/s and from 0ms to 10000ms");
}

double VirtualLink::arrival(double seconds, size_t bytes) {
  free_ = std::max(free_, seconds) + static_cast<double>(bytes) / speed_.bytesPerSecond;
  bytes_ += bytes;
  return free_ + speed_.oneWaySeconds();
}

}  // namespace ocelli
