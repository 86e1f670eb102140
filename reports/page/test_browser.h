// Chromium without a window, for tests: driven by its own driver, which speaks the W3C's WebDriver protocol over HTTP.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "isobench/foundation/processes/child_process.h"

namespace isobench {

class Browser {
 public:
  /// Why there can be none on this machine; "" where there can.
  static std::string missing();

  /// Starts driver and browser, whose files go to `folder`. Throws std::runtime_error where they do not come up within
  /// a minute.
  explicit Browser(const std::filesystem::path& folder);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// From now on pages run no scripts of their own.
  void forbid_scripts();
  void open(const std::filesystem::path& page);
  /// What a function of this body returns, called in the page.
  nlohmann::json ask(const std::string& body);
  /// The same until it returns true; false where it does not within a minute.
  bool eventually(const std::string& body);

  // As a person does it, on the first element that a CSS selector names.
  void click(const std::string& selector);
  void drag(const std::string& selector, int right, int down);
  void turn_wheel(const std::string& selector, int down);
  void type(const std::string& selector, const std::string& keys);
  /// A PNG of it.
  std::string picture(const std::string& selector);

  /// What the console complained about so far, a line each.
  std::vector<std::string> complaints();
  /// The addresses that were asked for so far, but for files and what pages hold themselves.
  std::vector<std::string> requests();

 private:
  nlohmann::json call(const std::string& method, const std::string& path, const nlohmann::json& body);
  nlohmann::json session(const std::string& path, const nlohmann::json& body);
  nlohmann::json log(const std::string& kind);
  std::string element(const std::string& selector);
  void act(const nlohmann::json& actions);

  ChildProcess driver_;
  int port_ = 0;
  std::string session_;
};

}  // namespace isobench
