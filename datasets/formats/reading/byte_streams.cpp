#include "isobench/datasets/formats/reading/byte_streams.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t input_bytes = std::size_t{1} << 20U;

/// -1 for other characters.
int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::uintmax_t most_compression(Encoding encoding) {
  switch (encoding) {
    case Encoding::deflated:
      return 1032;
    case Encoding::bzip2:
      return std::uintmax_t{1} << 20U;
    case Encoding::plain:
    case Encoding::hex:
      break;
  }
  return 1;
}

std::uintmax_t packed_bytes(const DataFile& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file.path, error);
  if (error) throw DataError(file.path.string() + ": cannot be opened; check the path and its permissions");
  return size - std::min(file.offset, size);
}

ByteReader::Stream::Stream(const DataFile& file) : path_(file.path), left_(packed_bytes(file)) {
  file_.open(path_, std::ios::binary);
  if (!file_) throw DataError(path_.string() + ": cannot be opened; check the path and its permissions");
  file_.seekg(0, std::ios::end);
  size_ = static_cast<std::uintmax_t>(file_.tellg());
  file_.seekg(static_cast<std::streamoff>(std::min(file.offset, size_)));
}

std::size_t ByteReader::Stream::read_file(char* bytes, std::size_t count) {
  file_.read(bytes, static_cast<std::streamsize>(count));
  const auto got = static_cast<std::size_t>(file_.gcount());
  left_ -= std::min<std::uintmax_t>(left_, got);
  return got;
}

std::uintmax_t ByteReader::Stream::skip_file(std::uintmax_t count) {
  const std::uintmax_t skipped = std::min(count, left_);
  file_.seekg(static_cast<std::streamoff>(skipped), std::ios::cur);
  left_ -= skipped;
  return skipped;
}

void ByteReader::Stream::throw_damaged() const {
  throw DataError(path_.string() + ": its compressed data are damaged; copy or export it again");
}

class ByteReader::PlainStream : public Stream {
 public:
  using Stream::Stream;
  std::size_t read(char* bytes, std::size_t count) override { return read_file(bytes, count); }
  std::uintmax_t skip(std::uintmax_t count) override { return skip_file(count); }
  std::uintmax_t possible_bytes() const override { return left(); }
};

/// Two hexadecimal digits a byte; blanks and line ends may lie between them.
class ByteReader::HexStream : public Stream {
 public:
  explicit HexStream(const DataFile& file) : Stream(file), input_(std::size_t{1} << 16U) {}

  std::size_t read(char* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count) {
      if (at_ == end_) {
        at_ = 0;
        end_ = read_file(input_.data(), input_.size());
        if (end_ == 0) break;
      }
      const char c = input_[at_++];
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f' || c == '\v') continue;
      const int digit = hex_digit(c);
      if (digit < 0) {
        throw DataError(path().string() +
                        ": its data have a character that is no hexadecimal digit; copy or export it again");
      }
      if (upper_ < 0) {
        upper_ = digit;
        continue;
      }
      bytes[done++] = static_cast<char>(16 * upper_ + digit);
      upper_ = -1;
    }
    return done;
  }
  bool is_complete() const override { return upper_ < 0; }
  std::uintmax_t possible_bytes() const override { return (left() + end_ - at_) / 2 + 1; }

 private:
  std::vector<char> input_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  int upper_ = -1;  // the first digit of a byte whose second one has not been read
};

/// What deflate and bzip2 have in common: a block of the file as input, and streams that follow each other.
class ByteReader::CompressedStream : public Stream {
 public:
  explicit CompressedStream(const DataFile& file) : Stream(file), input_(input_bytes) {}
  bool is_complete() const override { return ended_; }

 protected:
  /// Reads the next block; nothing at the end of the file.
  std::size_t refill() { return read_file(input_.data(), input_.size()); }
  char* input() { return input_.data(); }
  /// Whether the next bytes are these two, with which another stream begins. `rest` is what is left of the input; the
  /// two bytes may lie on either side of its end. Leaves them at its beginning in that case.
  template <class Byte, class Count>
  bool begins_with(Byte*& rest, Count& count, char first, char second) {
    if (count < 2) {
      if (count == 1) input_[0] = static_cast<char>(*rest);
      count += static_cast<Count>(read_file(input_.data() + count, input_.size() - count));
      rest = reinterpret_cast<Byte*>(input_.data());
    }
    return count >= 2 && static_cast<char>(rest[0]) == first && static_cast<char>(rest[1]) == second;
  }
  void end() { ended_ = true; }
  bool ended() const { return ended_; }

