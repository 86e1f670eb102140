// Errors that a user can act on: one or two sentences that name the place and the remedy.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace isobench {

/// A place in a text file. Lines and columns count from 1; 0 means unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column: " without the parts that are unknown; "" without a file.
std::string to_string(const Place& place);

/// The text in a form that is safe in a terminal, a table and JSON: control characters and bytes that are not UTF-8
/// become \xNN. A text longer than 1000 bytes loses its middle.
std::string printable(const std::string& text);

/// Base of all errors that the user sees. what() is the whole message, made printable() because it may quote files.
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

/// A method cannot do a task by its nature. what() is the reason; the cell becomes `skipped`.
class Skipped : public Error {
 public:
  using Error::Error;
};

/// The user or a limit asked a computation to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

/// The candidate with the smallest edit distance to `name`; "" if none is near enough to be meant.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" or, if no candidate is near, "; known are: a, b, c".
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace isobench
