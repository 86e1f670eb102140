// NIfTI and VTI by VTK's readers. Direction cosines come beside vtkImageData for NIfTI, and both readers report
// problems by printing and then carry on: what they would print is caught here and becomes the error it is.
#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <mutex>

#include "datasets/error.h"
#include "datasets/readers.h"
#include "datasets/sample_data.h"

namespace isobench {

namespace {

/// Swallows what VTK would print and remembers whether an error was among it.
class CaughtOutput : public vtkOutputWindow {
 public:
  static CaughtOutput* New();
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { failed_ = true; }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  bool failed() const { return failed_; }

 private:
  bool failed_ = false;
};
CaughtOutput* CaughtOutput::New() { VTK_STANDARD_NEW_BODY(CaughtOutput); }

/// VTK's output is caught while this lives; one at a time, because VTK has one output for all threads.
class Quiet {
 public:
  Quiet()
      : lock_(mutex()), before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(output_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // it prints errors beside the output window
  }
  ~Quiet() {
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::SetInstance(before_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  bool failed() const { return output_->failed(); }

 private:
  static std::mutex& mutex() {
    static std::mutex the_mutex;
    return the_mutex;
  }
  std::scoped_lock<std::mutex> lock_;
  vtkNew<CaughtOutput> output_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
};

DataError damaged(const std::filesystem::path& path) {
  return DataError(path.string() + ": truncated or damaged; copy or export it again");
}

std::array<long long, 3> size_of(const int extent[6]) {
  std::array<long long, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<long long>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
  return size;
}

void copy_samples(vtkDataArray* array, double slope, double intercept, const std::filesystem::path& path,
                  Volume& volume) {
  if (array == nullptr)
    throw DataError(path.string() + ": it has no samples at its nodes; give a volume with point data");
  if (array->GetNumberOfComponents() != 1)
    throw DataError(path.string() + ": it has vectors for samples; give a scalar volume");
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) != volume.lattice.nodes()) throw damaged(path);
  volume.samples.resize(volume.lattice.nodes());
  for (std::size_t n = 0; n < volume.samples.size(); ++n) {
    const double sample = array->GetComponent(static_cast<vtkIdType>(n), 0);
    volume.samples[n] = static_cast<float>(slope * sample + intercept);
  }
}

/// The header must be of a 3-D scalar volume whose samples the file, inflated in full, really holds.
void check_nifti(vtkNIFTIImageReader* reader, const std::filesystem::path& path) {
  vtkNIFTIImageHeader* header = reader->GetNIFTIHeader();
  if (header == nullptr) throw damaged(path);
  for (int axis = 4; axis <= header->GetDim(0); ++axis) {
    if (header->GetDim(axis) > 1)
      throw DataError(path.string() + ": it has more than three dimensions; give one 3-D volume");
  }
  std::uintmax_t needed = static_cast<std::uintmax_t>(header->GetBitPix()) / 8;
  for (int axis = 1; axis <= 3; ++axis) {
    const auto size = static_cast<std::uintmax_t>(std::max<long long>(header->GetDim(axis), 1));
    if (needed > (std::uintmax_t{1} << 44U) / size) throw damaged(path);
    needed *= size;
  }
  const std::uintmax_t offset = header->GetVoxOffset() > 0 ? static_cast<std::uintmax_t>(header->GetVoxOffset()) : 0;
  const bool pair = header->GetMagic()[1] == 'i';  // "ni1": the samples are in another file, which VTK finds
  if (pair) return;
  ByteReader bytes(path, path.extension() == ".gz" ? Encoding::deflated : Encoding::plain);
  const std::uintmax_t present = bytes.encoding() == Encoding::plain ? bytes.possible_bytes() : bytes.drain();
  if (present < offset + needed) {
    throw DataError(fmt::format("{}: truncated: {} of {} bytes are there; copy or export it again", path.string(),
                                present, offset + needed));
  }
}

double nifti_unit_in_mm(vtkNIFTIImageHeader* header) {
  switch (header->GetXYZTUnits() & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 1e-3;
    default:
      return 1.0;
  }
}

Lattice nifti_lattice(vtkNIFTIImageReader* reader, vtkImageData* image, const std::filesystem::path& path) {
  vtkNIFTIImageHeader* header = reader->GetNIFTIHeader();
  const double unit = nifti_unit_in_mm(header);
  vtkMatrix4x4* matrix = header->GetSFormCode() > 0   ? reader->GetSFormMatrix()
                         : header->GetQFormCode() > 0 ? reader->GetQFormMatrix()
                                                      : nullptr;
  Eigen::Matrix3d steps = unit * Eigen::Vector3d(image->GetSpacing()).asDiagonal().toDenseMatrix();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (matrix != nullptr) {
    Eigen::Matrix3d rotation;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) rotation(row, column) = matrix->GetElement(row, column);
      origin[row] = unit * matrix->GetElement(row, 3);
    }
    steps =
        rotation * steps;  // VTK takes the voxel's size out of the matrix, except where the header contradicts itself
  }
  return make_lattice(path, size_of(image->GetExtent()), steps.colwise().norm(), steps, origin,
                      matrix != nullptr ? "RAS" : "");
}

}  // namespace

