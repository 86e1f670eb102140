#include "isobench/datasets/formats/nifti/nifti_placement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// Node (i, j, k) lies at steps · (i, j, k) + origin, in mm.
struct Placement {
  Eigen::Matrix3d steps;
  Eigen::Vector3d origin;
  bool is_known = true;  // in the scanner or in another world
};

double unit_of(const NiftiFields& fields, const std::filesystem::path& path, std::vector<std::string>& notes) {
  if (fields.kind == NiftiKind::analyze) {
    try {
      return unit_in_mm(fields.unit_name, path);
    } catch (const DataError&) {  // the field is seldom filled with care
      notes.push_back(fmt::format("{}: its unit of length '{}' is not known; mm are taken", path.string(),
                                  printable(fields.unit_name)));
      return 1.0;
    }
  }
  switch (fields.units & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 1e-3;
    case 0:
    case 2:
      return 1.0;
    default:
      notes.push_back(fmt::format("{}: its code {} for the unit of length is not known; mm are taken", path.string(),
                                  fields.units & 7));
      return 1.0;
  }
}

/// The size of a voxel, in mm; 0 where the header states none.
Eigen::Vector3d voxel_of(const NiftiFields& fields, double unit) {
  Eigen::Vector3d voxel;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = unit * std::abs(fields.pixdim[static_cast<std::size_t>(axis) + 1]);
    voxel[axis] = std::isfinite(length) ? length : 0.0;
  }
  return voxel;
}

/// True if make_lattice() accepts these steps.
bool is_usable(const Placement& placement) {
  Eigen::Matrix3d direction = placement.steps;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = direction.col(axis).norm();
    if (!(length > 0.0) || !std::isfinite(length)) return false;
    direction.col(axis) /= length;
  }
  return std::abs(direction.determinant()) > least_determinant && placement.origin.allFinite();
}

std::optional<Placement> by_sform(const NiftiFields& fields, double unit, const Eigen::Vector3d& voxel) {
  if (fields.sform <= 0) return std::nullopt;
  Placement placement{unit * fields.srow.leftCols<3>(), unit * fields.srow.col(3)};
  // A single slice needs no step to the next one, and some programs state none.
  if (fields.size(2) == 1 && placement.steps.col(2).isZero()) {
    placement.steps.col(2) = voxel[2] * placement.steps.col(0).cross(placement.steps.col(1)).normalized();
  }
  return is_usable(placement) ? std::optional(placement) : std::nullopt;
}

std::optional<Placement> by_qform(const NiftiFields& fields, double unit, Eigen::Vector3d voxel) {
  if (fields.qform <= 0) return std::nullopt;
  // A unit quaternion with real part ≥ 0; the real part is not stored. Rounding may make the stored part longer than 1.
  const double rest = 1.0 - fields.quaternion.squaredNorm();
  constexpr double rounding = 1e-2;  // ample for single precision; beyond it, the numbers are no quaternion
  if (!(rest > -rounding)) return std::nullopt;
  const Eigen::Quaterniond q(std::sqrt(std::max(rest, 0.0)), fields.quaternion[0], fields.quaternion[1],
                             fields.quaternion[2]);
  if (fields.pixdim[0] < 0.0) voxel[2] = -voxel[2];
  const Placement placement{q.normalized().toRotationMatrix() * voxel.asDiagonal(), unit * fields.qoffset};
  return is_usable(placement) ? std::optional(placement) : std::nullopt;
}

/// The largest distance between the two places of a node, in mm: it is that of a corner.
double distance_between(const Placement& a, const Placement& b, const NiftiFields& fields) {
  double largest = 0.0;
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    Eigen::Vector3d node;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_last = ((corner >> axis) & 1) != 0;
      node[axis] = is_last ? static_cast<double>(fields.size(static_cast<std::size_t>(axis)) - 1) : 0.0;
    }
    largest = std::max(largest, ((a.steps - b.steps) * node + a.origin - b.origin).norm());
  }
  return largest;
}

