#include "display_driver/emulator/preload.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>

#include "display_driver/emulator/usb_emulator.h"
#include "oc_core/base/own_program.h"

namespace ocelli {
namespace {

constexpr const char* kPreloadHint = "install it (Debian: apt-get install umockdev)";

}  // namespace

std::string preloadList() {
  const char* const others = std::getenv("LD_PRELOAD");
  const std::string list = others == nullptr ? "" : others;
  if (list.find(kPreloadLibrary) != std::string::npos) {
    return list;
  }
  return list.empty() ? kPreloadLibrary : fmt::format("{}:{}", kPreloadLibrary, list);
}

bool UsbEmulator::preloaded() {
  void* const loaded = dlopen(kPreloadLibrary, RTLD_LAZY | RTLD_NOLOAD);
  if (loaded != nullptr) {
    dlclose(loaded);
  }
  return loaded != nullptr;
}

std::optional<WorkError> UsbEmulator::preloadError() {
  void* const loaded = dlopen(kPreloadLibrary, RTLD_LAZY | RTLD_LOCAL);
  if (loaded == nullptr) {
    const char* const reason = dlerror();
    return WorkError("umockdev's preload library cannot be loaded", reason == nullptr ? kPreloadLibrary : reason,
                     kPreloadHint);
  }
  dlclose(loaded);
  return std::nullopt;
}

void UsbEmulator::requirePreloaded() {
  if (const auto error = preloadError()) {
    throw *error;
  }
  restartPreloaded();
  if (!preloaded()) {
    throw WorkError("this program cannot be started anew with umockdev's preload library", kPreloadLibrary,
                    "start it with the environment variable LD_PRELOAD set to that name");
  }
}

void UsbEmulator::restartPreloaded() {
  constexpr const char* kTried = "OCELLI_EMULATOR_PRELOADED";
  if (preloaded() || std::getenv(kTried) != nullptr) {
    return;
  }
  setenv(kTried, "1", 1);
  setenv("LD_PRELOAD", preloadList().c_str(), 1);
  // AddressSanitizer wants to be the first library, and works as the second one.
  const char* const options = std::getenv("ASAN_OPTIONS");
  setenv("ASAN_OPTIONS", fmt::format("{}:verify_asan_link_order=0", options == nullptr ? "" : options).c_str(), 1);
  becomeProgram("/proc/self/exe", ownCommandLine());
}

}  // namespace ocelli
