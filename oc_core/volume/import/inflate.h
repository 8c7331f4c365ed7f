// Deflated bytes, as zlib or gzip wraps them, piece by piece.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "oc_core/base/byte_sink.h"

namespace ocelli {

/// Gives the next deflated bytes, or none at the end.
using ByteFeed = std::function<std::span<const std::byte>()>;

/// Hands on what the bytes inflate to, `limit` bytes at most, and returns how many that were. Streams may follow one
/// another, as members of gzip do; what follows the last one and is none is left alone. Throws InputError, naming
/// `where`, where the bytes are not deflated, damaged, or end within a stream.
uint64_t inflateBytes(const ByteFeed& feed, uint64_t limit, const std::string& where, const ByteSink& sink);

}  // namespace ocelli
