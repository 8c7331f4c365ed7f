#include "oc_core/volume/volume_formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kNrrdEndings{".nrrd", ".nhdr"};
constexpr std::array<std::string_view, 2> kMetaImageEndings{".mha", ".mhd"};
constexpr std::array<std::string_view, 1> kVtiEndings{".vti"};
constexpr std::array<std::string_view, 2> kNiftiEndings{".nii", ".nii.gz"};
constexpr std::array<std::string_view, 3> kDicomEndings{".dcm", ".dicom", ".ima"};
constexpr std::array<VolumeFormat, 5> kVolumeFormats{{{"NRRD", kNrrdEndings, ".nhdr"},
                                                      {"MetaImage", kMetaImageEndings, ".mhd"},
                                                      {"VTI", kVtiEndings},
                                                      {"NIfTI", kNiftiEndings},
                                                      {kDicomFormat, kDicomEndings}}};

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether `a` stands before `b` where runs of digits are compared as numbers.
bool standsBefore(const std::string& a, const std::string& b) {
  size_t i = 0;
  size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const auto digitsAt = [](const std::string& text, size_t& at) {
        while (at < text.size() && text[at] == '0') {
          ++at;
        }
        const size_t begin = at;
        while (at < text.size() && isDigit(text[at])) {
          ++at;
        }
        return text.substr(begin, at - begin);
      };
      const std::string first = digitsAt(a, i);
      const std::string second = digitsAt(b, j);
      if (first != second) {
        return first.size() != second.size() ? first.size() < second.size() : first < second;
      }
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i;
      ++j;
    }
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

const VolumeFormat* dicomFormat() {
  return &kVolumeFormats.back();
}

}  // namespace

std::span<const VolumeFormat> volumeFormats() {
  return kVolumeFormats;
}

bool hasDataElsewhere(const fs::path& path) {
  const VolumeFormat* format = volumeFormatOfName(path);
  return format != nullptr && !format->headerEnding.empty() &&
         lowered(path.filename().string()).ends_with(format->headerEnding);
}

const VolumeFormat* volumeFormatOfName(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  for (const VolumeFormat& format : kVolumeFormats) {
    if (std::any_of(format.endings.begin(), format.endings.end(),
                    [&](std::string_view ending) { return name.size() > ending.size() && name.ends_with(ending); })) {
      return &format;
    }
  }
  return nullptr;
}

bool isDicomFile(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return false;
  }
  constexpr size_t kPreamble = 128;
  std::array<char, kPreamble + 4> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data() + kPreamble, 4) == "DICM";
}

const VolumeFormat* volumeFormatOf(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    const VolumeFormat* named = volumeFormatOfName(path);
    return named != nullptr ? named : isDicomFile(path) ? dicomFormat() : nullptr;
  }
  const std::vector<VolumeFormatFound> found = volumeFormatsIn(path);
  return found.empty() ? nullptr : found.front().format;
}

std::vector<VolumeFormatFound> volumeFormatsIn(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) {
      paths.push_back(at->path());
    }
  }
  std::sort(paths.begin(), paths.end());
  constexpr int kMaxAsked = 1024;
  int asked = 0;
  std::vector<VolumeFormatFound> found;
  for (const fs::path& path : paths) {
    const VolumeFormat* format = volumeFormatOfName(path);
    if (format == nullptr && asked < kMaxAsked) {
      ++asked;
      format = isDicomFile(path) ? dicomFormat() : nullptr;
    }
    if (format == nullptr) {
      continue;
    }
    const auto known = std::find_if(found.begin(), found.end(), [&](const auto& one) { return one.format == format; });
    if (known == found.end()) {
      found.push_back({format, path, 1});
    } else {
      ++known->files;
    }
  }
  return found;
}

std::vector<fs::path> volumeFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const VolumeFormat* format = volumeFormatOfName(at->path());
    if (format != nullptr && format != dicomFormat() && at->is_regular_file(error)) {
      files.push_back(at->path());
    }
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return standsBefore(a.filename().string(), b.filename().string());
  });
  return files;
}

std::string volumeFormatList() {
  std::string list;
  for (const VolumeFormat& format : kVolumeFormats) {
    list += list.empty() ? "" : ", ";
    list += format.name;
    std::string endings;
    for (const std::string_view ending : format.endings) {
      endings += (endings.empty() ? "" : ", ") + std::string(ending);
    }
    list += " (" + endings + ")";
  }
  return list;
}

}  // namespace ocelli
