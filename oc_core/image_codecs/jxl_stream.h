// What is known of a JPEG XL file before libjxl decodes it. libjxl 0.7 takes no limit of memory (its memory manager is
// asked for the decoder's own record alone), and decodes frames that are not shown, of any size and number, without a
// word: they have to be refused by the bytes.
#pragma once

#include <cstddef>
#include <span>

namespace ocelli {

inline constexpr const char* kJxlName = "JPEG XL";

/// The codestream of a file: the bytes themselves, or what a container of boxes has in one piece. Throws InputError for
/// a container with a codestream in parts, or with boxes that an image needs none of (metadata, a JPEG).
std::span<const std::byte> jxlCodestream(std::span<const std::byte> file);

/// Throws InputError unless a frame that is shown begins with these bytes. `frame` is what follows the headers of the
/// image.
void checkJxlFrameShown(std::span<const std::byte> frame);

}  // namespace ocelli
