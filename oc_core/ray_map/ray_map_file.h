// Ray maps (oc_core/camera/ray_map.h) as OpenEXR files, which docs/ray_maps.md specifies: how any camera of any program
// comes into the toolkit, and how its own leave it.
//
// Straight rays are one part of float channels origin.x, origin.y, origin.z, direction.x, direction.y, direction.z.
// Rays that bend are a part for each segment, from the nearest on, with the segment's length.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "oc_core/camera/ray_map.h"

namespace ocelli {

/// Whether `--camera` takes a text as the file of a ray map: its name ends in ".exr".
bool namesRayMap(std::string_view nameOrFile);
/// Whether an EXR file has rays, and not something else: its first part says where they begin. Throws InputError where
/// there is no such file.
bool holdsRays(const std::filesystem::path& path);

/// Throws WorkError where the file cannot be written in full.
void writeRayMap(const std::filesystem::path& path, const RayMap& map, const Progress& progress = {});
std::string rayMapBytes(const RayMap& map, const Progress& progress = {});

/// Throws InputError for a file that is missing, broken, no EXR or no ray map, naming channel, part or pixel.
RayMap readRayMap(const std::filesystem::path& path);
/// The same from the bytes of a file; `where` names them in messages.
RayMap rayMapFromBytes(std::string_view bytes, const std::string& where);

/// Size and notes alone, without the rays. Throws as readRayMap() does, where the headers tell.
struct RayMapHeader {
  glm::ivec2 size{0};
  RayMapNotes notes;
};
RayMapHeader readRayMapHeader(const std::filesystem::path& path);

}  // namespace ocelli
