// Chromium without a window, for tests. It is controlled by chromedriver over HTTP, with the WebDriver protocol of W3C.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "isobench/foundation/processes/child_process.h"

namespace isobench {

class Browser {
 public:
  /// Why this machine cannot run the browser; "" if it can.
  static std::string missing();

  /// Starts driver and browser, which keep their files in `folder`. Throws std::runtime_error if they are not ready
  /// within a minute.
  explicit Browser(const std::filesystem::path& folder);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// From now on the browser does not run the scripts of pages.
  void forbid_scripts();
  void open(const std::filesystem::path& page);
  /// Calls a function with this body in the page and gives what it returns.
  nlohmann::json ask(const std::string& body);
  /// Repeats ask() until the answer is true; gives false after a minute.
  bool eventually(const std::string& body);

  // What a person does, on the first element that the CSS selector matches.
  void click(const std::string& selector);
  void drag(const std::string& selector, int right, int down);
  void turn_wheel(const std::string& selector, int down);
  void type(const std::string& selector, const std::string& keys);
  /// The element as PNG.
  std::string picture(const std::string& selector);

  /// The warnings and errors of the console so far, one line each.
  std::vector<std::string> complaints();
  /// The addresses that were requested so far, except file: and data:.
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
