// A value that many objects have, stored once.
#pragma once

#include <memory>
#include <set>
#include <utility>

namespace isobench {

/// A value that is never changed in place, so its copies share one object: a hundred thousand runs have only a few
/// different sets of parameters. Converts from a value; to change it, assign another one.
template <class T>
class SharedValue {
 public:
  SharedValue() : value_(nothing()) {}
  SharedValue(T value) : value_(std::make_shared<const T>(std::move(value))) {}  // NOLINT: used in place of a T

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

  friend bool operator==(const SharedValue& a, const SharedValue& b) { return a.value_ == b.value_ || *a == *b; }

 private:
  static const std::shared_ptr<const T>& nothing() {
    static const std::shared_ptr<const T> empty = std::make_shared<const T>();
    return empty;
  }

  std::shared_ptr<const T> value_;
};

/// Stores equal values once.
template <class T>
class SharedPool {
 public:
  /// The pool's value that equals this one. If there is none yet, the pool takes this one.
  const SharedValue<T>& first_of(const SharedValue<T>& value) { return *values_.insert(value).first; }

 private:
  struct Less {
    bool operator()(const SharedValue<T>& a, const SharedValue<T>& b) const { return *a < *b; }
  };
  std::set<SharedValue<T>, Less> values_;
};

}  // namespace isobench
