#include "isobench/datasets/formats/vtk/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <mutex>

namespace isobench {

namespace {

thread_local std::string first_error_of_this_thread;
thread_local bool failed_on_this_thread = false;

// "ERROR: In file.cxx, line 12\nvtkReader (0x55…): What happened.\n\n" → "What happened."
std::string without_prefix(const std::string& text) {
  const std::size_t object = text.find("): ");
  std::string message = object == std::string::npos ? text : text.substr(object + 3);
  std::replace(message.begin(), message.end(), '\n', ' ');
  const std::size_t last = message.find_last_not_of(" .");
  return last == std::string::npos ? "" : message.substr(0, last + 1);
}

// VTK's class and its factory macro have names of another style.
class QuietWindow : public vtkOutputWindow {  // NOLINT(readability-identifier-naming)
 public:
  static QuietWindow* New();  // NOLINT(readability-identifier-naming)
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    if (!failed_on_this_thread) first_error_of_this_thread = without_prefix(text);
    failed_on_this_thread = true;
  }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(QuietWindow);

}  // namespace

VtkMessages::VtkMessages() {
  static std::once_flag once;
  std::call_once(once, [] {
    vtkOutputWindow::SetInstance(vtkNew<QuietWindow>());
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  });
  failed_on_this_thread = false;
  first_error_of_this_thread.clear();
}

VtkMessages::~VtkMessages() { failed_on_this_thread = false; }

bool VtkMessages::failed() const { return failed_on_this_thread; }

std::string VtkMessages::first_error() const { return first_error_of_this_thread; }

}  // namespace isobench
