#include "isobench/datasets/formats/dicom/dicom_source.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::uintmax_t most_inflation = 1032;

}  // namespace

class DicomSource::File {
 public:
  explicit File(const std::filesystem::path& path) {
    std::error_code error;
    left_ = std::filesystem::file_size(path, error);
    if (!error) stream_.open(path, std::ios::binary);
    if (error || !stream_) throw DataError(path.string() + ": cannot be opened; check the path and its permissions");
  }
  std::size_t read(char* bytes, std::size_t count) {
    stream_.read(bytes, static_cast<std::streamsize>(count));
    const auto got = static_cast<std::size_t>(stream_.gcount());
    left_ -= std::min<std::uintmax_t>(left_, got);
    return got;
  }
  /// Precondition: so many bytes follow.
  void skip(std::uintmax_t count) {
    constexpr std::uintmax_t buffered = 4096;  // a seek drops the stream's buffer
    if (count < buffered)
      stream_.ignore(static_cast<std::streamsize>(count));
    else
      stream_.seekg(static_cast<std::streamoff>(count), std::ios::cur);
    left_ -= count;
  }
  std::uintmax_t left() const { return left_; }

 private:
  std::ifstream stream_;
  std::uintmax_t left_ = 0;
};

class DicomSource::Inflating {
 public:
  /// `begin` was read from the file already.
  Inflating(File& file, const std::string& begin) : file_(file), input_(std::size_t{1} << 16U) {
    inflateInit2(&stream_, -15);  // a raw stream with a window of 15 bits
    std::copy(begin.begin(), begin.end(), input_.begin());
    stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
    stream_.avail_in = static_cast<uInt>(begin.size());
  }
  ~Inflating() { inflateEnd(&stream_); }
  Inflating(const Inflating&) = delete;
  Inflating& operator=(const Inflating&) = delete;

  /// Fewer bytes than asked for at the end of the stream or where it is damaged.
  std::size_t read(char* bytes, std::size_t count) {
    std::size_t done = 0;
    while (done < count && !ended_) {
      if (stream_.avail_in == 0) {
        stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
        stream_.avail_in = static_cast<uInt>(file_.read(input_.data(), input_.size()));
        if (stream_.avail_in == 0) break;
      }
      const auto part = static_cast<uInt>(std::min<std::size_t>(count - done, std::size_t{1} << 30U));
      stream_.next_out = reinterpret_cast<Bytef*>(bytes + done);
      stream_.avail_out = part;
      const int code = inflate(&stream_, Z_NO_FLUSH);
      done += part - stream_.avail_out;
      ended_ = code != Z_OK && code != Z_BUF_ERROR;
    }
    return done;
  }
  std::uintmax_t possible_bytes() const {
    return ended_ ? 0 : most_inflation * (file_.left() + stream_.avail_in) + (std::uintmax_t{1} << 16U);
  }

 private:
  File& file_;
  z_stream stream_{};
  std::vector<char> input_;
  bool ended_ = false;
};

DicomSource::DicomSource(const std::filesystem::path& path) : path_(path), file_(std::make_unique<File>(path)) {}

DicomSource::~DicomSource() = default;

void DicomSource::inflate_rest() {
  inflating_ = std::make_unique<Inflating>(*file_, ahead_);
  ahead_.clear();
}

std::size_t DicomSource::read_some(char* bytes, std::size_t count) {
  return inflating_ ? inflating_->read(bytes, count) : file_->read(bytes, count);
}

std::string DicomSource::peek(std::size_t count) {
  while (ahead_.size() < count) {
    std::string more(count - ahead_.size(), '\0');
    more.resize(read_some(more.data(), more.size()));
    if (more.empty()) break;
    ahead_ += more;
  }
  return ahead_.substr(0, count);
}

void DicomSource::read(char* bytes, std::size_t count) {
  const std::size_t from_ahead = std::min(count, ahead_.size());
  std::copy_n(ahead_.begin(), from_ahead, bytes);
  ahead_.erase(0, from_ahead);
  if (read_some(bytes + from_ahead, count - from_ahead) < count - from_ahead)
    throw DataError(path_.string() + ": truncated: it ends before its data do; copy or export it again");
  position_ += count;
}

void DicomSource::skip(std::uintmax_t count) {
  if (count > possible_bytes())
    throw DataError(path_.string() + ": truncated: it ends before its data do; copy or export it again");
  const auto from_ahead = static_cast<std::size_t>(std::min<std::uintmax_t>(count, ahead_.size()));
  ahead_.erase(0, from_ahead);
  position_ += from_ahead;
  count -= from_ahead;
  if (!inflating_) {
    file_->skip(count);
    position_ += count;
    return;
  }
  std::vector<char> unused(static_cast<std::size_t>(std::min<std::uintmax_t>(count, std::uintmax_t{1} << 16U)));
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uintmax_t>(count, unused.size()));
    read(unused.data(), part);
    count -= part;
  }
}

std::uintmax_t DicomSource::possible_bytes() const {
  return ahead_.size() + (inflating_ ? inflating_->possible_bytes() : file_->left());
}

}  // namespace isobench
