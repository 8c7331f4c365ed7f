// Points as lines of numbers: .xyz and .pts files, of which there are many layouts and no standard.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "oc_core/scene/point_cloud.h"

namespace ocelli {

/// Whether a file is one by its ending.
bool isPointText(const std::filesystem::path& path);

/// A point a line, its numbers apart by blanks, tabs, commas or semicolons. Empty lines and those that start with # or
/// // are skipped. A first line of one whole number is the number of points. All other lines have as many numbers as
/// the first one:
///
///   3  x y z
///   4  x y z, an intensity
///   6  x y z, then a colour where all are whole numbers from 0 to 255 in all of the file, otherwise a normal; a normal
///      too where each line has 1 0 0, 0 1 0 or 0 0 1, as floors and boxes do, and colours that all but black are not
///   7  x y z, an intensity, a colour
///   9  x y z, a colour, a normal
///
/// Colours are sRGB from 0 to 255; intensities are left out. Throws InputError naming the line for anything else,
/// where the file cannot be read to its end, and where there are more than kMaxScenePoints.
PointCloud readTextPoints(const std::filesystem::path& path);
PointCloud readTextPoints(std::istream& stream, const std::string& where);

}  // namespace ocelli
