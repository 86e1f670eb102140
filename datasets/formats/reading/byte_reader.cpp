#include "isobench/datasets/formats/reading/byte_reader.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

// By which factor the formats compress at most.
constexpr std::uintmax_t most_deflation = 1032;
constexpr std::uintmax_t most_bzip2 = std::uintmax_t{1} << 20U;

std::uintmax_t bytes_from(const DataFile& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file.path, error);
  if (error) throw DataError(file.path.string() + ": cannot be opened; check the path and its permissions");
  return size - std::min(file.offset, size);
}

[[noreturn]] void throw_damaged(const std::filesystem::path& path) {
  throw DataError(path.string() + ": its compressed data are damaged; copy or export it again");
}

}  // namespace

/// One file, unpacked.
class ByteReader::Stream {
 public:
  explicit Stream(const DataFile& file) : path_(file.path), left_(bytes_from(file)) {
    file_.open(path_, std::ios::binary);
    if (!file_) throw DataError(path_.string() + ": cannot be opened; check the path and its permissions");
    file_.seekg(0, std::ios::end);
    size_ = static_cast<std::uintmax_t>(file_.tellg());
    file_.seekg(static_cast<std::streamoff>(std::min(file.offset, size_)));
  }
  virtual ~Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Up to `count` bytes, at least one but at the end.
  virtual std::size_t read(char* bytes, std::size_t count) = 0;
  /// Skips up to `count` bytes; 0 if they must be read.
  virtual std::uintmax_t skip(std::uintmax_t /*count*/) { return 0; }
  /// False if the file stopped before its compressed data did.
  virtual bool is_complete() const { return true; }
  virtual std::uintmax_t possible_bytes() const = 0;
  std::uintmax_t position() const { return size_ - left_; }

 protected:
  std::size_t read_file(char* bytes, std::size_t count) {
    file_.read(bytes, static_cast<std::streamsize>(count));
    const auto got = static_cast<std::size_t>(file_.gcount());
    left_ -= std::min<std::uintmax_t>(left_, got);
    return got;
  }
  std::uintmax_t skip_file(std::uintmax_t count) {
    const std::uintmax_t skipped = std::min(count, left_);
    file_.seekg(static_cast<std::streamoff>(skipped), std::ios::cur);
    left_ -= skipped;
    return skipped;
  }
  const std::filesystem::path& path() const { return path_; }
  std::uintmax_t left() const { return left_; }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::uintmax_t size_ = 0;
  std::uintmax_t left_ = 0;
};

class ByteReader::PlainStream : public Stream {
 public:
  using Stream::Stream;
  std::size_t read(char* bytes, std::size_t count) override { return read_file(bytes, count); }
  std::uintmax_t skip(std::uintmax_t count) override { return skip_file(count); }
  std::uintmax_t possible_bytes() const override { return left(); }
};

class ByteReader::DeflatedStream : public Stream {
 public:
  explicit DeflatedStream(const DataFile& file) : Stream(file), input_(chunk_bytes) {
    // 15 bits of window; +32: zlib detects whether the stream is gzip's or zlib's.
    if (inflateInit2(&stream_, 15 + 32) != Z_OK)
      throw DataError(path().string() + ": zlib cannot be started; free some memory");
  }
  ~DeflatedStream() override { inflateEnd(&stream_); }
  DeflatedStream(const DeflatedStream&) = delete;
  DeflatedStream& operator=(const DeflatedStream&) = delete;

  std::size_t read(char* bytes, std::size_t count) override {
    stream_.next_out = reinterpret_cast<Bytef*>(bytes);
    stream_.avail_out = static_cast<uInt>(std::min(count, chunk_bytes));
    const uInt asked = stream_.avail_out;
    while (stream_.avail_out > 0 && !ended_) {
      if (stream_.avail_in == 0) {
        stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
        stream_.avail_in = static_cast<uInt>(read_file(input_.data(), input_.size()));
        if (stream_.avail_in == 0) break;  // truncated: the caller gets fewer bytes than it asked for
      }
      const int code = inflate(&stream_, Z_NO_FLUSH);
      if (code == Z_STREAM_END) {
        // A gzip file may have several members; other bytes after the end are padding.
        ended_ = stream_.avail_in < 2 || stream_.next_in[0] != 0x1f || stream_.next_in[1] != 0x8b;
        if (!ended_) inflateReset(&stream_);
      } else if (code != Z_OK && code != Z_BUF_ERROR) {
        throw_damaged(path());
      }
    }
    return asked - stream_.avail_out;
  }
  bool is_complete() const override { return ended_; }
  std::uintmax_t possible_bytes() const override { return most_deflation * (left() + stream_.avail_in) + chunk_bytes; }

 private:
  z_stream stream_{};
  std::vector<char> input_;
  bool ended_ = false;
};

