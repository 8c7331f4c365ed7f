#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/machine.h"
#include "oc_core/isosurface/isosurface.h"

#ifdef OCELLI_WITH_USB
#include "display_driver/usb/usb_port.h"
#endif
#ifdef OCELLI_WITH_EMULATOR
#include "display_driver/emulator/usb_emulator.h"
#endif
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/window/gl_report.h"
#include "oc_core/window/system_font.h"
#endif

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCompiler = "C++ compiler " __VERSION__;
#ifdef OCELLI_WITH_OPENGL
constexpr bool kWithOpenGl = true;
#else
constexpr bool kWithOpenGl = false;
#endif

#ifdef OCELLI_WITH_USB
constexpr bool kWithUsb = true;
#else
constexpr bool kWithUsb = false;
#endif

#ifdef OCELLI_WITH_EMULATOR
constexpr bool kWithEmulator = true;
#else
constexpr bool kWithEmulator = false;
#endif

#ifdef OCELLI_WITH_REMOTE
constexpr bool kWithRemote = true;
#else
constexpr bool kWithRemote = false;
#endif

struct UsbFindings {
  size_t displays = 0;
  std::string problem;          ///< why USB, or a display on it, cannot be used; empty where all can
  std::string emulatorProblem;  ///< why no display can be emulated; empty where one can
};

/// Of the program that `ocelli feeds` becomes.
struct FeedsFindings {
  std::string program;  ///< its path; empty where it is missing
  std::string problem;  ///< why it does not start; empty where it does
};

/// What is printed, in words or as JSON.
struct Findings {
  MachineInfo machine;
  std::optional<std::filesystem::path> ffmpeg;
  std::optional<std::string> font;
  Json providers = Json::array();
  std::set<std::string> packages;  ///< that hold the providers which do not work
  UsbFindings usb = {};
  FeedsFindings feeds = {};
};

FeedsFindings findFeeds() {
  constexpr double kMaxSeconds = 20;
  FeedsFindings findings;
  try {
    findings.program = findOwnProgram(feedsProgram()).string();
    const ChildEnd end = runChild({findings.program, {"--version"}, kMaxSeconds}, [] {});
    if (end.how != ChildEnd::How::kExited || end.code != 0) {
      findings.problem = end.messages.empty() ? "it ends at once" : end.messages;
    }
  } catch (const WorkError& error) {
    findings.problem = error.what();
  }
  return findings;
}

std::string feedsText(const FeedsFindings& feeds) {
  return feeds.problem.empty() ? "work (ocelli feeds)" : "do not work\n" + feeds.problem;
}

#ifdef OCELLI_WITH_USB
UsbFindings findUsb() {
  UsbFindings findings;
  try {
    const std::vector<UsbDisplay> displays = listUsbDisplays();
    findings.displays = displays.size();
    for (const UsbDisplay& display : displays) {
      findings.problem = findings.problem.empty() ? display.problem : findings.problem;
    }
  } catch (const wire::LinkError& error) {
    findings.problem = error.what();
  }
  return findings;
}
#else
UsbFindings findUsb() {
  return {};
}
#endif

std::string findEmulatorProblem() {
#ifdef OCELLI_WITH_EMULATOR
  const auto error = UsbEmulator::preloadError();
  return error ? error->what() : "";
#else
  return "";
#endif
}

std::string emulatorText(const UsbFindings& usb) {
  if (!kWithEmulator) {
    return "built without it (OCELLI_WITH_EMULATOR=OFF); ocelli device emulate does not exist";
  }
  return usb.emulatorProblem.empty() ? "works (ocelli device emulate)" : "does not work\n" + usb.emulatorProblem;
}

std::string usbText(const UsbFindings& usb) {
  if (!kWithUsb) {
    return "built without it (OCELLI_WITH_USB=OFF); displays on USB cannot be used";
  }
  if (usb.displays == 0) {
    return usb.problem.empty() ? "works; no display is connected" : "does not work\n" + usb.problem;
  }
  return fmt::format("works; {} display{} connected (ocelli device list){}{}", usb.displays,
                     usb.displays == 1 ? "" : "s", usb.problem.empty() ? "" : "\n", usb.problem);
}

