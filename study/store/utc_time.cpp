#include "study/store/utc_time.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace ocelli {

std::string utcNow() {
  const auto sinceEpoch = std::chrono::system_clock::now().time_since_epoch();
  return utcText(std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count());
}

std::string utcText(int64_t milliseconds) {
  using namespace std::chrono;
  const sys_time<std::chrono::milliseconds> time{std::chrono::milliseconds(milliseconds)};
  const sys_days day = floor<days>(time);
  const year_month_day date{day};
  const hh_mm_ss clock{time - day};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count(), clock.subseconds().count());
}

std::optional<int64_t> millisecondsOfUtc(const std::string& text) {
  using namespace std::chrono;
  int y = 0;
  unsigned mo = 0;
  unsigned d = 0;
  int64_t h = 0;
  int64_t mi = 0;
  int64_t s = 0;
  int64_t ms = 0;
  int read = 0;
  if (std::sscanf(text.c_str(), "%4d-%2u-%2uT%2ld:%2ld:%2ld.%3ldZ%n", &y, &mo, &d, &h, &mi, &s, &ms, &read) != 7 ||
      read != static_cast<int>(text.size()) || text.size() != 24) {
    return std::nullopt;
  }
  const year_month_day date{year{y}, month{mo}, day{d}};
  if (!date.ok() || h < 0 || h > 23 || mi < 0 || mi > 59 || s < 0 || s > 60 || ms < 0) {
    return std::nullopt;
  }
  return sys_days{date}.time_since_epoch() / milliseconds{1} + ((h * 60 + mi) * 60 + s) * 1000 + ms;
}

}  // namespace ocelli