class ByteReader::Bzip2Stream : public Stream {
 public:
  explicit Bzip2Stream(const DataFile& file) : Stream(file), input_(chunk_bytes) { start(); }
  ~Bzip2Stream() override { BZ2_bzDecompressEnd(&stream_); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  std::size_t read(char* bytes, std::size_t count) override {
    stream_.next_out = bytes;
    stream_.avail_out = static_cast<unsigned>(std::min(count, chunk_bytes));
    const unsigned asked = stream_.avail_out;
    while (stream_.avail_out > 0 && !ended_) {
      if (stream_.avail_in == 0) {
        stream_.next_in = input_.data();
        stream_.avail_in = static_cast<unsigned>(read_file(input_.data(), input_.size()));
        if (stream_.avail_in == 0) break;
      }
      const int code = BZ2_bzDecompress(&stream_);
      if (code == BZ_STREAM_END) {
        // A file may have several streams, for example when it was compressed in parallel.
        ended_ = stream_.avail_in < 2 || stream_.next_in[0] != 'B' || stream_.next_in[1] != 'Z';
        if (!ended_) restart();
      } else if (code != BZ_OK) {
        throw_damaged(path());
      }
    }
    return asked - stream_.avail_out;
  }
  bool is_complete() const override { return ended_; }
  std::uintmax_t possible_bytes() const override { return most_bzip2 * (left() + stream_.avail_in) + chunk_bytes; }

 private:
  void start() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK)
      throw DataError(path().string() + ": bzip2 cannot be started; free some memory");
  }
  void restart() {
    const bz_stream rest = stream_;
    BZ2_bzDecompressEnd(&stream_);
    stream_ = {};
    start();
    stream_.next_in = rest.next_in;
    stream_.avail_in = rest.avail_in;
    stream_.next_out = rest.next_out;
    stream_.avail_out = rest.avail_out;
  }

  bz_stream stream_{};
  std::vector<char> input_;
  bool ended_ = false;
};

ByteReader::ByteReader(const std::filesystem::path& path, Encoding encoding, std::uintmax_t offset)
    : ByteReader(std::vector<DataFile>{{path, offset}}, encoding) {}

ByteReader::ByteReader(std::vector<DataFile> files, Encoding encoding) : files_(std::move(files)), encoding_(encoding) {
  stream_ = open(files_.front());
  for (std::size_t n = 1; n < files_.size(); ++n) later_bytes_ += bytes_from(files_[n]);
}

ByteReader::~ByteReader() = default;

std::unique_ptr<ByteReader::Stream> ByteReader::open(const DataFile& file) const {
  switch (encoding_) {
    case Encoding::deflated:
      return std::make_unique<DeflatedStream>(file);
    case Encoding::bzip2:
      return std::make_unique<Bzip2Stream>(file);
    case Encoding::plain:
      break;
  }
  return std::make_unique<PlainStream>(file);
}

void ByteReader::check_complete() const {
  if (!stream_->is_complete()) {
    throw DataError(path().string() +
                    ": truncated: its compressed data stop before their end; copy or export it again");
  }
}

/// Goes on with the next file where one ends.
std::size_t ByteReader::read_stream(char* bytes, std::size_t count) {
  for (;;) {
    const std::size_t got = stream_->read(bytes, count);
    if (got > 0 || count == 0 || at_ + 1 == files_.size()) return got;
    check_complete();
    ++at_;
    later_bytes_ -= std::min(later_bytes_, bytes_from(files_[at_]));
    stream_ = open(files_[at_]);
  }
}

std::size_t ByteReader::read(char* bytes, std::size_t count) {
  std::size_t done = std::min(count, lines_.size() - lines_begin_);
  std::copy_n(lines_.begin() + static_cast<std::ptrdiff_t>(lines_begin_), done, bytes);
  lines_begin_ += done;
  while (done < count) {
    const std::size_t got = read_stream(bytes + done, count - done);
    if (got == 0) break;
    done += got;
  }
  return done;
}

std::uintmax_t ByteReader::consumed() const { return stream_->position() - (lines_.size() - lines_begin_); }

bool ByteReader::read_line(std::string& line, std::size_t limit) {
  line.clear();
  bool any = false;
  while (line.size() < limit) {
    if (lines_begin_ == lines_.size()) {
      lines_.clear();  // so that read(), below, takes new bytes from the file
      lines_begin_ = 0;
      std::vector<char> block(4096);
      block.resize(read(block.data(), block.size()));
      lines_ = std::move(block);
      if (lines_.empty()) return any;
    }
    any = true;
    const char next = lines_[lines_begin_++];
    if (next == '\n') break;
    line.push_back(next);
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

std::uintmax_t ByteReader::skip(std::uintmax_t count) {
  std::uintmax_t done = std::min<std::uintmax_t>(count, lines_.size() - lines_begin_);
  lines_begin_ += static_cast<std::size_t>(done);
  done += stream_->skip(count - done);
  std::vector<char> block;
  while (done < count) {
    block.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(count - done, std::size_t{1} << 16U)));
    const std::size_t got = read(block.data(), block.size());
    if (got == 0) break;
    done += got;
    done += stream_->skip(count - done);  // of the next file
  }
  return done;
}

void ByteReader::finish() {
  if (encoding_ == Encoding::plain) return;
  if (skip(chunk_bytes) == chunk_bytes) {
    throw DataError(path().string() +
                    ": its compressed data go on long after the samples that its header states; export it again");
  }
  check_complete();
}

std::uintmax_t ByteReader::possible_bytes() const {
  const std::uintmax_t factor = encoding_ == Encoding::deflated ? most_deflation
                                : encoding_ == Encoding::bzip2  ? most_bzip2
                                                                : 1;
  const std::uintmax_t limit = std::uintmax_t{1} << 62U;  // what a damaged offset cannot make overflow
  return std::min(limit, lines_.size() - lines_begin_ + stream_->possible_bytes() +
                             std::min(later_bytes_, limit / factor / 4) * factor);
}

Encoding encoding_of(const std::filesystem::path& path) {
  char magic[3] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  if (magic[0] == '\x1f' && magic[1] == '\x8b') return Encoding::deflated;
  if (magic[0] == 'B' && magic[1] == 'Z' && magic[2] == 'h') return Encoding::bzip2;
  return Encoding::plain;
}

}  // namespace isobench
