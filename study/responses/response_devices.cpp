#include <algorithm>

#include "oc_core/base/error.h"
#include "study/responses/response_device.h"

namespace ocelli {

ResponseDeviceKind gamepadResponses();
ResponseDeviceKind serialResponses();

const std::vector<ResponseDeviceKind>& responseDeviceKinds() {
  static const std::vector<ResponseDeviceKind> kinds{gamepadResponses(), serialResponses()};
  return kinds;
}

std::string responseDeviceForms() {
  std::string forms;
  for (const ResponseDeviceKind& kind : responseDeviceKinds()) {
    forms += (forms.empty() ? "" : ", ") + kind.form;
  }
  return forms;
}

std::unique_ptr<ResponseDevice> openResponseDevice(const std::string& text, const ResponseTools& tools) {
  const size_t colon = text.find(':');
  const auto& kinds = responseDeviceKinds();
  const auto kind = std::ranges::find(kinds, text.substr(0, colon), &ResponseDeviceKind::name);
  if (kind == kinds.end()) {
    throw InputError("this is no device for responses", "--responses " + text,
                     "give one of: " + responseDeviceForms() + "; a keyboard needs none");
  }
  return kind->open(colon == std::string::npos ? "" : text.substr(colon + 1), tools);
}

}  // namespace ocelli
