#include "isobench/datasets/manifests/fetch.h"

#include <curl/curl.h>
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

int on_progress(void* monitor, curl_off_t total, curl_off_t now, curl_off_t, curl_off_t) {
  try {
    if (total > 0)
      static_cast<Monitor*>(monitor)->progress(static_cast<double>(now) / static_cast<double>(total));
    else
      static_cast<Monitor*>(monitor)->check();
  } catch (const Cancelled&) {
    return 1;  // stops the transfer; no exception may pass through libcurl, so the caller checks again
  }
  return 0;
}

void start_curl() {
  static const CURLcode code = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (code != CURLE_OK) throw DataError("libcurl cannot be started; reinstall it");
}

std::string download(const std::string& address, std::FILE* out, Monitor& monitor) {
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl(curl_easy_init(), curl_easy_cleanup);
  if (!curl) return "libcurl cannot be started";
  char message[CURL_ERROR_SIZE] = "";
  curl_easy_setopt(curl.get(), CURLOPT_URL, address.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, out);
  curl_easy_setopt(curl.get(), CURLOPT_ERRORBUFFER, message);
  curl_easy_setopt(curl.get(), CURLOPT_FAILONERROR, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_PROTOCOLS_STR, "https,http,file");
  curl_easy_setopt(curl.get(), CURLOPT_REDIR_PROTOCOLS_STR, "https,http");
  curl_easy_setopt(curl.get(), CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_CONNECTTIMEOUT, 20L);
  // Gives up a transfer that stays below 100 bytes a second for a minute.
  curl_easy_setopt(curl.get(), CURLOPT_LOW_SPEED_LIMIT, 100L);
  curl_easy_setopt(curl.get(), CURLOPT_LOW_SPEED_TIME, 60L);
  curl_easy_setopt(curl.get(), CURLOPT_XFERINFOFUNCTION, on_progress);
  curl_easy_setopt(curl.get(), CURLOPT_XFERINFODATA, &monitor);
  curl_easy_setopt(curl.get(), CURLOPT_NOPROGRESS, 0L);
  const CURLcode code = curl_easy_perform(curl.get());
  if (code == CURLE_OK) return "";
  return message[0] != '\0' ? message : curl_easy_strerror(code);
}

}  // namespace

void fetch_from_address(const ManifestFile& file, const std::filesystem::path& folder, Monitor& monitor) {
  start_curl();
  PartialFile part(folder / file.name);
  std::FILE* out = std::fopen(part.path().c_str(), "wb");
  if (out == nullptr)
    throw DataError(folder.string() +
                    ": the cache cannot be written; set ISOBENCH_CACHE to a folder that can be written");
  const std::string problem = download(file.address, out, monitor);
  const bool written = std::fclose(out) == 0;
  monitor.check();
  if (!problem.empty() || !written) {
    throw DataError(fmt::format(
        "{} cannot be fetched from {} ({}); connect to the network, or set ISOBENCH_DATA to a folder that has {}",
        file.name, file.address, problem.empty() ? "the disk is full" : problem,
        (folder.filename() / file.name).string()));
  }
  const std::string sum = sha256_of_file(part.path());
  if (sum != file.sha256) {
    throw DataError(fmt::format(
        "{}: its SHA-256 is {}, but {} is expected; its publisher has changed it, so set ISOBENCH_DATA to a folder "
        "that has the original {}",
        file.address, sum, file.sha256, (folder.filename() / file.name).string()));
  }
  part.complete();
}

}  // namespace isobench
