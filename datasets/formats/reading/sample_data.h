// Samples as files hold them: bytes or text of a stated type.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// Converts `count` samples from a file's bytes to double; 64-bit integers beyond 2^53 are rounded.
void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, double* numbers);

/// The samples that `count` · bytes_of(type) bytes of a file hold.
Samples samples_of_bytes(const char* bytes, std::size_t count, SampleType type, ByteOrder order);

/// The samples that a text of exactly `count` numbers holds; std::nullopt if it is not one. An integer may be written
/// as 3, 3.0 or 3e0, and must be within the range of its type.
std::optional<Samples> samples_of_text(std::string_view text, std::size_t count, SampleType type);

/// The type that a file's header names: "unsigned short", "u16", "uint16", "MET_USHORT" and the like; std::nullopt for
/// other names.
std::optional<SampleType> sample_type(const std::string& name);

}  // namespace isobench
