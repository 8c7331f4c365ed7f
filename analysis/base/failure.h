// A computation that must not end the ones beside it: what it throws becomes a text that stands in its place.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace ocelli {

/// The message of what `work` throws, in one line; nothing where it throws nothing. A lack of memory is thrown on.
/// It is a second line of defence: what data cannot give is Estimable, and a message here is a fault of the program.
std::optional<std::string> failureOf(const std::function<void()>& work);

}  // namespace ocelli
