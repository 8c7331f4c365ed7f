// Which instruction sets Highway's foreach_target.h compiles a file for: to be included before it.
//
// Not SSSE3, as what has it and matters has SSE4; not AVX3_DL, which adds nothing that is used here; not those that
// Debian's compiler or Highway do not choose at run time. Sanitized builds take the baseline and AVX2 alone: what they
// look for is the same in all, and each takes them a minute to compile.
#pragma once

#include "oc_core/base/sanitizer.h"

#define OCELLI_UNUSED_VECTOR_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#if OCELLI_ADDRESS_SANITIZER
#define HWY_DISABLED_TARGETS (OCELLI_UNUSED_VECTOR_TARGETS | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS OCELLI_UNUSED_VECTOR_TARGETS
#endif
