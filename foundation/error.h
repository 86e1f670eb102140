// Errors that a user can act on: one or two sentences that name the place and the remedy.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace isobench {

/// Where in a text file something was found; line and column count from 1, 0 means unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column: ", shortened where a part is unknown; empty without a file.
std::string to_string(const Place& place);

/// A text as a terminal, a table and JSON can take it: control characters and what is no UTF-8 as \xNN; of more than
/// 1000 bytes the middle is left out.
std::string printable(const std::string& text);

/// Base of everything the user is told about; what() is the whole message, made printable() because it quotes files.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(printable(message)) {}
};

/// A wrong command line, config or parameter: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
  UsageError(const Place& place, const std::string& message) : Error(to_string(place) + message) {}
};

/// Data that are missing, damaged or without a surface: exit code 3.
class DataError : public Error {
 public:
  using Error::Error;
};

/// A method that cannot do a task by its nature; what() is the reason, the cell becomes `skipped`.
class Skipped : public Error {
 public:
  using Error::Error;
};

/// The user or a limit asked a computation to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

/// The candidate nearest to `name` by edit distance, or "" if none is reasonably near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" or, where nothing is near, "; known are: a, b, c".
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace isobench
