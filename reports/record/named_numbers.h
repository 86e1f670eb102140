// Numbers by name, stored compactly because very many are held at once.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "isobench/reports/record/shared_value.h"

namespace isobench {

/// Numbers by name, in the order of the names, made from a map. Names take ten times the memory of the numbers, and
/// runs of one method have the same names: share_names() stores them once.
class NamedNumbers {
 public:
  using Names = std::vector<std::string>;

  class Iterator {
   public:
    Iterator(const NamedNumbers& all, std::size_t index) : all_(&all), index_(index) {}
    std::pair<const std::string&, double> operator*() const { return {(*all_->names_)[index_], all_->values_[index_]}; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }

   private:
    const NamedNumbers* all_;
    std::size_t index_;
  };

  NamedNumbers() = default;
  NamedNumbers(const std::map<std::string, double>& numbers) {  // NOLINT: used in place of a map
    Names names;
    names.reserve(numbers.size());
    values_.reserve(numbers.size());
    for (const auto& [name, value] : numbers) {
      names.push_back(name);
      values_.push_back(value);
    }
    names_ = std::move(names);
  }
  NamedNumbers(std::initializer_list<std::pair<const std::string, double>> numbers)
      : NamedNumbers(std::map<std::string, double>(numbers)) {}

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, values_.size()}; }

  /// Takes the pool's copy of these names.
  void share_names(SharedPool<Names>& pool) { names_ = pool.first_of(names_); }

 private:
  SharedValue<Names> names_;
  std::vector<double> values_;  ///< as many as names
};

}  // namespace isobench
