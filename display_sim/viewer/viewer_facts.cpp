#include "display_sim/viewer/viewer_facts.h"

#include <fmt/format.h>

#include <cmath>

namespace ocelli {

std::string grouped(size_t number) {
  return number < 1000 ? fmt::format("{}", number) : fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

std::string speedText(double speed) {
  return speed >= 1 ? fmt::format("{:.3g}", speed) : fmt::format("1/{:.3g}", 1 / speed);
}

}  // namespace ocelli
