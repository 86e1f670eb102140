#include "isobench/datasets/formats/reading/read_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/datasets/formats/reading/sample_words.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

[[noreturn]] void throw_truncated(const std::filesystem::path& path, std::size_t found, std::size_t expected) {
  throw DataError(fmt::format(
      "{}: truncated: its header states {} samples, but data for at most {} follow; copy or export it again",
      path.string(), expected, found));
}

/// Walks through an array in the file's order, run by run: neighbours in the file that are all kept or all left out.
class Runs {
 public:
  explicit Runs(std::span<const FileAxis> axes) {
    std::size_t inner = 0;
    for (; inner < axes.size() && !axes[inner].chosen; ++inner) length_ *= axes[inner].size;
    outer_.assign(axes.begin() + static_cast<std::ptrdiff_t>(inner), axes.end());
    place_.assign(outer_.size(), 0);
    for (const FileAxis& axis : axes) samples_ *= axis.size;
    for (const FileAxis& axis : axes) kept_ *= axis.chosen ? 1 : axis.size;
  }

  std::size_t samples() const { return samples_; }  ///< of the whole array
  std::size_t kept() const { return kept_; }        ///< the samples that are kept
  std::size_t length() const { return length_; }    ///< samples of each run
  bool is_kept() const {
    for (std::size_t n = 0; n < outer_.size(); ++n) {
      if (outer_[n].chosen && *outer_[n].chosen != place_[n]) return false;
    }
    return true;
  }
  void next() {
    for (std::size_t n = 0; n < outer_.size() && ++place_[n] == outer_[n].size; ++n) place_[n] = 0;
  }

 private:
  std::size_t length_ = 1;
  std::size_t samples_ = 1;
  std::size_t kept_ = 1;
  std::vector<FileAxis> outer_;
  std::vector<std::size_t> place_;
};

/// Appends what the file has next. Throws DataError if there is less; `done` and `count` are for its message.
template <class T>
void append(ByteReader& reader, std::size_t number, ByteOrder order, std::vector<T>& samples, std::size_t done,
            std::size_t count) {
  while (number > 0) {
    const std::size_t part = std::min(number, chunk_bytes / sizeof(T));
    const std::size_t first = samples.size();
    samples.resize(first + part);
    const std::size_t got = reader.read(reinterpret_cast<char*>(samples.data() + first), part * sizeof(T)) / sizeof(T);
    if (got < part) throw_truncated(reader.path(), done + got, count);
    to_native_order(std::span(samples).subspan(first), order);
    number -= part;
    done += part;
  }
}

/// Runs of many samples: those that are left out need not be read.
template <class T>
void read_long_runs(ByteReader& reader, Runs runs, ByteOrder order, std::vector<T>& samples) {
  for (std::size_t done = 0; done < runs.samples(); done += runs.length(), runs.next()) {
    if (runs.is_kept()) {
      append(reader, runs.length(), order, samples, done, runs.samples());
      continue;
    }
    const std::uintmax_t skipped = reader.skip(std::uintmax_t{runs.length()} * sizeof(T)) / sizeof(T);
    if (skipped < runs.length())
      throw_truncated(reader.path(), done + static_cast<std::size_t>(skipped), runs.samples());
  }
}

/// Runs of few samples, for example of one: the file is read in larger parts, and the samples are picked out.
template <class T>
void read_short_runs(ByteReader& reader, Runs runs, ByteOrder order, std::vector<T>& samples) {
  const std::size_t runs_a_part = std::max<std::size_t>(1, chunk_bytes / sizeof(T) / runs.length());
  std::vector<T> part;
  for (std::size_t done = 0; done < runs.samples(); done += part.size()) {
    part.clear();
    append(reader, std::min(runs_a_part * runs.length(), runs.samples() - done), order, part, done, runs.samples());
    for (auto run = part.begin(); run != part.end(); run += static_cast<std::ptrdiff_t>(runs.length()), runs.next()) {
      if (runs.is_kept()) samples.insert(samples.end(), run, run + static_cast<std::ptrdiff_t>(runs.length()));
    }
  }
}

