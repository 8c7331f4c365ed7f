// Observed light as a file: all of it, or toned for the eye.
#pragma once

#include <filesystem>
#include <string>

#include "display_sim/observing/tone.h"

namespace ocelli {

/// OpenEXR with the channels R, G and B, linear and as it is; `description` goes into the text attribute "ocelli".
/// Throws WorkError.
void writeLightExr(const std::filesystem::path& path, const Image<glm::vec3>& light, const std::string& description);

/// An 8-bit PNG, toned first. Throws WorkError.
void writeTonedPng(const std::filesystem::path& path, Image<glm::vec3> light, const Tone& tone);

}  // namespace ocelli
