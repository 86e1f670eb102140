#include "isobench/reports/page/test_browser.h"

#include <curl/curl.h>
#include <openssl/evp.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "isobench/foundation/files/whole_files.h"

namespace isobench {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// The key of an element in the JSON of the protocol.
constexpr const char* element_key = "element-6066-11e4-a52e-4f735466cecf";
constexpr int patience = 60;  // seconds; a busy machine starts a browser slowly

std::size_t take(char* data, std::size_t size, std::size_t count, void* text) {
  static_cast<std::string*>(text)->append(data, size * count);
  return size * count;
}

std::string request(const std::string& method, const std::string& address, const std::string& body) {
  const std::unique_ptr<CURL, void (*)(CURL*)> curl(curl_easy_init(), curl_easy_cleanup);
  const std::unique_ptr<curl_slist, void (*)(curl_slist*)> head(
      curl_slist_append(nullptr, "Content-Type: application/json"), curl_slist_free_all);
  std::string answer;
  curl_easy_setopt(curl.get(), CURLOPT_URL, address.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_CUSTOMREQUEST, method.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_HTTPHEADER, head.get());
  if (method == "POST") curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDS, body.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_NOPROXY, "*");
  curl_easy_setopt(curl.get(), CURLOPT_TIMEOUT, 2L * patience);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, take);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &answer);
  const CURLcode code = curl_easy_perform(curl.get());
  if (code != CURLE_OK) throw std::runtime_error(address + ": " + curl_easy_strerror(code));
  return answer;
}

// The driver chooses a port and prints it.
int announced_port(const fs::path& log) {
  for (int tries = 0; tries < 10 * patience; ++tries) {
    const std::string text = read_text_or_empty(log);
    const std::string words = "started successfully on port ";
    const std::size_t at = text.find(words);
    if (at != std::string::npos) return std::stoi(text.substr(at + words.size()));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  throw std::runtime_error("chromedriver did not start; its log is " + log.string());
}

std::string decoded(const std::string& base64) {
  std::string bytes(base64.size() / 4 * 3, '\0');
  EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()), reinterpret_cast<const unsigned char*>(base64.data()),
                  static_cast<int>(base64.size()));
  return bytes;
}

}  // namespace

std::string Browser::missing() {
  for (const char* program : {"chromium", "chromedriver"}) {
    if (!has_program(program))
      return std::string(program) + " is not installed (packages chromium and chromium-driver)";
  }
  return "";
}

Browser::Browser(const fs::path& folder)
    : driver_({.words = {"chromedriver", "--port=0"},
               .out = {ChildOutput::To::new_file, folder / "driver.txt"},
               .own_group = true}) {
  port_ = announced_port(folder / "driver.txt");
  const Json arguments = {"--headless",
                          "--no-sandbox",
                          "--disable-gpu",
                          "--enable-unsafe-swiftshader",  // WebGL on the processor
                          "--disable-dev-shm-usage",
                          "--disable-quic",
                          "--no-first-run",
                          "--disable-background-networking",
                          "--disable-component-update",
                          "--disable-sync",
                          "--window-size=1280,1000",
                          "--user-data-dir=" + (folder / "browser").string()};
  const Json wanted = {{"browserName", "chrome"},
                       {"goog:chromeOptions", {{"args", arguments}, {"binary", "/usr/bin/chromium"}}},
                       {"goog:loggingPrefs", {{"browser", "ALL"}, {"performance", "ALL"}}}};
  session_ = call("POST", "/session", {{"capabilities", {{"alwaysMatch", wanted}}}}).at("sessionId").get<std::string>();
}

Browser::~Browser() {
  try {
    if (!session_.empty()) call("DELETE", "/session/" + session_, Json::object());
  } catch (const std::exception&) {  // the driver ends with driver_ in any case
  }
}

Json Browser::call(const std::string& method, const std::string& path, const Json& body) {
  const std::string address = "http://127.0.0.1:" + std::to_string(port_) + path;
  Json answer = Json::parse(request(method, address, body.dump())).at("value");
  if (answer.is_object() && answer.contains("error"))
    throw std::runtime_error(path + ": " + answer.value("message", "an error"));
  return answer;
}

Json Browser::session(const std::string& path, const Json& body) {
  return call("POST", "/session/" + session_ + path, body);
}

void Browser::forbid_scripts() {
  session("/goog/cdp/execute", {{"cmd", "Emulation.setScriptExecutionDisabled"}, {"params", {{"value", true}}}});
}

void Browser::open(const fs::path& page) { session("/url", {{"url", "file://" + page.string()}}); }

Json Browser::ask(const std::string& body) {
  return session("/execute/sync", {{"script", body}, {"args", Json::array()}});
}

bool Browser::eventually(const std::string& body) {
  for (int tries = 0; tries < 10 * patience; ++tries) {
    if (ask(body) == true) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

std::string Browser::element(const std::string& selector) {
  return session("/element", {{"using", "css selector"}, {"value", selector}}).at(element_key).get<std::string>();
}

void Browser::click(const std::string& selector) {
  session("/element/" + element(selector) + "/click", Json::object());
}

void Browser::act(const Json& actions) { session("/actions", {{"actions", Json::array({actions})}}); }

void Browser::drag(const std::string& selector, int right, int down) {
  const Json origin = {{element_key, element(selector)}};
  const auto move = [&origin](int x, int y) {
    return Json{{"type", "pointerMove"}, {"duration", 100}, {"origin", origin}, {"x", x}, {"y", y}};
  };
  const Json press = {{"type", "pointerDown"}, {"button", 0}};
  const Json release = {{"type", "pointerUp"}, {"button", 0}};
  act({{"type", "pointer"},
       {"id", "mouse"},
       {"actions", {move(0, 0), press, move(right / 2, down / 2), move(right, down), release}}});
}

void Browser::turn_wheel(const std::string& selector, int down) {
  const Json turn = {{"type", "scroll"}, {"origin", {{element_key, element(selector)}}},
                     {"x", 0},           {"y", 0},
                     {"deltaX", 0},      {"deltaY", down}};
  act({{"type", "wheel"}, {"id", "wheel"}, {"actions", {turn}}});
}

void Browser::type(const std::string& selector, const std::string& keys) {
  session("/element/" + element(selector) + "/value", {{"text", keys}});
}

std::string Browser::picture(const std::string& selector) {
  const std::string path = "/session/" + session_ + "/element/" + element(selector) + "/screenshot";
  return decoded(call("GET", path, Json::object()).get<std::string>());
}

Json Browser::log(const std::string& kind) { return session("/se/log", {{"type", kind}}); }

std::vector<std::string> Browser::complaints() {
  std::vector<std::string> lines;
  for (const Json& entry : log("browser")) {
    // Screenshots of the driver cause warnings of OpenGL about speed.
    if (entry.at("level") != "INFO" && entry.at("source") != "rendering")
      lines.push_back(entry.at("message").get<std::string>());
  }
  return lines;
}

std::vector<std::string> Browser::requests() {
  std::vector<std::string> addresses;
  for (const Json& entry : log("performance")) {
    const Json event = Json::parse(entry.at("message").get<std::string>()).at("message");
    if (event.at("method") != "Network.requestWillBeSent") continue;
    const std::string address = event.at("params").at("request").at("url").get<std::string>();
    // The browser opens with its own start page.
    const bool own = address.starts_with("file:") || address.starts_with("data:") || address.starts_with("chrome:");
    if (!own) addresses.push_back(address);
  }
  return addresses;
}

}  // namespace isobench
