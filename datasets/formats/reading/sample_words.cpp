#include "isobench/datasets/formats/reading/sample_words.h"

namespace isobench {

std::optional<std::string_view> Words::next() {
  char c = ' ';
  while (is_blank(c)) {
    if (!take(c)) return std::nullopt;
  }
  word_.clear();
  do {
    word_.push_back(c);
    if (word_.size() > longest_number) return word_;
  } while (take(c) && !is_blank(c));
  return word_;
}

bool Words::take(char& c) {
  if (begin_ == end_) {
    begin_ = 0;
    end_ = reader_.read(block_.data(), block_.size());
    if (end_ == 0) return false;
  }
  c = block_[begin_++];
  return true;
}

}  // namespace isobench
