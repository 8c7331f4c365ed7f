// OC_CHECK: an assertion that stays on in Release. It guards against bugs of ours, never against bad input.
#pragma once

namespace ocelli {

/// Prints the failed condition and where it stands, then aborts.
[[noreturn]] void checkFailed(const char* condition, const char* message, const char* file, int line);

}  // namespace ocelli

#define OC_CHECK(condition, message) \
  ((condition) ? static_cast<void>(0) : ::ocelli::checkFailed(#condition, message, __FILE__, __LINE__))
