#include "oc_core/volume/import/dicom_slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {
namespace {

/// Positions are decimal numbers, which scanners round to hundredths of a mm or so. A slice that is so far, as a share
/// of the distance of slices, from where it should be, would not be seen; one that is missing is twenty times as far.
constexpr double kMaxMisplaced = 0.05;
/// Directions of length 1 and spacings are decimal numbers of six digits or so. Directions of two slices may differ by
/// this length, an angle of 0.006 degrees, and spacings by this share: at the far end of 512 pixels that is a twentieth
/// of a pixel, as kMaxMisplaced is of the distance of slices.
constexpr double kMaxSliceTurn = 1e-4;
constexpr double kMaxSpacingShare = 1e-4;

std::string describe(const std::string& uid, const std::vector<const DicomSlice*>& slices) {
  const DicomSlice& first = *slices.front();
  std::string text =
      fmt::format("series {}: {} slices of {} x {}", first.seriesNumber.empty() ? "?" : first.seriesNumber,
                  slices.size(), first.columns, first.rows);
  if (!first.seriesDescription.empty()) {
    text += fmt::format(", \"{}\"", first.seriesDescription);
  }
  return text + ", UID " + uid;
}

[[noreturn]] void failSlice(const std::string& what, const DicomSlice& slice, const std::string& next) {
  throw InputError(what, slice.file.string(), next);
}

void checkAlike(const std::vector<DicomSlice>& slices) {
  const DicomSlice& first = slices.front();
  const std::string name = first.file.filename().string();
  for (const DicomSlice& slice : slices) {
    if (slice.columns != first.columns || slice.rows != first.rows) {
      failSlice(fmt::format("this slice has {} x {} pixels, and {} has {} x {}", slice.columns, slice.rows, name,
                            first.columns, first.rows),
                slice, "remove the slices of another kind, such as scouts, from the folder");
    }
    if (glm::distance(slice.alongColumns, first.alongColumns) > kMaxSliceTurn ||
        glm::distance(slice.alongRows, first.alongRows) > kMaxSliceTurn) {
      failSlice(fmt::format("this slice is turned against {}", name), slice,
                "remove the slices of another kind, such as scouts, from the folder");
    }
    const double spacingOff = std::max(std::abs(slice.columnSpacing / first.columnSpacing - 1),
                                       std::abs(slice.rowSpacing / first.rowSpacing - 1));
    if (spacingOff > kMaxSpacingShare) {
      failSlice(fmt::format("the pixels of this slice are not as far apart as those of {}", name), slice,
                "remove the slices of another kind from the folder");
    }
  }
}

double heightOf(const DicomSlice& slice, const glm::dvec3& normal) {
  return glm::dot(slice.position, normal);
}

/// The distance that most neighbours have: the middle of all.
double usualStep(const std::vector<DicomSlice>& slices, const glm::dvec3& normal) {
  std::vector<double> steps;
  for (size_t at = 1; at < slices.size(); ++at) {
    steps.push_back(heightOf(slices[at], normal) - heightOf(slices[at - 1], normal));
  }
  const auto middle = steps.begin() + static_cast<ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

void checkSteps(const std::vector<DicomSlice>& slices, const glm::dvec3& normal, const std::string& where) {
  const double usual = usualStep(slices, normal);
  for (size_t at = 1; at < slices.size(); ++at) {
    const double step = heightOf(slices[at], normal) - heightOf(slices[at - 1], normal);
    const std::string before = slices[at - 1].file.filename().string();
    const std::string after = slices[at].file.filename().string();
    if (step <= kMaxMisplaced * usual || step <= 0) {
      throw InputError(fmt::format("the slices {} and {} stand in one place, at {:g} mm along their normal", before,
                                   after, heightOf(slices[at], normal)),
                       where, "give a folder with one time, one echo and one reconstruction of the volume");
    }
    if (const double count = step / usual;
        count > 2 - 2 * kMaxMisplaced && std::abs(count - std::round(count)) < 2 * kMaxMisplaced) {
      throw InputError(
          fmt::format("{:.0f} slice{} missing between {} and {}, which are {:g} mm apart, not {:g} mm",
                      std::round(count) - 1, std::round(count) == 2 ? " is" : "s are", before, after, step, usual),
          where, "copy or export the folder again, with all slices");
    }
    if (std::abs(step / usual - 1) > 2 * kMaxMisplaced) {
      throw InputError(
          fmt::format("the slices {} and {} are {:g} mm apart, and most others {:g} mm", before, after, step, usual),
          where, "resample the volume to equal distances, or remove the slices of the other distance");
    }
  }
}

}  // namespace

std::vector<DicomSlice> chooseSeries(const std::vector<DicomSlice>& slices, const std::string& series,
                                     const std::string& where) {
  std::map<std::string, std::vector<const DicomSlice*>> all;
  for (const DicomSlice& slice : slices) {
    all[slice.seriesUid].push_back(&slice);
  }
  const auto isPlaced = [](const std::vector<const DicomSlice*>& members) {
    return std::any_of(members.begin(), members.end(),
                       [](const DicomSlice* slice) { return slice->unplaced.empty() || !slice->malformed.empty(); });
  };
  // A report may have the number of the slices that it tells of.
  const auto isNamed = [&](const std::vector<const DicomSlice*>& members) {
    return series.empty() || series == members.front()->seriesNumber;
  };
  const bool isAnyPlaced =
      std::any_of(all.begin(), all.end(), [&](const auto& one) { return isNamed(one.second) && isPlaced(one.second); });
  std::vector<const std::vector<const DicomSlice*>*> chosen;
  std::string list;
  for (const auto& [uid, members] : all) {
    list += (list.empty() ? "" : "\n") + describe(uid, members);
    if ((!series.empty() && series == uid) || (isNamed(members) && (isPlaced(members) || !isAnyPlaced))) {
      chosen.push_back(&members);
    }
  }
  if (chosen.size() != 1) {
    throw InputError(chosen.empty() ? fmt::format("there is no series \"{}\" among the {} here", series, all.size())
                                    : fmt::format("there are {} series of slices", chosen.size()),
                     where, "choose one with --series NUMBER or --series UID, or give a folder with one", list);
  }
  std::vector<DicomSlice> one;
  for (const DicomSlice* slice : *chosen.front()) {
    if (!slice->malformed.empty()) {
      failSlice(slice->malformed, *slice, "export this file again, or correct it");
    }
    if (!slice->unplaced.empty()) {
      failSlice(slice->unplaced, *slice, "remove it from the folder, if it is no slice of the volume");
    }
    one.push_back(*slice);
  }
  return one;
}

std::vector<DicomMoment> momentsOf(const std::vector<DicomSlice>& slices) {
  const auto isElsewhere = [&](const DicomSlice& slice) {
    return std::none_of(slices.begin(), slices.end(),
                        [&](const DicomSlice& other) { return &other != &slice && other.position == slice.position; });
  };
  for (const auto time : {&DicomSlice::triggerSeconds, &DicomSlice::temporalPosition}) {
    // That of one slice is enough to see: where it stands alone, there is but one time.
    if (slices.empty() || isElsewhere(slices.front())) {
      break;
    }
    std::map<double, std::vector<DicomSlice>> byTime;
    bool isTold = true;
    for (const DicomSlice& slice : slices) {
      isTold = isTold && (slice.*time).has_value();
      if (isTold) {
        byTime[*(slice.*time)].push_back(slice);
      }
    }
    const bool isEven =
        isTold && byTime.size() > 1 && std::all_of(byTime.begin(), byTime.end(), [&](const auto& moment) {
          return moment.second.size() == byTime.begin()->second.size();
        });
    if (isEven) {
      std::vector<DicomMoment> moments;
      for (auto& [seconds, members] : byTime) {
        moments.push_back({std::move(members), seconds, time == &DicomSlice::temporalPosition});
      }
      return moments;
    }
  }
  return {{slices, 0}};
}

std::optional<std::string> missingSlices(const std::vector<DicomMoment>& moments) {
  for (const DicomMoment& moment : moments) {
    for (const DicomSlice& slice : moment.slices) {
      if (slice.slicesOfTime && *slice.slicesOfTime > static_cast<double>(moment.slices.size())) {
        return fmt::format(
            "the files say that a volume has {:.0f} slices (NumberOfSlices), and there are {}: some may be missing at "
            "an end",
            *slice.slicesOfTime, moment.slices.size());
      }
    }
  }
  struct Acquisition {
    size_t images = 0;
    double told = 0;
  };
  std::map<std::string, Acquisition> acquisitions;
  for (const DicomMoment& moment : moments) {
    for (const DicomSlice& slice : moment.slices) {
      Acquisition& acquisition = acquisitions[slice.acquisitionNumber];
      ++acquisition.images;
      acquisition.told = std::max(acquisition.told, slice.imagesInAcquisition.value_or(0));
    }
  }
  for (const auto& [number, acquisition] : acquisitions) {
    if (acquisition.told > static_cast<double>(acquisition.images)) {
      return fmt::format(
          "the files say that their acquisition gave {:.0f} images (ImagesInAcquisition), and this series has {} of "
          "them: some may be missing at an end",
          acquisition.told, acquisition.images);
    }
  }
  return std::nullopt;
}

void arrangeSlices(std::vector<DicomSlice>& slices, VolumeRecord& record, const std::string& where) {
  checkAlike(slices);
  const glm::dvec3 normal = glm::normalize(glm::cross(slices.front().alongColumns, slices.front().alongRows));
  std::stable_sort(slices.begin(), slices.end(),
                   [&](const DicomSlice& a, const DicomSlice& b) { return heightOf(a, normal) < heightOf(b, normal); });
  if (slices.size() < 2) {
    throw InputError("there is but one slice", where, "give a folder with all slices of a volume");
  }
  checkSteps(slices, normal, where);
  const DicomSlice& first = slices.front();
  const auto last = static_cast<double>(slices.size() - 1);
  // Where the gantry was tilted, this is not along the normal.
  const glm::dvec3 step = (slices.back().position - first.position) / last;
  for (size_t at = 0; at < slices.size(); ++at) {
    const glm::dvec3 expected = first.position + static_cast<double>(at) * step;
    if (glm::distance(slices[at].position, expected) > kMaxMisplaced * glm::length(step) + 1e-9) {
      failSlice(fmt::format("this slice is {:g} mm from where a volume of slices {:g} mm apart would have it",
                            glm::distance(slices[at].position, expected), glm::length(step)),
                slices[at], "resample the volume to equal distances, or remove the slices of another kind");
    }
  }
  checkVolumeSize({first.columns, first.rows, slices.size()}, 1, where);
  VolumeGrid& grid = record.grid;
  grid.size = {first.columns, first.rows, static_cast<int>(slices.size())};
  grid.worldFromIndex =
      glm::dmat4(glm::dvec4(first.alongColumns * first.columnSpacing, 0),
                 glm::dvec4(first.alongRows * first.rowSpacing, 0), glm::dvec4(step, 0), glm::dvec4(first.position, 1));
  grid.unit = "mm";
  grid.isAnatomical = true;
  record.facts = {first.modality, first.valueUnit, "DICOM"};
}

}  // namespace ocelli