 private:
  std::vector<char> input_;
  bool ended_ = false;
};

class ByteReader::DeflatedStream : public CompressedStream {
 public:
  explicit DeflatedStream(const DataFile& file) : CompressedStream(file) {
    // 15 bits of window; +32: zlib detects whether the stream is gzip's or zlib's.
    if (inflateInit2(&stream_, 15 + 32) != Z_OK)
      throw DataError(path().string() + ": zlib cannot be started; free some memory");
  }
  ~DeflatedStream() override { inflateEnd(&stream_); }
  DeflatedStream(const DeflatedStream&) = delete;
  DeflatedStream& operator=(const DeflatedStream&) = delete;

  std::size_t read(char* bytes, std::size_t count) override {
    stream_.next_out = reinterpret_cast<Bytef*>(bytes);
    stream_.avail_out = static_cast<uInt>(std::min(count, input_bytes));
    const uInt asked = stream_.avail_out;
    while (stream_.avail_out > 0 && !ended()) {
      if (stream_.avail_in == 0) {
        stream_.next_in = reinterpret_cast<Bytef*>(input());
        stream_.avail_in = static_cast<uInt>(refill());
        if (stream_.avail_in == 0) break;  // truncated: the caller gets fewer bytes than it asked for
      }
      const int code = inflate(&stream_, Z_NO_FLUSH);
      if (code == Z_STREAM_END) {
        // A gzip file may have several members; other bytes after the end are padding.
        if (begins_with(stream_.next_in, stream_.avail_in, '\x1f', '\x8b'))
          inflateReset(&stream_);
        else
          end();
      } else if (code != Z_OK && code != Z_BUF_ERROR) {
        throw_damaged();
      }
    }
    return asked - stream_.avail_out;
  }
  std::uintmax_t possible_bytes() const override {
    return most_compression(Encoding::deflated) * (left() + stream_.avail_in) + input_bytes;
  }

 private:
  z_stream stream_{};
};

class ByteReader::Bzip2Stream : public CompressedStream {
 public:
  explicit Bzip2Stream(const DataFile& file) : CompressedStream(file) { start(); }
  ~Bzip2Stream() override { BZ2_bzDecompressEnd(&stream_); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  std::size_t read(char* bytes, std::size_t count) override {
    stream_.next_out = bytes;
    stream_.avail_out = static_cast<unsigned>(std::min(count, input_bytes));
    const unsigned asked = stream_.avail_out;
    while (stream_.avail_out > 0 && !ended()) {
      if (stream_.avail_in == 0) {
        stream_.next_in = input();
        stream_.avail_in = static_cast<unsigned>(refill());
        if (stream_.avail_in == 0) break;
      }
      const int code = BZ2_bzDecompress(&stream_);
      if (code == BZ_STREAM_END) {
        // A file may have several streams, for example when it was compressed in parallel.
        if (begins_with(stream_.next_in, stream_.avail_in, 'B', 'Z'))
          restart();
        else
          end();
      } else if (code != BZ_OK) {
        throw_damaged();
      }
    }
    return asked - stream_.avail_out;
  }
  std::uintmax_t possible_bytes() const override {
    return most_compression(Encoding::bzip2) * (left() + stream_.avail_in) + input_bytes;
  }

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
};

std::unique_ptr<ByteReader::Stream> ByteReader::Stream::open(const DataFile& file, Encoding encoding) {
  switch (encoding) {
    case Encoding::deflated:
      return std::make_unique<DeflatedStream>(file);
    case Encoding::bzip2:
      return std::make_unique<Bzip2Stream>(file);
    case Encoding::hex:
      return std::make_unique<HexStream>(file);
    case Encoding::plain:
      break;
  }
  return std::make_unique<PlainStream>(file);
}

}  // namespace isobench
