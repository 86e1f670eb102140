// Families of data sets: one manifest that stands for many. Its table [family] lists what differs.
//
//   [family]
//   members = 240                        # wild-fields-001 to wild-fields-240
//   name = "fields"                      # of the group in reports; otherwise the manifest's name
//   isovalue = [80, 98]                  # a key of the manifest: isovalue, inside, kernel
//   correlation = [1.2, 1.8, 2.6]        # a key of [generated]
//   cut.from = [[0, 0, 0], [40, 0, 0]]   # a key of a step of `prepare`
//
// Member n + 1 has of list k, with L_k values, the one with the number
//   (⌊n / P_k⌋ + n mod P_k) mod L_k,   P_k = L_1 ⋯ L_{k−1}.
// These are the digits of n in a mixed radix, each shifted by the digits before it: all combinations come up equally
// often, and any few members in a row have every value of every list. The number of members does not matter, so adding
// some changes none of those that exist.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/toml.h"

namespace isobench {

/// A key that differs between members.
struct FamilyKey {
  std::string table;  ///< "" for a key of the manifest, "generated", or the name of a step
  std::string name;
  std::vector<TomlValue> values;  ///< at least one
};

struct Family {
  std::string name;  ///< of the group
  std::string title;
  int members = 1;
  std::vector<FamilyKey> keys;
};

inline constexpr int most_members = 100000;

/// The family that a manifest describes; std::nullopt if it has no [family]. `name` is the manifest's. Throws
/// UsageError with the place of an unknown key, of a list without values, of a key that stands outside [family], too,
/// and of more members than combinations if nothing else tells members apart (of generated ones, the seed does).
std::optional<Family> parse_family(const TomlValue& manifest, const std::string& name);

/// The manifest of a member: with its own values, and without [family]. Members count from 1.
TomlValue member_manifest(const TomlValue& manifest, const Family& family, int member);

/// "size 32, correlation 1.8": the values of a member.
std::string member_text(const Family& family, int member);

/// "017": the number of a member, with as many digits as the number of members has.
std::string member_number(const Family& family, int member);

/// "wild-fields-001 … -240", of the manifest `manifest`.
std::string members_text(const Family& family, const std::string& manifest);

}  // namespace isobench
