// For tests: reads the pixels of a picture.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <string>

namespace isobench {

struct Colour {
  int red = 0;
  int green = 0;
  int blue = 0;
};

// A picture's pixels, counted from the lower left corner.
class Pixels {
 public:
  explicit Pixels(const std::string& png) : bytes_(png) {
    reader_->SetMemoryBuffer(bytes_.data());
    reader_->SetMemoryBufferLength(static_cast<vtkIdType>(bytes_.size()));
    reader_->Update();
    reader_->GetOutput()->GetDimensions(size_);
  }
  int width() const { return size_[0]; }
  int height() const { return size_[1]; }
  Colour at(int x, int y) const {
    const auto* pixel = static_cast<unsigned char*>(reader_->GetOutput()->GetScalarPointer(x, y, 0));
    return {pixel[0], pixel[1], pixel[2]};
  }
  // The number of pixels left of the colour bar that pass the test.
  template <class Test>
  int count(Test&& passes) const {
    int count = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < 8 * width() / 10; ++x) count += passes(at(x, y)) ? 1 : 0;
    }
    return count;
  }

 private:
  std::string bytes_;
  vtkNew<vtkPNGReader> reader_;
  int size_[3] = {0, 0, 0};
};

inline bool is_white(const Colour& c) { return c.red > 250 && c.green > 250 && c.blue > 250; }
inline bool is_red(const Colour& c) { return c.red > 180 && c.green < 90 && c.blue < 90; }
inline bool is_dark(const Colour& c) { return c.red < 60 && c.green < 60 && c.blue < 60; }

}  // namespace isobench