Volume read_nifti(const std::filesystem::path& path) {
  const Quiet quiet;
  vtkNew<vtkNIFTIImageReader> reader;
  if (reader->CanReadFile(path.c_str()) == 0) {
    throw DataError(path.string() + ": not a NIfTI file; give it the ending of its own format");
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (quiet.failed()) throw damaged(path);
  check_nifti(reader, path);
  reader->Update();
  if (quiet.failed() || reader->GetErrorCode() != 0) throw damaged(path);
  vtkImageData* image = reader->GetOutput();
  Volume volume;
  volume.lattice = nifti_lattice(reader, image, path);
  // VTK leaves the samples as stored; a slope of 0 means that none is given.
  const double slope = reader->GetRescaleSlope();
  const bool scaled = std::isfinite(slope) && slope != 0.0;
  copy_samples(image->GetPointData()->GetScalars(), scaled ? slope : 1.0, scaled ? reader->GetRescaleIntercept() : 0.0,
               path, volume);
  return volume;
}

Volume read_vti(const std::filesystem::path& path) {
  const Quiet quiet;
  vtkNew<vtkXMLImageDataReader> reader;
  if (reader->CanReadFile(path.c_str()) == 0) {
    throw DataError(path.string() + ": not a VTI file; give it the ending of its own format");
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (quiet.failed() || reader->GetErrorCode() != 0) throw damaged(path);
  int extent[6];
  reader->GetUpdateExtent(extent);
  // No compressor of VTK's shrinks ten thousandfold: a size beyond that is damage, and is not to be allocated.
  const auto size = size_of(extent);
  std::error_code error;
  const double possible = 1e4 * static_cast<double>(std::filesystem::file_size(path, error));
  if (static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(size[2]) > possible)
    throw damaged(path);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (quiet.failed() || reader->GetErrorCode() != 0 || image == nullptr) throw damaged(path);
  vtkPointData* data = image->GetPointData();
  vtkDataArray* array = data->GetScalars() != nullptr ? data->GetScalars() : data->GetArray(0);
  image->GetExtent(extent);
  Eigen::Matrix3d direction;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      direction(row, column) = image->GetDirectionMatrix()->GetElement(row, column);
  }
  const Eigen::Vector3d spacing(image->GetSpacing());
  // The extent need not start at 0.
  const Eigen::Vector3d first = spacing.cwiseProduct(Eigen::Vector3d(extent[0], extent[2], extent[4]));
  Volume volume;
  volume.lattice = make_lattice(path, size_of(extent), spacing, direction,
                                Eigen::Vector3d(image->GetOrigin()) + direction * first, "");
  copy_samples(array, 1.0, 0.0, path, volume);
  return volume;
}

}  // namespace isobench
