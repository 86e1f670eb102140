#include "isobench/datasets/formats/reading/byte_reader.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "isobench/datasets/formats/reading/byte_streams.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// The most that may follow the samples in a compressed file: a few kilobytes can inflate to gigabytes of zeros.
constexpr std::uintmax_t most_surplus = std::uintmax_t{1} << 20U;

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& path, Encoding encoding, std::uintmax_t offset)
    : ByteReader(std::vector<DataFile>{{path, offset}}, encoding) {}

ByteReader::ByteReader(std::vector<DataFile> files, Encoding encoding) : files_(std::move(files)), encoding_(encoding) {
  stream_ = Stream::open(files_.front(), encoding_);
  for (std::size_t n = 1; n < files_.size(); ++n) later_bytes_ += packed_bytes(files_[n]);
}

ByteReader::~ByteReader() = default;

void ByteReader::check_complete() const {
  if (!stream_->is_complete()) {
    throw DataError(path().string() + ": truncated: its data stop before their end; copy or export it again");
  }
}

/// Goes on with the next file where one ends.
std::size_t ByteReader::read_stream(char* bytes, std::size_t count) {
  for (;;) {
    const std::size_t got = stream_->read(bytes, count);
    if (got > 0 || count == 0 || at_ + 1 == files_.size()) return got;
    check_complete();
    ++at_;
    later_bytes_ -= std::min(later_bytes_, packed_bytes(files_[at_]));
    stream_ = Stream::open(files_[at_], encoding_);
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
  if (encoding_ == Encoding::plain) {
    surplus_ = possible_bytes();
    return;
  }
  surplus_ = skip(most_surplus);
  if (surplus_ == most_surplus) {
    throw DataError(path().string() +
                    ": its data go on long after the samples that its header states; export it again");
  }
  check_complete();
}

std::uintmax_t ByteReader::possible_bytes() const {
  const std::uintmax_t factor = most_compression(encoding_);
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
