// The samples of a volume, kept in the type that they have in the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace isobench {

/// The types that samples may have: unsigned and signed integers, and floating-point numbers, by their bits.
enum class SampleType { u8, i8, u16, i16, u32, i32, f32, f64, i64, u64 };

/// Bytes of one sample.
std::size_t bytes_of(SampleType type);

std::string to_string(SampleType type);  ///< "u8", "i16", "f32" and so on

/// The smallest floating-point type that holds every value of T exactly; double for 64-bit integers, too, which it
/// holds exactly up to 2^53. Steps with results that T cannot hold give this type.
template <class T>
using RealOf = std::conditional_t<std::is_same_v<T, float> || (std::is_integral_v<T> && sizeof(T) <= 2), float, double>;

/// The sample type of a std::vector, for what is given to Samples::visit().
template <class Values>
using SampleOf = typename std::remove_cvref_t<Values>::value_type;

/// An array of samples of one type. It takes bytes_of(type()) bytes a sample and no more. Code that works on every type
/// calls visit(); code that computes with floats asks for floats.
class Samples {
 public:
  Samples() : Samples(SampleType::f32) {}
  /// No samples yet, of this type.
  explicit Samples(SampleType type);
  /// Takes the vector over. T is one of the types that SampleType names.
  template <class T>
  Samples(std::vector<T> values) : values_(std::move(values)) {}  // NOLINT(google-explicit-constructor)

  SampleType type() const { return static_cast<SampleType>(values_.index()); }
  std::size_t size() const;
  bool empty() const { return size() == 0; }

  /// Returns what `visitor` returns for the std::vector<T> that holds the samples.
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), values_);
  }
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) {
    return std::visit(std::forward<Visitor>(visitor), values_);
  }

  /// The samples as a vector of T. Throws std::bad_variant_access if T is not their type.
  template <class T>
  const std::vector<T>& as() const {
    return std::get<std::vector<T>>(values_);
  }

  /// True if type and values are the same.
  bool operator==(const Samples&) const = default;

 private:
  /// In the order of SampleType, so that the index tells the type.
  using Values =
      std::variant<std::vector<std::uint8_t>, std::vector<std::int8_t>, std::vector<std::uint16_t>,
                   std::vector<std::int16_t>, std::vector<std::uint32_t>, std::vector<std::int32_t>, std::vector<float>,
                   std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>>;
  Values values_;
};

}  // namespace isobench