#ifdef OCELLI_WITH_OPENGL
Json jsonOf(const GlProviderReport& report) {
  Json json = {{"provider", nameOf(report.provider)}, {"works", report.info.has_value()}};
  if (!report.info) {
    json["error"] = report.error;
    return json;
  }
  const GlInfo& info = *report.info;
  json.update({{"software", info.isSoftware},
               {"renderer", info.renderer},
               {"vendor", info.vendor},
               {"version", info.version},
               {"shading_language", info.shadingLanguage},
               {"device", info.device},
               {"max_texture_size", info.maxTextureSize},
               {"max_texture_layers", info.maxTextureLayers},
               {"max_storage_bytes", info.maxStorageBytes},
               {"max_compute_invocations", info.maxComputeInvocations}});
  return json;
}

void findOpenGl(Findings& findings) {
  for (const GlProviderReport& report : reportGlProviders()) {
    findings.providers.push_back(jsonOf(report));
    if (!report.info) {
      const std::vector<std::string> packages = packagesOf(report.provider);
      findings.packages.insert(packages.begin(), packages.end());
    }
  }
  if (const auto font = findSystemFont()) {
    findings.font = font->name;
  }
}
#else
void findOpenGl(Findings& /*findings*/) {}
#endif

bool anyProvider(const Findings& findings, const char* field, bool value) {
  return std::ranges::any_of(findings.providers,
                             [&](const Json& provider) { return provider.value(field, !value) == value; });
}

std::string asJson(const Findings& findings) {
  const MachineInfo& machine = findings.machine;
  const Json json = {
      {"version", OCELLI_VERSION},
      {"compiler", __VERSION__},
      {"built_with_opengl", kWithOpenGl},
      {"processor", {{"name", machine.processor}, {"threads", machine.threads}, {"avx2", machine.hasAvx2}}},
      {"memory", {{"bytes", machine.memoryBytes}, {"available_bytes", machine.availableBytes}}},
      {"ffmpeg", findings.ffmpeg ? Json(findings.ffmpeg->string()) : Json()},
      {"font", findings.font ? Json(*findings.font) : Json()},
      {"usb", {{"built", kWithUsb}, {"displays", findings.usb.displays}, {"problem", findings.usb.problem}}},
      {"usb_emulator",
       {{"built", kWithEmulator},
        {"works", kWithEmulator && findings.usb.emulatorProblem.empty()},
        {"problem", findings.usb.emulatorProblem}}},
      {"remote", {{"built", kWithRemote}}},
      {"feeds",
       {{"works", findings.feeds.problem.empty()},
        {"program", findings.feeds.program},
        {"problem", findings.feeds.problem}}},
      {"isosurfaces", {{"built", canExtractIsosurfaces()}}},
      {"opengl", anyProvider(findings, "works", true)},
      {"gpu", anyProvider(findings, "software", false)},
      {"providers", findings.providers}};
  return textOfJson(json, 2) + "\n";
}

std::string row(const std::string& name, const std::string& text) {
  std::string indented;
  for (const char c : text) {
    indented += c == '\n' ? std::string("\n") + std::string(14, ' ') : std::string(1, c);
  }
  return fmt::format("  {:<10}  {}\n", name, indented);
}

std::string rowOf(const Json& provider) {
  const std::string name = provider.at("provider");
  if (!provider.at("works")) {
    return row(name, "does not work\n" + provider.at("error").get<std::string>());
  }
  const std::string device = provider.at("device");
  return row(
      name,
      fmt::format("works, on {}: {}{}\nOpenGL {}\nimages up to {} pixels a side, {} layers; buffers up to {} MiB",
                  provider.at("software").get<bool>() ? "the CPU" : "a GPU", provider.at("renderer").get<std::string>(),
                  device.empty() ? "" : " (" + device + ")", provider.at("version").get<std::string>(),
                  provider.at("max_texture_size").get<int>(), provider.at("max_texture_layers").get<int>(),
                  provider.at("max_storage_bytes").get<int64_t>() >> 20));
}

