// What lies in a folder, for messages.
#pragma once

#include <filesystem>
#include <string>

namespace isobench {

/// Whether the ending is that of a picture (PNG, JPEG, BMP or GIF), which has no spacing and often altered samples.
bool is_flat_image(const std::filesystem::path& path);

/// "a folder of 12 .png files and 3 others", by the most frequent ending; of pictures, that they are not read.
std::string text_of_contents(const std::filesystem::path& folder);

}  // namespace isobench
