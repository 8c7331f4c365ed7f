#include "oc_core/volume/volume_reader.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/scratch_file.h"
#include "oc_core/volume/mapped_voxels.h"
#include "oc_core/volume/volume_formats.h"
#include "oc_core/volume/volume_record.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

void checkVolumePath(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError("there is no such file", path.string(),
                     "check the path; built-in volumes are written builtin:volume,name=NAME (see `ocelli scene list`)");
  }
  if (!isVolumeFile(path)) {
    throw InputError("this is no volume that can be read", path.string(),
                     "give a file, or a folder with files, of one of these formats: " + volumeFormatList());
  }
}

/// Of all that may be read: a file, or the files of a folder. Headers may name files beside them.
uint64_t bytesToRead(const fs::path& path) {
  std::error_code error;
  const bool isHeader = hasDataElsewhere(path);
  if (!fs::is_directory(path, error) && !isHeader) {
    const uintmax_t bytes = fs::file_size(path, error);
    return error ? 0 : bytes;
  }
  const fs::path folder = isHeader ? fs::absolute(path).parent_path() : path;
  uint64_t sum = 0;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const uintmax_t bytes = at->is_regular_file(ignored) ? at->file_size(ignored) : 0;
    sum += ignored ? 0 : bytes;
  }
  return sum;
}

/// The scratch file, which most volumes do without: that there can be none is an error only for the others.
class VolumeScratch {
 public:
  VolumeScratch() {
    std::error_code error;
    folder_ = fs::temp_directory_path(error);
    if (error) {
      const char* named = std::getenv("TMPDIR");
      reason_ = fmt::format("{}: {}", named == nullptr ? "/tmp" : named, error.message());
      return;
    }
    try {
      file_.emplace(folder_);
    } catch (const WorkError&) {
      reason_ = fmt::format("{}: nothing can be written there", folder_.string());
    }
  }

  const fs::path& folder() const { return folder_; }
  /// Empty where there is none: the reader then writes nothing.
  fs::path link() const { return file_ ? file_->link() : fs::path(); }
  /// Throws WorkError where there is none.
  void check(const fs::path& volume) const {
    if (!file_) {
      throw WorkError("the voxels of this file must be unpacked to the folder for temporary files (" + reason_ + ")",
                      volume.string(), "let the environment variable TMPDIR name a folder in which you may write");
    }
  }

 private:
  fs::path folder_;
  std::optional<ScratchFile> file_;
  std::string reason_;
};

VolumeFile readOne(const fs::path& path, const VolumeFileOptions& options, const Progress& progress) {
  const VolumeScratch scratch;
  const ReaderResult result = runReaderProgram(
      volumeReader(), {scratch.link().string(), scratch.folder().string(), options.series, path.string()}, path,
      bytesToRead(path), [&] { report(progress, "loading the volume", 0); });
  const VolumeRecord record = volumeFromRecord(result.record.bytes(), result.program);
  VolumeFile file{{}, record.times, record.warnings};
  if (record.file.empty()) {
    scratch.check(path);
  }
  const fs::path holder = record.file.empty() ? scratch.link() : fs::path(record.file);
  file.volumes = mapVolumes(record.grid, record.type, holder, record.begins, record.scale, record.offset);
  for (ScalarVolume& volume : file.volumes) {
    volume.setFacts(record.facts);
  }
  return file;
}

/// A stray file of another format would be shown instead of all others.
void refuseMixedFormats(const fs::path& folder) {
  const std::vector<VolumeFormatFound> found = volumeFormatsIn(folder);
  if (found.size() < 2) {
    return;
  }
  std::string list;
  for (const VolumeFormatFound& one : found) {
    list += fmt::format("{}{} of {} ({}{})", list.empty() ? "" : ", ", one.files, one.format->name,
                        one.file.filename().string(), one.files > 1 ? ", ..." : "");
  }
  throw InputError("this folder has volume files of several formats: " + list, folder.string(),
                   "give one of its files, or a folder with files of one format");
}

/// Whether both can stand for one thing at two times.
bool areAlike(const ScalarVolume& a, const ScalarVolume& b) {
  return a.grid().size == b.grid().size && a.grid().worldFromIndex == b.grid().worldFromIndex && a.type() == b.type() &&
         a.grid().isAnatomical == b.grid().isAnatomical && a.grid().unit == b.grid().unit;
}

VolumeFile readNumbered(const std::vector<fs::path>& paths, const VolumeFileOptions& options,
                        const Progress& progress) {
  VolumeFile all;
  for (size_t at = 0; at < paths.size(); ++at) {
    const double share = static_cast<double>(at) / static_cast<double>(paths.size());
    VolumeFile one =
        readOne(paths[at], options, [&](std::string_view, double) { report(progress, "loading the volumes", share); });
    if (one.volumes.size() != 1) {
      throw InputError("a folder of volumes has a file with several", paths[at].string(),
                       "give this file alone, or a folder of files with one volume each");
    }
    if (at > 0 && !areAlike(all.volumes.front(), one.volumes.front())) {
      throw InputError(fmt::format("its grid or its type differs from that of {}", paths.front().filename().string()),
                       paths[at].string(), "give a folder whose files are one thing at several times, or one file");
    }
    all.volumes.push_back(std::move(one.volumes.front()));
    all.times.push_back(static_cast<double>(at));
    for (std::string& warning : one.warnings) {
      if (at == 0) {
        all.warnings.push_back(std::move(warning));
      }
    }
  }
  if (all.volumes.size() > 1) {
    all.warnings.push_back(
        fmt::format("{} files are taken for one volume at times 0, 1, 2, ... s, in the order of "
                    "their names",
                    all.volumes.size()));
  } else {
    all.times.clear();
  }
  return all;
}

}  // namespace

const ReaderProgram& volumeReader() {
  static constexpr ReaderProgram kReader{
      .program =
          {.name = "ocelli-read-volume",
           .installed = OCELLI_VOLUME_READER_INSTALLED,
           .variable = "OCELLI_VOLUME_READER",
           .does = "reads volume files",
           .ifMissing =
               "install libteem-dev, libnifti2-dev, libgdcm-dev and libpugixml-dev and build Ocelli with "
               "OCELLI_WITH_VOLUME_IMPORT=ON, or let the environment variable OCELLI_VOLUME_READER name the program"},
      .library = "the reader",
      .memoryVariable = "OCELLI_VOLUME_MEMORY_GIB",
      .secondsVariable = "OCELLI_VOLUME_SECONDS",
      .convert = "convert it to NRRD without compression",
      .afterCrash = "the file may be damaged: export it again, if need be in another format such as NRRD",
      .reduce = "convert the volume to NRRD without compression"};
  return kReader;
}

bool isVolumeFile(const fs::path& path) {
  return volumeFormatOf(path) != nullptr;
}

VolumeFile readVolumeFile(const fs::path& path, const VolumeFileOptions& options, const Progress& progress) {
  checkVolumePath(path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    refuseMixedFormats(path);
    const std::vector<fs::path> files = volumeFilesIn(path);
    if (!files.empty()) {
      return readNumbered(files, options, progress);
    }
  }
  return readOne(path, options, progress);
}

}  // namespace ocelli
