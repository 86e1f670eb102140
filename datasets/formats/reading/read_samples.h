// Reading samples straight into a volume's array, so that no second copy of a volume is ever in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/formats/reading/byte_reader.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// An axis of the array in a file.
struct FileAxis {
  std::size_t size = 1;
  std::optional<std::size_t> chosen = {};  ///< only the samples at this place of the axis are kept
};

/// Appends `count` samples of the type of `samples`, and checks that a compressed stream is complete. Throws DataError
/// if the file holds fewer samples. It compares `count` with the file's size before it takes memory, and takes memory
/// as samples arrive, so that a wrong size in a header costs nothing.
void read_samples(ByteReader& reader, std::size_t count, ByteOrder order, Samples& samples);

/// The same for an array with these axes, the fastest first, of which only the samples at the chosen places are kept:
/// one step of a series, one component of vectors. The others are read, too, but for long runs in plain files.
/// Precondition: chosen < size for every axis, and the sizes' product fits into std::size_t.
void read_samples(ByteReader& reader, std::span<const FileAxis> axes, ByteOrder order, Samples& samples);

/// The same for numbers written as text. Throws DataError, too, for a word that is not a number of the samples' type.
/// Returns whether more words follow.
bool read_text_samples(ByteReader& reader, std::size_t count, Samples& samples);
bool read_text_samples(ByteReader& reader, std::span<const FileAxis> axes, Samples& samples);

/// Takes addresses for so many more samples, so that they need not be moved as they arrive. Bzip2 can compress a
/// million times: for its data, memory is taken at once only up to 1 GiB.
void reserve_samples(Samples& samples, std::size_t count, Encoding encoding);

/// The place that a choice means on an axis of `size` > 0 places. Without a choice it is the only place that there is.
/// Throws DataError that names the file and what can be chosen, e.g. "scan.nii: it has 3 steps; choose one with --step
/// 0 to 2". `what` is "step" or "component".
std::size_t place_on_axis(const std::optional<std::size_t>& choice, std::size_t size, const std::string& what,
                          const std::filesystem::path& path);

}  // namespace isobench
