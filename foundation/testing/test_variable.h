// For tests: environment variables that get their old value back when the test ends.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace isobench {

/// Sets an environment variable until the end of the scope. Not for tests that run threads.
class TestVariable {
 public:
  TestVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~TestVariable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  TestVariable(const TestVariable&) = delete;
  TestVariable& operator=(const TestVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace isobench
