#include "study/session/utc_time.h"

#include <fmt/format.h>

#include <chrono>

namespace ocelli {

std::string utcText(int64_t milliseconds) {
  using namespace std::chrono;
  const sys_time<std::chrono::milliseconds> time{std::chrono::milliseconds(milliseconds)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count(), clock.subseconds().count());
}

std::string utcNow() {
  using namespace std::chrono;
  return utcText(duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count());
}

}  // namespace ocelli
