// VTK prints what goes wrong and carries on; here its messages are caught so that they can become an error with a
// cause.
#pragma once

#include <string>

namespace isobench {

/// While one is alive, VTK's messages of this thread are collected instead of printed (and of other threads, dropped).
/// The first one switches VTK's own printing off for the rest of the program.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// True if an error, not a mere warning, was reported.
  bool failed() const;
  /// The first error in VTK's words, on one line; "" if there was none.
  std::string first_error() const;
};

}  // namespace isobench
