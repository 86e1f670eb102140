#include <zlib.h>

#include <algorithm>
#include <fstream>

#include "isobench/datasets/formats/sample_data.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

}  // namespace

struct ByteReader::State {
  std::ifstream file;
  Encoding encoding = Encoding::plain;
  z_stream stream{};
  std::vector<char> input;
  std::vector<char> lines;  // bytes that read_line() has read from the file but not returned
  std::size_t lines_begin = 0;
  bool ended = false;
  std::uintmax_t file_size = 0;
  std::uintmax_t left_in_file = 0;

  std::size_t read_file(char* bytes, std::size_t count) {
    file.read(bytes, static_cast<std::streamsize>(count));
    const auto got = static_cast<std::size_t>(file.gcount());
    left_in_file -= std::min<std::uintmax_t>(left_in_file, got);
    return got;
  }
  std::size_t inflate_some(char* bytes, std::size_t count, const std::filesystem::path& path);
};

ByteReader::ByteReader(std::filesystem::path path, Encoding encoding, std::uintmax_t offset)
    : path_(std::move(path)), state_(std::make_unique<State>()) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_, error);
  state_->file.open(path_, std::ios::binary);
  if (error || !state_->file)
    throw DataError(path_.string() + ": cannot be opened; check the path and its permissions");
  state_->file.seekg(static_cast<std::streamoff>(std::min(offset, size)));
  state_->file_size = size;
  state_->left_in_file = size - std::min(offset, size);
  state_->encoding = encoding;
  if (encoding == Encoding::deflated) {
    state_->input.resize(chunk_bytes);
    // 15 bits of window; +32: zlib detects whether the stream is gzip's or zlib's.
    if (inflateInit2(&state_->stream, 15 + 32) != Z_OK)
      throw DataError(path_.string() + ": zlib cannot be started; free some memory");
  }
}

ByteReader::~ByteReader() {
  if (state_->encoding == Encoding::deflated) inflateEnd(&state_->stream);
}

std::size_t ByteReader::State::inflate_some(char* bytes, std::size_t count, const std::filesystem::path& path) {
  stream.next_out = reinterpret_cast<Bytef*>(bytes);
  stream.avail_out = static_cast<uInt>(std::min(count, chunk_bytes));
  const uInt asked = stream.avail_out;
  while (stream.avail_out > 0 && !ended) {
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(input.data());
      stream.avail_in = static_cast<uInt>(read_file(input.data(), input.size()));
      if (stream.avail_in == 0) break;  // truncated: the caller gets fewer bytes than it asked for
    }
    const int code = inflate(&stream, Z_NO_FLUSH);
    if (code == Z_STREAM_END) {
      // A gzip file may have several members; other bytes after the end are padding.
      const bool more = stream.avail_in >= 2 && stream.next_in[0] == 0x1f && stream.next_in[1] == 0x8b;
      if (more)
        inflateReset(&stream);
      else
        ended = true;
    } else if (code != Z_OK && code != Z_BUF_ERROR) {
      throw DataError(path.string() + ": its compressed data are damaged; copy or export it again");
    }
  }
  return asked - stream.avail_out;
}

std::size_t ByteReader::read(char* bytes, std::size_t count) {
  std::size_t done = std::min(count, state_->lines.size() - state_->lines_begin);
  std::copy_n(state_->lines.begin() + static_cast<std::ptrdiff_t>(state_->lines_begin), done, bytes);
  state_->lines_begin += done;
  while (done < count) {
    const std::size_t got = state_->encoding == Encoding::plain
                                ? state_->read_file(bytes + done, count - done)
                                : state_->inflate_some(bytes + done, count - done, path_);
    if (got == 0) break;
    done += got;
  }
  return done;
}

std::uintmax_t ByteReader::consumed() const {
  return state_->file_size - state_->left_in_file - (state_->lines.size() - state_->lines_begin);
}

Encoding ByteReader::encoding() const { return state_->encoding; }

bool ByteReader::read_line(std::string& line, std::size_t limit) {
  line.clear();
  std::vector<char>& lines = state_->lines;
  std::size_t& begin = state_->lines_begin;
  bool any = false;
  while (line.size() < limit) {
    if (begin == lines.size()) {
      lines.clear();  // so that read(), below, takes new bytes from the file
      begin = 0;
      std::vector<char> block(4096);
      block.resize(read(block.data(), block.size()));
      lines = std::move(block);
      if (lines.empty()) return any;
    }
    any = true;
    const char next = lines[begin++];
    if (next == '\n') break;
    line.push_back(next);
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

std::uintmax_t ByteReader::skip(std::uintmax_t count) {
  std::vector<char> block(static_cast<std::size_t>(std::min<std::uintmax_t>(count, std::size_t{1} << 16U)));
  std::uintmax_t done = 0;
  while (done < count) {
    const std::size_t got =
        read(block.data(), static_cast<std::size_t>(std::min<std::uintmax_t>(count - done, block.size())));
    if (got == 0) break;
    done += got;
  }
  return done;
}

void ByteReader::finish() {
  if (state_->encoding == Encoding::plain) return;
  if (skip(chunk_bytes) == chunk_bytes) {
    throw DataError(path_.string() +
                    ": its compressed data go on long after the samples that its header states; export it again");
  }
  if (!state_->ended) {
    throw DataError(path_.string() + ": truncated: its compressed data stop before their end; copy or export it again");
  }
}

std::uintmax_t ByteReader::possible_bytes() const {
  const std::uintmax_t buffered = state_->lines.size() - state_->lines_begin;
  if (state_->encoding == Encoding::plain) return buffered + state_->left_in_file;
  return buffered + 1032 * (state_->left_in_file + state_->stream.avail_in) + chunk_bytes;
}

}  // namespace isobench
