// Displays, and showing volumes on them in time with them.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>

#include "display_driver/devices/device_kinds.h"
#include "display_driver/pacing/pacer.h"
#include "display_driver/pacing/presentation_report.h"
#include "display_driver/pacing/recording_source.h"
#include "display_driver/pacing/still_source.h"
#include "python/bindings/bindings.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

double secondsSince(HostTime begin) {
  return std::chrono::duration<double>(realClock().now() - begin).count();
}

struct SourceToShow {
  std::unique_ptr<VolumeSource> source;
  DisplayProfile profile;
};

SourceToShow sourceOf(const std::variant<const Volume*, std::filesystem::path>& shown, bool loop) {
  if (const auto* volume = std::get_if<const Volume*>(&shown)) {
    return {std::make_unique<StillSource>(**volume), (*volume)->profile()};
  }
  auto recording = std::make_unique<RecordingSource>(std::get<std::filesystem::path>(shown), loop);
  DisplayProfile profile = recording->profile();
  return {std::move(recording), std::move(profile)};
}

void requireSameDisplay(const Device& device, const DisplayProfile& profile) {
  if (profile != device.profile()) {
    throw InputError("the volume is for the display " + profile.name + "; the device is a " + device.profile().name,
                     "device", "slice the scene for that display");
  }
}

/// Waits for the display, shows the source, and tells what became of it. `seconds` count from the start; nothing: until
/// the source ends, or `progress` throws.
PresentationReport presented(Device& device, VolumeSource& source, std::optional<double> seconds,
                             const PacerOptions& options, const Progress& progress) {
  PresentationReport result;
  const HostTime begin = realClock().now();
  const auto share = [&] { return seconds && *seconds > 0 ? std::min(secondsSince(begin) / *seconds, 1.0) : 0; };
  const auto isOver = [&] { return seconds && secondsSince(begin) >= *seconds; };
  result.absent = !device.telemetry().connected;
  while (result.absent && !isOver()) {
    report(progress, "waiting for the display", share());
    realClock().waitUntil(realClock().now() + std::chrono::milliseconds(20));
    result.absent = !device.telemetry().connected;
  }
  if (!result.absent) {
    PacerOptions rest = options;
    if (seconds) {
      rest.seconds = std::max(0.0, *seconds - secondsSince(begin));
    }
    Pacer pacer(device, source, realClock(), rest);
    result.summary = pacer.run([&] {
      report(progress, "showing", share());
      return false;
    });
  }
  result.device = device.info();
  result.profile = device.profile().name;
  result.telemetry = device.telemetry();
  return result;
}

std::string present(const std::variant<const Volume*, std::filesystem::path>& shown, const std::string& device,
                    std::optional<double> seconds, bool loop, bool tear, bool coarse, const py::object& progress) {
  if (seconds && !(*seconds >= 0 && *seconds < 1e9)) {
    throw InputError("nothing is shown that long", "seconds", "give a number of seconds, or None");
  }
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  SourceToShow source = sourceOf(shown, loop);
  DeviceOptions options;
  options.profile = source.profile;
  const std::unique_ptr<Device> opened = openDevice(device, options);
  requireSameDisplay(*opened, source.profile);
  const PresentationReport result =
      presented(*opened, *source.source, seconds, {.tearWhenLate = tear, .coarseWhenLate = coarse}, told.function());
  opened->close();
  if (seconds != 0.0) {
    requireFrames(result, device);
  }
  return reportJson(result);
}

}  // namespace

void bindDevices(py::module_& module) {
  module.def("device_kinds", [] {
    std::vector<std::tuple<std::string, std::string, std::string>> rows;
    for (const DeviceKind& kind : deviceKinds()) {
      rows.emplace_back(kind.name, kind.usage(), kind.help);
    }
    return rows;
  });
  module.def("present", &present, py::arg("shown"), py::arg("device"), py::arg("seconds"), py::arg("loop"),
             py::arg("tear"), py::arg("coarse"), py::arg("progress"));
}

}  // namespace ocelli