/// True if one of the lengths differs from the voxel's by more than a hundredth. An axis with a single node has no
/// step.
bool has_other_steps(const Placement& placement, const Eigen::Vector3d& voxel, const NiftiFields& fields) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = placement.steps.col(axis).norm();
    const bool is_stated = fields.size(static_cast<std::size_t>(axis)) > 1 && voxel[axis] > 0.0;
    if (is_stated && std::abs(length - voxel[axis]) > 0.01 * voxel[axis]) return true;
  }
  return false;
}

std::string size_text(const Eigen::Vector3d& voxel) {
  return fmt::format("{:.6g} × {:.6g} × {:.6g} mm", voxel[0], voxel[1], voxel[2]);
}

/// Two sentences in a header about the same voxels: says which of them is taken.
Placement settled(const Placement& sform, const std::optional<Placement>& qform, const Eigen::Vector3d& voxel,
                  const NiftiFields& fields, const std::filesystem::path& path, std::vector<std::string>& notes) {
  if (has_other_steps(sform, voxel, fields)) {
    // A program that resamples may forget one of them; two that agree are more likely than the third.
    notes.push_back(fmt::format("{}: its sform states voxels of {}, but its pixdim{} of {}; the {} is taken",
                                path.string(), size_text(sform.steps.colwise().norm()), qform ? " and qform" : "",
                                size_text(voxel), qform ? "qform" : "sform"));
    return qform.value_or(sform);
  }
  if (!qform) return sform;
  // A tenth of a voxel: much more than the rounding of the header's numbers makes, and less than anyone can see.
  const double distance = distance_between(sform, *qform, fields);
  if (distance > 0.1 * sform.steps.colwise().norm().minCoeff()) {
    notes.push_back(
        fmt::format("{}: its sform and its qform place it differently, by up to {:.4g} mm; the sform is taken",
                    path.string(), distance));
  }
  return sform;
}

Placement placement_of(const NiftiFields& fields, double unit, const Eigen::Vector3d& voxel,
                       const std::filesystem::path& path, std::vector<std::string>& notes) {
  Placement unplaced{voxel.asDiagonal(), Eigen::Vector3d::Zero(), false};
  if (fields.kind == NiftiKind::analyze) {
    notes.push_back(path.string() +
                    ": it is an ANALYZE 7.5 file, which states neither where it lies nor which side is left; its first "
                    "node is put at the origin, and the mesh may be a mirror image");
    return unplaced;
  }
  const std::optional<Placement> sform = by_sform(fields, unit, voxel);
  const std::optional<Placement> qform = by_qform(fields, unit, voxel);
  if (sform) return settled(*sform, qform, voxel, fields, path, notes);
  if (fields.sform > 0) {
    notes.push_back(fmt::format("{}: its sform is zero or damaged; {}", path.string(),
                                qform ? "the qform is taken" : "the size of its voxels is taken, without a place"));
  } else if (fields.qform > 0 && !qform) {
    notes.push_back(path.string() + ": its qform is damaged; the size of its voxels is taken, without a place");
  }
  if (qform) return *qform;
  if (std::any_of(&fields.pixdim[1], &fields.pixdim[4], [](double length) { return length < 0.0; })) {
    notes.push_back(path.string() +
                    ": it states a voxel of negative size, whose sign is ignored; the mesh may be a mirror image");
  }
  return unplaced;
}

/// An axis with a single node needs a step, too: where none is stated, it is the largest of the others.
void complete_slice(Eigen::Vector3d& voxel, const NiftiFields& fields) {
  for (int axis = 0; axis < 3; ++axis) {
    if (fields.size(static_cast<std::size_t>(axis)) == 1 && voxel[axis] == 0.0) voxel[axis] = voxel.maxCoeff();
  }
}

}  // namespace

Lattice nifti_lattice(const NiftiFields& fields, const std::filesystem::path& path, std::vector<std::string>& notes) {
  const double unit = unit_of(fields, path, notes);
  Eigen::Vector3d voxel = voxel_of(fields, unit);
  complete_slice(voxel, fields);
  const Placement placement = placement_of(fields, unit, voxel, path, notes);
  return make_lattice(path, {fields.size(0), fields.size(1), fields.size(2)}, placement.steps.colwise().norm(),
                      placement.steps, placement.origin, placement.is_known ? "RAS" : "");
}

}  // namespace isobench
