// Which of the DICOM images of a folder make one volume.
#pragma once

#include <string>
#include <vector>

#include "isobench/datasets/formats/dicom/dicom_image.h"

namespace isobench {

/// A slice: a frame of an image.
struct DicomSlice {
  const DicomImage* image = nullptr;
  const DicomFrame* frame = nullptr;
};

/// Slices of one series that have the same size, orientation, spacing and type of image. Localizers and derived images
/// that share a series with others are series of their own here.
struct DicomSeries {
  std::vector<DicomSlice> slices;

  const DicomImage& first() const { return *slices.front().image; }
};

/// The series of all images, by number, then by UID, then in the order of the images. The images must outlive them.
std::vector<DicomSeries> series_of(const std::vector<DicomImage>& images);

/// The series that `choice` means: "#2" for the second one, a series' number, its UID or how its description begins.
/// Without a choice it is the only one, or the one that holds a slice of `wanted`, if that is not empty. Throws
/// DataError that names `path` and lists what can be chosen.
const DicomSeries& choose_series(const std::vector<DicomSeries>& all, const std::string& choice,
                                 const std::filesystem::path& wanted, const std::filesystem::path& path);

}  // namespace isobench
