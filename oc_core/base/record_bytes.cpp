#include "oc_core/base/record_bytes.h"

namespace ocelli {

ErrorText::ErrorText(const std::string& message) {
  constexpr std::string_view kNext = "\n  try: ";
  constexpr std::string_view kDetail = "\n    ";
  const size_t end = std::min(message.find(kNext), message.size());
  next = message.substr(std::min(end + kNext.size(), message.size()));
  size_t at = std::min(message.find(kDetail), end);
  what = message.substr(0, at);
  while (at < end) {
    const size_t begin = at + kDetail.size();
    at = std::min(message.find(kDetail, begin), end);
    details += details.empty() ? "" : "\n";
    details.append(message, begin, at - std::min(begin, at));
  }
}

}  // namespace ocelli
