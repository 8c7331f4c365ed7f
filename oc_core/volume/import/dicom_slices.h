// Slices of a volume in DICOM files: what they say of themselves, which of them make one volume, and its grid. Their
// frame is LPS, in mm.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/volume/volume_record.h"

namespace ocelli {

/// An image of a file: a file may have several frames.
struct DicomSlice {
  std::filesystem::path file;
  unsigned frame = 0;  ///< of the file
  std::string seriesUid;
  std::string seriesNumber;
  std::string seriesDescription;
  std::string modality;
  std::string valueUnit;
  int columns = 0;
  int rows = 0;
  glm::dvec3 position{0};      ///< of the centre of its first pixel
  glm::dvec3 alongColumns{0};  ///< from a pixel to the next one of its row, of length 1
  glm::dvec3 alongRows{0};     ///< from a row to the next
  double columnSpacing = 1;
  double rowSpacing = 1;
  double slope = 1;  ///< of what a pixel means
  double intercept = 0;
  std::optional<double> triggerSeconds{};    ///< since the trigger of a series of times
  std::optional<double> temporalPosition{};  ///< the number of the time among them
  std::string acquisitionNumber{};
  std::optional<double> imagesInAcquisition{};  ///< how many images its acquisition gave, as the file says
  std::optional<double> slicesOfTime{};         ///< how many slices a volume of one time has, as the file says
  std::string unplaced{};                       ///< why it lies nowhere in the patient; empty where it does
  std::string malformed{};                      ///< what is no number where one must be; empty where all are
};

/// The slices of one time.
struct DicomMoment {
  std::vector<DicomSlice> slices;
  double seconds = 0;
  bool isNumbered = false;  ///< `seconds` is the number of the time, and nothing says how long they are apart
};

/// The slices of one series: the one that `series` names by its UID or its number; where it is empty, the only one. Of
/// those of one number, or of all, the ones without images that lie somewhere in the patient do not count beside
/// others: reports and copies of the screen do not lie there. Throws InputError that lists the series where it names
/// none, or where there are several and it is empty; and for an image of the chosen one that is unplaced or malformed.
std::vector<DicomSlice> chooseSeries(const std::vector<DicomSlice>& slices, const std::string& series,
                                     const std::string& where);

/// Slices of a volume at several times, by their trigger times or else by the numbers of their times, which count as
/// seconds; one moment, where no two slices lie in one place, or nothing tells them apart.
std::vector<DicomMoment> momentsOf(const std::vector<DicomSlice>& slices);

/// A warning where the files tell of more images than there are, and none otherwise: slices that are missing at an end
/// of a volume leave no gap between others.
std::optional<std::string> missingSlices(const std::vector<DicomMoment>& moments);

/// Sorts the slices along their normal, the way it points, and sets the grid and the facts of the record. Throws
/// InputError where they make no volume: sizes or orientations differ, slices are missing, stand in one place, or are
/// unequally far apart.
void arrangeSlices(std::vector<DicomSlice>& slices, VolumeRecord& record, const std::string& where);

}  // namespace ocelli
