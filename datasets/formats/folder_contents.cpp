#include "isobench/datasets/formats/folder_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "isobench/foundation/text.h"

namespace isobench {

bool is_flat_image(const std::filesystem::path& path) {
  static const std::array<std::string, 5> endings = {".png", ".jpg", ".jpeg", ".bmp", ".gif"};
  return std::find(endings.begin(), endings.end(), lower_case(path.extension().string())) != endings.end();
}

std::string text_of_contents(const std::filesystem::path& folder) {
  std::map<std::string, std::size_t> endings;
  std::size_t all = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    ++endings[entry->is_directory(error) ? "/" : lower_case(entry->path().extension().string())];
    ++all;
  }
  if (error) return "a folder that cannot be read";
  if (all == 0) return "an empty folder";
  const auto most = std::max_element(endings.begin(), endings.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto& [ending, count] = *most;
  const std::string plural = count == 1 ? "" : "s";
  std::string text = fmt::format("a folder of {} ", count);
  if (ending == "/")
    text += "folder" + plural;
  else if (ending.empty())
    text += fmt::format("file{} without ending", plural);
  else
    text += fmt::format("{} file{}", ending, plural);
  if (all > count) text += fmt::format(" and {} other{}", all - count, all - count == 1 ? "" : "s");
  if (is_flat_image("x" + ending)) text += ", and stacks of such pictures are not read: convert them to TIFF or NRRD";
  return text;
}

}  // namespace isobench
