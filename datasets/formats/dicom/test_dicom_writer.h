// For tests: DICOM files, written by GDCM's own writer.
#pragma once

#include <fmt/format.h>
#include <gdcmDataElement.h>
#include <gdcmFile.h>
#include <gdcmImage.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmItem.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "isobench/datasets/formats/testing/oblique_files.h"

namespace isobench {

/// A list of elements, which can become an item of a sequence.
class DicomTestItem {
 public:
  /// Puts text, or numbers written as text; replaces what was there. An even number of bytes is made.
  DicomTestItem& text(std::uint16_t group, std::uint16_t element, gdcm::VR::VRType type, std::string value) {
    if (value.size() % 2 == 1) value += type == gdcm::VR::UI ? '\0' : ' ';
    return bytes(group, element, type, value);
  }
  DicomTestItem& number(std::uint16_t group, std::uint16_t element, std::uint16_t value) {
    return bytes(group, element, gdcm::VR::US, bytes_of_value(value));
  }
  DicomTestItem& bytes(std::uint16_t group, std::uint16_t element, gdcm::VR::VRType type, const std::string& value) {
    gdcm::DataElement data(gdcm::Tag(group, element));
    data.SetVR(type);
    data.SetByteValue(value.data(), gdcm::VL(static_cast<std::uint32_t>(value.size())));
    set_.Replace(data);
    return *this;
  }
  DicomTestItem& sequence(std::uint16_t group, std::uint16_t element, const std::vector<DicomTestItem>& items) {
    const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = new gdcm::SequenceOfItems;
    for (const DicomTestItem& each : items) {
      gdcm::Item item;
      item.SetVLToUndefined();
      item.SetNestedDataSet(each.set_);
      sequence->AddItem(item);
    }
    sequence->SetLengthToUndefined();
    gdcm::DataElement data(gdcm::Tag(group, element));
    data.SetVR(gdcm::VR::SQ);
    data.SetValue(*sequence);
    data.SetVLToUndefined();
    set_.Replace(data);
    return *this;
  }
  DicomTestItem& without(std::uint16_t group, std::uint16_t element) {
    set_.Remove(gdcm::Tag(group, element));
    return *this;
  }
  gdcm::DataSet& set() { return set_; }

 private:
  gdcm::DataSet set_;
};

inline std::string dicom_text(const Eigen::Vector3d& v) {
  return fmt::format("{:.9g}\\{:.9g}\\{:.9g}", v[0], v[1], v[2]);
}

/// One DICOM file: a slice of the volume of oblique_files.h, unless it is changed.
struct DicomTestFile {
  DicomTestItem data;
  std::string pixels;  ///< as the layout says
  unsigned frames = 1;
  unsigned columns = nx;
  unsigned rows = ny;
  gdcm::TransferSyntax::TSType syntax = gdcm::TransferSyntax::ExplicitVRLittleEndian;
  gdcm::PixelFormat format{1, 16, 12, 11, 0};

  /// Writes it, compressed where the syntax says so.
  std::filesystem::path write(const std::filesystem::path& path) const {
    DicomTestFile copy = *this;
    copy.put_layout();
    const gdcm::SmartPointer<gdcm::File> file = copy.file_of();
    gdcm::Writer writer;
    writer.SetFile(*file);
    std::filesystem::create_directories(path.parent_path());
    writer.SetFileName(path.c_str());
    if (!writer.Write()) throw std::runtime_error("GDCM cannot write " + path.string());
    return path;
  }

 private:
  void put_layout() {
    data.number(0x0028, 0x0002, format.GetSamplesPerPixel());
    data.number(0x0028, 0x0100, format.GetBitsAllocated());
    data.number(0x0028, 0x0101, format.GetBitsStored());
    data.number(0x0028, 0x0102, format.GetHighBit());
    data.number(0x0028, 0x0103, format.GetPixelRepresentation());
    if (columns != nx) data.number(0x0028, 0x0010, static_cast<std::uint16_t>(rows));
    if (columns != nx) data.number(0x0028, 0x0011, static_cast<std::uint16_t>(columns));
    if (frames > 1) data.text(0x0028, 0x0008, gdcm::VR::IS, std::to_string(frames));
  }

  gdcm::SmartPointer<gdcm::File> file_of() {
    gdcm::Trace::WarningOff();
    gdcm::SmartPointer<gdcm::File> file = new gdcm::File;
    gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
    element.SetVR(format.GetBitsAllocated() > 8 ? gdcm::VR::OW : gdcm::VR::OB);
    element.SetByteValue(pixels.data(), gdcm::VL(static_cast<std::uint32_t>(pixels.size())));
    const gdcm::TransferSyntax transfer(syntax);
    data.set().Replace(transfer.IsEncapsulated() ? compressed(element) : element);
    file->GetHeader().SetDataSetTransferSyntax(syntax);
    file->SetDataSet(data.set());
    return file;
  }

  gdcm::DataElement compressed(const gdcm::DataElement& element) const {
    const gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image;  // the filter shares it
    image->SetNumberOfDimensions(frames > 1 ? 3 : 2);
    image->SetDimension(0, columns);
    image->SetDimension(1, rows);
    if (frames > 1) image->SetDimension(2, frames);
    image->SetPixelFormat(format);
    image->SetPhotometricInterpretation(format.GetSamplesPerPixel() == 3
                                            ? gdcm::PhotometricInterpretation::RGB
                                            : gdcm::PhotometricInterpretation::MONOCHROME2);
    image->SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
    image->SetDataElement(element);
    gdcm::ImageChangeTransferSyntax change;
    change.SetTransferSyntax(syntax);
    change.SetInput(*image);
    if (!change.Change()) throw std::runtime_error("GDCM cannot compress");
    return change.GetOutput().GetDataElement();
  }
};

/// The stored samples of slice k.
template <class Sample = std::uint16_t>
std::string dicom_pixels(int k, double offset = 0.0) {
  std::string bytes;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i)
      bytes += bytes_of_value(static_cast<Sample>(static_cast<double>(sample_at(i, j, k)) + offset));
  }
  return bytes;
}

inline DicomTestFile dicom_slice(int k, const std::string& series = "1.2.3.4") {
  DicomTestFile file;
  DicomTestItem& data = file.data;
  data.text(0x0008, 0x0008, gdcm::VR::CS, "ORIGINAL\\PRIMARY\\AXIAL");
  data.text(0x0008, 0x0016, gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2");
  data.text(0x0008, 0x0018, gdcm::VR::UI, fmt::format("{}.{}", series, k + 1));
  data.text(0x0008, 0x0060, gdcm::VR::CS, "CT");
  data.text(0x0008, 0x103E, gdcm::VR::LO, "Thorax thin");
  data.text(0x0020, 0x000E, gdcm::VR::UI, series);
  data.text(0x0020, 0x0011, gdcm::VR::IS, "7");
  data.text(0x0020, 0x0013, gdcm::VR::IS, std::to_string(100 - k));
  data.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(world_of(0, 0, k)));
  data.text(0x0020, 0x0037, gdcm::VR::DS, dicom_text(oblique().col(0)) + "\\" + dicom_text(oblique().col(1)));
  data.text(0x0028, 0x0004, gdcm::VR::CS, "MONOCHROME2");
  data.number(0x0028, 0x0010, ny);
  data.number(0x0028, 0x0011, nx);
  data.text(0x0028, 0x0030, gdcm::VR::DS, fmt::format("{}\\{}", spacing[1], spacing[0]));
  file.pixels = dicom_pixels(k);
  return file;
}

}  // namespace isobench
