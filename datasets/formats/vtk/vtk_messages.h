// VTK prints its errors and carries on. This class catches them, so that the caller can throw an error with VTK's
// cause.
#pragma once

#include <string>

namespace isobench {

/// While an object of this class exists, VTK's messages on this thread are collected instead of printed; those on other
/// threads are dropped. The first object switches VTK's printing off for the rest of the program.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// True if VTK reported an error; warnings do not count.
  bool failed() const;
  /// The first error in VTK's words, on one line; "" if there was none.
  std::string first_error() const;
};

}  // namespace isobench
