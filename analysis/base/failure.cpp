#include "analysis/base/failure.h"

#include <algorithm>
#include <exception>
#include <new>

namespace ocelli {

std::optional<std::string> failureOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    std::string message = error.what();
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return message.empty() ? "an error without a message" : message;
  }
  return std::nullopt;
}

}  // namespace ocelli
