#include "oc_core/depth_views/depth_views_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/parallel.h"
#include "oc_core/depth_views/views_fields.h"
#include "oc_core/depth_views/views_file.h"
#include "oc_core/image/color.h"
#include "oc_core/image/level_png.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNextFolder = "ocelli ocri views SCENE -o FOLDER makes such a folder; docs/views_with_depth.md";

std::vector<fs::path> exrFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator each(folder, error); !error && each != fs::directory_iterator(); each.increment(error)) {
    if (each->path().extension() == ".exr") {
      files.push_back(each->path());
    }
  }
  if (error) {
    throw InputError("cannot read this folder (" + error.message() + ")", folder.string(), kNextFolder);
  }
  std::sort(files.begin(), files.end());
  return files;
}

ReferenceImage imageOf(const fs::path& folder, const ListedView& listed) {
  const fs::path depthPath = folder / listed.depthFile;
  const Image<Rgb8> color = readPng(folder / listed.colorFile);
  const Image<uint16_t> levels = readLevelPng(depthPath);
  if (color.width() != levels.width() || color.height() != levels.height()) {
    throw InputError(fmt::format("its depth is {}x{}, and its colour ({}) {}x{}", levels.width(), levels.height(),
                                 listed.colorFile, color.width(), color.height()),
                     depthPath.string(), "give both in one size");
  }
  // Refuses sizes that no camera has, before there is an image of it.
  const PinholeCamera camera(listed.view, color.width(), color.height());
  ReferenceImage image = blankReferenceImage("di", camera.view(), color.width(), color.height());
  parallelFor(levels.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      image.color[i] = {linearFromSrgbByte(color[i].x), linearFromSrgbByte(color[i].y), linearFromSrgbByte(color[i].z)};
      image.t[i] = listed.levels.zOf(levels[i]);
      image.held[i] = levels[i] != 0;
    }
  });
  return image;
}

std::vector<DepthView> listedViews(const fs::path& folder, const Progress& progress) {
  const fs::path file = folder / kViewsFile;
  const std::vector<ListedView> listed = viewsFromJsonText(readFile(file, kMaxTextBytes), file.string());
  std::vector<DepthView> views;
  for (const ListedView& each : listed) {
    report(progress, "reading views", static_cast<double>(views.size()) / static_cast<double>(listed.size()));
    views.push_back({each.name, imageOf(folder, each)});
    requireDepthView(views.back().image, (folder / each.depthFile).string());
  }
  return views;
}

std::vector<DepthView> exrViews(const fs::path& folder, const Progress& progress) {
  const std::vector<fs::path> files = exrFiles(folder);
  if (files.empty()) {
    throw InputError(fmt::format("there are no views in this folder: no {} and no .exr files", kViewsFile),
                     folder.string(), kNextFolder);
  }
  std::vector<DepthView> views;
  for (size_t i = 0; i < files.size(); ++i) {
    report(progress, "reading views", static_cast<double>(i) / static_cast<double>(files.size()));
    ReferenceImages images = readReferenceImages(files[i]);
    for (size_t part = 0; part < images.size(); ++part) {
      const std::string number = images.size() > 1 ? fmt::format(" part {}", part) : "";
      requireDepthView(images[part], files[i].string() + number);
      views.push_back({files[i].stem().string() + number, std::move(images[part])});
    }
    if (views.size() > kMaxDepthViews) {
      throw InputError(fmt::format("these are more than {} views", kMaxDepthViews), folder.string(),
                       "take some of them to another folder");
    }
  }
  return views;
}

void writeAsExr(const fs::path& folder, const std::vector<DepthView>& views, const Progress& progress) {
  for (size_t i = 0; i < views.size(); ++i) {
    report(progress, "writing views", static_cast<double>(i) / static_cast<double>(views.size()));
    writeReferenceImages(folder / (views[i].name + ".exr"), {views[i].image});
  }
}

DepthLevels levelsFor(const ReferenceImage& image) {
  DepthLevels levels{&depthScales()[0], std::numeric_limits<float>::max(), 0};
  for (size_t i = 0; i < image.t.size(); ++i) {
    if (image.holds(i)) {
      levels.near = std::min(levels.near, image.t[i]);
      levels.far = std::max(levels.far, image.t[i]);
    }
  }
  // Of a wall that is seen face on, too.
  levels.near *= 0.999f;
  levels.far *= 1.001f;
  return levels;
}

void writeAsPng(const fs::path& folder, const std::vector<DepthView>& views, const Progress& progress) {
  std::vector<ListedView> listed;
  for (const DepthView& view : views) {
    report(progress, "writing views", static_cast<double>(listed.size()) / static_cast<double>(views.size()));
    if (view.image.isPlaced()) {
      throw InputError("PNG files hold views of pinholes, and this is a panorama", view.name,
                       "write them as EXR files");
    }
    const DepthLevels levels = levelsFor(view.image);
    Image<uint16_t> depths(view.image.width(), view.image.height());
    for (size_t i = 0; i < depths.size(); ++i) {
      depths[i] = view.image.holds(i) ? levels.levelOf(view.image.t[i]) : uint16_t{0};
    }
    listed.push_back({view.name, view.name + ".png", view.name + "_depth.png", view.image.view, levels});
    writePng(folder / listed.back().colorFile, srgbFromLinear(view.image.color));
    writeLevelPng(folder / listed.back().depthFile, depths);
  }
  // Last of all, so that a folder with it is complete.
  writeFile(folder / kViewsFile, viewsJsonText(listed));
}

}  // namespace

std::vector<DepthView> readDepthViews(const fs::path& folder, const Progress& progress) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError("there is no such folder", folder.string(), kNextFolder);
  }
  std::vector<DepthView> views =
      fs::exists(folder / kViewsFile, error) ? listedViews(folder, progress) : exrViews(folder, progress);
  requireDifferentViews(views, folder.string());
  return views;
}

const std::array<DepthViewsFormat, 2>& depthViewsFormats() {
  static const std::array<DepthViewsFormat, 2> formats{{
      {"exr", "an EXR file each, exact", writeAsExr},
      {"png", "colours and depths of 16 bits as PNG files, and views.json", writeAsPng},
  }};
  return formats;
}

void writeDepthViews(const fs::path& folder, const std::vector<DepthView>& views, const DepthViewsFormat& format,
                     const Progress& progress) {
  makeFolder(folder);
  std::error_code error;
  if (fs::exists(folder / kViewsFile, error) || !exrFiles(folder).empty()) {
    throw InputError("this folder holds views already, and others would be taken for some of them", folder.string(),
                     "choose an empty folder");
  }
  format.write(folder, views, progress);
}

}  // namespace ocelli
