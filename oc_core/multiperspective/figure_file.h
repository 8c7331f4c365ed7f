// Figures as files.
#pragma once

#include <filesystem>

#include "oc_core/drawing/figure.h"

namespace ocelli {

/// Throws InputError where `path` does not end in .svg or .png; a stream that ends otherwise gets an SVG. To be checked
/// before a figure is made that takes long.
void requireFigureFile(const std::filesystem::path& path);

/// SVG or PNG, as `path` ends; of the PNG a pixel is a point. Throws InputError for other endings, WorkError where it
/// cannot be painted or written.
void writeFigure(const std::filesystem::path& path, const Figure& figure);

}  // namespace ocelli
