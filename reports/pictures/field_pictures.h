// Which fields, that metrics keep with meshes, are drawn of which runs (FieldDeclaration).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "isobench/metrics/metric.h"
#include "isobench/reports/pictures/pictures.h"

namespace isobench {

struct FieldPictures {
  const FieldDeclaration* field = nullptr;
  std::string shot;               ///< part of file names
  std::vector<std::size_t> runs;  ///< of the group
};

/// Fields of all methods first, else in the order of declared_fields(); fields that no mesh of the group has are left
/// out. Reads the beginning of each mesh file.
std::vector<FieldPictures> field_pictures(const PictureGroup& group, const std::filesystem::path& folder);

/// The words below a picture: those of the field, and the seconds of its stage where the run has them.
std::string caption_of(const FieldDeclaration& field, const RunRecord& run);

/// Adds the pictures of fields that have a file.
void list_fields(const PictureGroup& group, const std::filesystem::path& folder, std::vector<Picture>& pictures);

}  // namespace isobench
