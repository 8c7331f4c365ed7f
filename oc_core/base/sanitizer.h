// Whether AddressSanitizer watches this build: it reserves all of the address space, so that limits on memory cannot be
// set.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define OCELLI_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define OCELLI_ADDRESS_SANITIZER 1
#endif
#endif
#ifndef OCELLI_ADDRESS_SANITIZER
#define OCELLI_ADDRESS_SANITIZER 0
#endif

namespace ocelli {

inline constexpr bool kAddressSanitizer = OCELLI_ADDRESS_SANITIZER == 1;

}  // namespace ocelli
