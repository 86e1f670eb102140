#include "isobench/experiments/plan/cell_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace isobench {

namespace {

std::size_t read_number(const std::string& word, const std::string& words, std::size_t count) {
  std::size_t number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || stop != end) {
    throw UsageError(fmt::format("--cells '{}': '{}' is not a cell number; expected a list like 3-7,12", words, word));
  }
  if (number < 1 || number > count) {
    throw UsageError(
        fmt::format("--cells '{}': there is no cell {}; the plan has cells 1 to {}", words, number, count));
  }
  return number;
}

}  // namespace

std::vector<std::size_t> parse_cell_numbers(const std::string& words, std::size_t count) {
  std::vector<std::size_t> numbers;
  for (std::size_t start = 0; start <= words.size();) {
    const std::size_t comma = std::min(words.find(',', start), words.size());
    const std::string part = words.substr(start, comma - start);
    const std::size_t dash = part.find('-');
    const std::size_t first = read_number(part.substr(0, dash), words, count);
    const std::size_t last = dash == std::string::npos ? first : read_number(part.substr(dash + 1), words, count);
    if (last < first) throw UsageError(fmt::format("--cells '{}': {} runs backwards", words, part));
    for (std::size_t number = first; number <= last; ++number) numbers.push_back(number);
    start = comma + 1;
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::string cell_numbers_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t n = 0; n < numbers.size();) {
    std::size_t last = n;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += last > n ? fmt::format("{}-{}", numbers[n], numbers[last]) : fmt::format("{}", numbers[n]);
    n = last + 1;
  }
  return text;
}

}  // namespace isobench
