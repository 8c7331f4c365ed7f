// Flashes of the screen as the stimulus of a test of latency: a photodiode before it closes the contact of a button.
#pragma once

#include <string>

#include "study/responses/latency_test.h"

namespace ocelli {

/// In a window that fills the monitor: black, and its upper left quarter white from each flash until the answer.
/// `responses` names a device; the keyboard answers where it is empty. Fills `text`. On the main thread. Throws as
/// openResponseDevice() and GlWindow do.
LatencyReport measureFlashLatency(const std::string& responses, int monitor, const LatencyOptions& options,
                                  LatencyText& text);

}  // namespace ocelli
