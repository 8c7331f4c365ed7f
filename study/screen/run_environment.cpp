#include "study/screen/run_environment.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "oc_core/base/json_fields.h"
#include "oc_core/base/machine.h"
#include "study/outline/run_fields.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// "Debian GNU/Linux 12 (bookworm)"; empty where the system does not tell.
std::string systemName() {
  std::ifstream file("/etc/os-release");
  constexpr std::string_view kField = "PRETTY_NAME=";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(kField)) {
      line.erase(0, kField.size());
      std::erase(line, '"');
      return line;
    }
  }
  return {};
}

Json textOf(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? Json(value) : Json();
}

}  // namespace

std::string jsonText(const RunEnvironment& environment) {
  utsname kernel{};
  uname(&kernel);
  const MachineInfo machine = machineInfo();
  const GlInfo& graphics = environment.graphics;
  const Monitor& monitor = environment.monitor;
  const bool paced = environment.pacedHertz > 0;
  const Json json = {
      {"program_version", environment.programVersion},
      {"system", systemName()},
      {"kernel", std::string(kernel.sysname) + " " + kernel.release},
      {"processor", machine.processor},
      {"memory_bytes", machine.memoryBytes},
      {run_fields::kGraphics,
       {{run_fields::kRenderer, graphics.renderer},
        {"vendor", graphics.vendor},
        {"opengl", graphics.version},
        {run_fields::kSoftware, graphics.isSoftware}}},
      {run_fields::kMonitor,
       {{"number", environment.monitorNumber},
        {run_fields::kName, monitor.name},
        {run_fields::kWidth, monitor.width},
        {run_fields::kHeight, monitor.height},
        {run_fields::kRefreshHertz, monitor.refreshHertz > 0 ? Json(monitor.refreshHertz) : Json()},
        {run_fields::kWidthMillimeters, monitor.widthMillimeters},
        {run_fields::kHeightMillimeters, monitor.heightMillimeters}}},
      {"window",
       {{"full_screen", environment.fullScreen},
        {"width", environment.windowWidth},
        {"height", environment.windowHeight}}},
      {"stated_gamma", environment.screen.gamma ? Json(*environment.screen.gamma) : Json()},
      {"calibration", environment.screen.calibration
                          ? Json::parse(environment.calibration.jsonText(*environment.screen.calibration))
                          : Json()},
      {"session",
       {{"type", textOf("XDG_SESSION_TYPE")},
        {"desktop", textOf("XDG_CURRENT_DESKTOP")},
        {"display", textOf("DISPLAY")},
        {"window_system", windowSystemVersion()}}},
      {"clock", "std::chrono::steady_clock"},
      {"input_times",
       "steady clock when the window system's event was taken, on a thread that waits for nothing else; GLFW passes on "
       "no "
       "times of the X server"},
      {"frame_times",
       paced ? Json("steady clock after the swap of buffers, which did not wait for the screen; frames were held back "
                    "by the program")
             : Json("steady clock after a swap of buffers with an interval of 1, a pixel drawn into the next buffer, "
                    "and glFinish")},
      {run_fields::kPacedHertz, paced ? Json(environment.pacedHertz) : Json()},
      {run_fields::kNotMeasured,
       {"latency of mouse and keyboard", "time from the swap of buffers to light", "response of the panel"}}};
  return textOfJson(json);
}

}  // namespace ocelli
