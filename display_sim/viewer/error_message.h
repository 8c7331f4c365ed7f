// What the window says of something that failed on another thread.
#pragma once

#include <exception>
#include <string>

namespace ocelli {

/// Its message; for lack of memory, one that says what to do. `error` is not null.
std::string errorMessage(const std::exception_ptr& error);

}  // namespace ocelli
