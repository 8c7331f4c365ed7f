#include "analysis/dataset/run_screen.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/outline/run_fields.h"

namespace ocelli {
namespace {

using Json = nlohmann::json;

/// Reads fields of an object, or nothing.
class Fields {
 public:
  explicit Fields(Json json) : json_(std::move(json)) {}

  Fields in(const char* name) const { return Fields(value(name)); }
  std::string text(const char* name) const {
    const Json found = value(name);
    return found.is_string() ? found.get<std::string>() : "";
  }
  std::optional<double> positive(const char* name) const {
    const std::optional<double> number = real(name);
    return number && *number > 0 ? number : std::nullopt;
  }
  std::optional<double> real(const char* name) const {
    const Json found = value(name);
    const double number = found.is_number() ? found.get<double>() : 0;
    return found.is_number() && std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
  }
  bool flag(const char* name) const {
    const Json found = value(name);
    return found.is_boolean() && found.get<bool>();
  }
  std::vector<std::string> texts(const char* name) const {
    std::vector<std::string> list;
    for (const Json& each : value(name)) {
      if (each.is_string()) {
        list.push_back(each.get<std::string>());
      }
    }
    return list;
  }

 private:
  Json value(const char* name) const { return json_.is_object() && json_.contains(name) ? json_[name] : Json(); }

  Json json_;
};

}  // namespace

RunScreen screenOf(const Run& run) {
  const Fields environment(Json::parse(run.environment, nullptr, false));
  const Fields monitor = environment.in(run_fields::kMonitor);
  const Fields graphics = environment.in(run_fields::kGraphics);
  const Fields check(Json::parse(run.timingCheck, nullptr, false));
  const Fields measured = check.in(run_fields::kMeasured);
  RunScreen screen;
  screen.simulated = environment.flag(run_fields::kSimulated);
  screen.monitor = monitor.text(run_fields::kName);
  screen.widthPixels = monitor.positive(run_fields::kWidth);
  screen.heightPixels = monitor.positive(run_fields::kHeight);
  screen.widthMillimeters = monitor.positive(run_fields::kWidthMillimeters);
  screen.heightMillimeters = monitor.positive(run_fields::kHeightMillimeters);
  screen.refreshHertz = monitor.positive(run_fields::kRefreshHertz);
  screen.graphics = graphics.text(run_fields::kRenderer);
  screen.softwareRendered = graphics.flag(run_fields::kSoftware);
  screen.pacedHertz = environment.positive(run_fields::kPacedHertz);
  screen.notMeasured = environment.texts(run_fields::kNotMeasured);
  screen.verdict = check.text(run_fields::kVerdict);
  screen.measuredHertz = measured.positive(run_fields::kHertz);
  screen.jitterShare = measured.real(run_fields::kJitterShare);
  screen.lateShare = measured.real(run_fields::kLateShare);
  return screen;
}

}  // namespace ocelli
