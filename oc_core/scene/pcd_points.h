// Points as PCD files, the format of the Point Cloud Library, version 0.7 and those before.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

#include "oc_core/scene/point_cloud.h"

namespace ocelli {

/// Whether a file is one by its ending.
bool isPcdFile(const std::filesystem::path& path);

/// Reads DATA ascii, binary and binary_compressed. The fields x, y and z must be there; rgb or rgba, the bytes of an
/// sRGB colour in one number, and normal_x, normal_y and normal_z may be; all others are skipped, as is VIEWPOINT, from
/// where it was scanned. Points with a coordinate that is not finite are left out: such clouds have places for what a
/// scanner did not see. Throws InputError naming `where` for a header or points that cannot be, for a file that is too
/// short, and for more than kMaxScenePoints. Memory is bounded by the size of the file.
PointCloud readPcdPoints(const std::filesystem::path& path);
/// The same of a stream of `size` bytes.
PointCloud readPcdPoints(std::istream& stream, uint64_t size, const std::string& where);

}  // namespace ocelli