/// This takes only addresses, no memory yet: a compressed file's header may state a thousand times what it holds.
template <class T>
void reserve_values(std::vector<T>& samples, std::size_t count, Encoding encoding) {
  constexpr std::size_t most = (std::size_t{1} << 30U) / sizeof(T);
  samples.reserve(samples.size() + (encoding == Encoding::bzip2 ? std::min(count, most) : count));
}

template <class T>
void read_binary(ByteReader& reader, const Runs& runs, ByteOrder order, std::vector<T>& samples) {
  const std::uintmax_t possible = reader.possible_bytes() / sizeof(T);
  if (possible < runs.samples()) throw_truncated(reader.path(), static_cast<std::size_t>(possible), runs.samples());
  reserve_values(samples, runs.kept(), reader.encoding());
  if (runs.length() * sizeof(T) >= chunk_bytes / 16)
    read_long_runs(reader, runs, order, samples);
  else
    read_short_runs(reader, runs, order, samples);
  reader.finish();
}

template <class T>
T number_in(std::string_view word, const std::filesystem::path& path) {
  const std::optional<T> value = number_of_word<T>(word);
  if (!value) {
    throw DataError(fmt::format("{}: '{}' among its samples is not a number of type {}; export it again", path.string(),
                                word.substr(0, 20), to_string(Samples(std::vector<T>()).type())));
  }
  return *value;
}

template <class T>
bool read_text(ByteReader& reader, Runs runs, std::vector<T>& samples) {
  const std::uintmax_t possible = reader.possible_bytes() / 2 + 1;  // a digit and a blank each
  if (possible < runs.samples()) throw_truncated(reader.path(), static_cast<std::size_t>(possible), runs.samples());
  reserve_values(samples, runs.kept(), reader.encoding());
  Words words(reader);
  for (std::size_t done = 0; done < runs.samples(); runs.next()) {
    const bool is_kept = runs.is_kept();
    for (std::size_t n = 0; n < runs.length(); ++n, ++done) {
      const std::optional<std::string_view> word = words.next();
      if (!word) throw_truncated(reader.path(), done, runs.samples());
      const T number = number_in<T>(*word, reader.path());
      if (is_kept) samples.push_back(number);
    }
  }
  const bool more = words.next().has_value();
  reader.finish();
  return more;
}

}  // namespace

void read_samples(ByteReader& reader, std::size_t count, ByteOrder order, Samples& samples) {
  const FileAxis axis{count};
  read_samples(reader, std::span(&axis, 1), order, samples);
}

void read_samples(ByteReader& reader, std::span<const FileAxis> axes, ByteOrder order, Samples& samples) {
  samples.visit([&](auto& values) { read_binary(reader, Runs(axes), order, values); });
}

bool read_text_samples(ByteReader& reader, std::size_t count, Samples& samples) {
  const FileAxis axis{count};
  return read_text_samples(reader, std::span(&axis, 1), samples);
}

bool read_text_samples(ByteReader& reader, std::span<const FileAxis> axes, Samples& samples) {
  return samples.visit([&](auto& values) { return read_text(reader, Runs(axes), values); });
}

void reserve_samples(Samples& samples, std::size_t count, Encoding encoding) {
  samples.visit([&](auto& values) { reserve_values(values, count, encoding); });
}

std::size_t place_on_axis(const std::optional<std::size_t>& choice, std::size_t size, const std::string& what,
                          const std::filesystem::path& path) {
  if (!choice && size > 1) {
    throw DataError(
        fmt::format("{}: it has {} {}s; choose one with --{} 0 to {}", path.string(), size, what, what, size - 1));
  }
  const std::size_t place = choice.value_or(0);
  if (place >= size) {
    throw DataError(fmt::format("{}: there is no {} {}; it has {} {}{}, and the first is 0", path.string(), what, place,
                                size, what, size == 1 ? "" : "s"));
  }
  return place;
}

}  // namespace isobench
