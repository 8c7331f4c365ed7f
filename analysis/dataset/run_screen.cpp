#include "analysis/dataset/run_screen.h"

#include <cmath>
#include <nlohmann/json.hpp>

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
  const Fields monitor = environment.in("monitor");
  const Fields graphics = environment.in("graphics");
  const Fields check(Json::parse(run.timingCheck, nullptr, false));
  const Fields measured = check.in("measured");
  RunScreen screen;
  screen.simulated = environment.flag("simulated");
  screen.monitor = monitor.text("name");
  screen.widthPixels = monitor.positive("width");
  screen.heightPixels = monitor.positive("height");
  screen.widthMillimeters = monitor.positive("width_millimeters");
  screen.heightMillimeters = monitor.positive("height_millimeters");
  screen.refreshHertz = monitor.positive("refresh_hertz");
  screen.graphics = graphics.text("renderer");
  screen.softwareRendered = graphics.flag("software");
  screen.pacedHertz = environment.positive("paced_hertz");
  screen.notMeasured = environment.texts("not_measured");
  screen.verdict = check.text("verdict");
  screen.measuredHertz = measured.positive("hertz");
  screen.jitterShare = measured.real("jitter_share");
  screen.lateShare = measured.real("late_share");
  return screen;
}

}  // namespace ocelli
