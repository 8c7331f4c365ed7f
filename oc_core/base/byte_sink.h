// Where bytes go that are made piece by piece.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace ocelli {

using ByteSink = std::function<void(std::span<const std::byte>)>;

}  // namespace ocelli