/// What it comes down to, and what to install.
std::string verdict(const Findings& findings) {
  if (!kWithOpenGl) {
    return "OpenGL: not available, for this program was built without it (OCELLI_WITH_OPENGL=OFF).\n"
           "Everything but the window works, on the CPU.\n";
  }
  if (!anyProvider(findings, "works", true)) {
    return "OpenGL: not available. Everything but the window works all the same, on the CPU.\n"
           "To install Mesa's OpenGL, on Debian, as root:\n  apt-get install --no-install-recommends " +
           fmt::format("{}\n", fmt::join(findings.packages, " "));
  }
  if (!anyProvider(findings, "software", false)) {
    return "OpenGL: available, drawn by the CPU. No GPU was found; if there is one, install its driver.\n";
  }
  return "OpenGL: available, on a GPU.\n";
}

std::string asText(const Findings& findings) {
  const MachineInfo& machine = findings.machine;
  constexpr double kGibibyte = 1 << 30;
  std::string text = fmt::format("Ocelli {}\n", OCELLI_VERSION);
  text += row("built", fmt::format("{}, OpenGL {}", kCompiler, kWithOpenGl ? "on" : "off"));
  text += row("processor", fmt::format("{}{}{} threads, {}", machine.processor, machine.processor.empty() ? "" : ", ",
                                       machine.threads, machine.hasAvx2 ? "AVX2" : "no AVX2"));
  text += row("memory",
              fmt::format("{:.1f} GiB, {:.1f} GiB of it free", static_cast<double>(machine.memoryBytes) / kGibibyte,
                          static_cast<double>(machine.availableBytes) / kGibibyte));
  text += row("ffmpeg", findings.ffmpeg ? findings.ffmpeg->string()
                                        : "not found; it makes films of series of images (apt-get install ffmpeg)");
  text += row("usb", usbText(findings.usb));
  text += row("emulator", emulatorText(findings.usb));
  text += row("remote", kWithRemote ? "works (ocelli remote serve)"
                                    : "built without it (OCELLI_WITH_REMOTE=OFF); ocelli remote serve needs "
                                      "libwebsockets (apt-get install libwebsockets-dev)");
  text += row("feeds", feedsText(findings.feeds));
  text += row("surfaces", canExtractIsosurfaces()
                              ? "of volumes: work (--iso)"
                              : "of volumes: built without them (OCELLI_WITH_OPENVDB=OFF); --iso needs OpenVDB "
                                "(apt-get install libopenvdb-dev)");
  if (kWithOpenGl) {
    text +=
        row("font", findings.font.value_or("none found; panels use a plain one (apt-get install fonts-dejavu-core)"));
  }
  for (const Json& provider : findings.providers) {
    text += rowOf(provider);
  }
  return text + "\n" + verdict(findings);
}

}  // namespace

void addDoctorCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("doctor", "What works on this machine, and what to install");
  const auto json = std::make_shared<bool>(false);
  command.add_flag("--json", *json, "Print the findings as JSON");
  context.finish(command,
                 "  ocelli doctor\n"
                 "  LIBGL_ALWAYS_SOFTWARE=1 ocelli doctor      (without the GPU)",
                 [json, context] {
                   Findings findings{machineInfo(), findProgram("ffmpeg"), std::nullopt, Json::array(), {}, findUsb()};
                   findings.usb.emulatorProblem = findEmulatorProblem();
                   findings.feeds = findFeeds();
                   findOpenGl(findings);
                   context.print(*json ? asJson(findings) : asText(findings));
                 });
}

}  // namespace ocelli
