#include "isobench/datasets/topology/surface_boxes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace isobench {

namespace {

double squared_distance(const CellBox& box, const Eigen::Vector3d& x) {
  return (x - x.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

}  // namespace

/// A node of a cell's tree, and the box that it stands for.
struct SurfaceBoxes::Tree {
  std::size_t layer;
  std::uint32_t node;
  int depth;
  CellBox box;
};

SurfaceBoxes::SurfaceBoxes(const Lattice& lattice, double cut_at, std::vector<CellLayer> layers,
                           std::vector<std::uint32_t> component)
    : cells_{lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1},
      spacing_(lattice.spacing),
      cut_at_(cut_at),
      layers_(std::move(layers)),
      component_(std::move(component)) {
  std::size_t first = 0;
  for (const CellLayer& layer : layers_) {
    first_disc_.push_back(first);
    first += layer.discs;
  }
}

std::optional<SurfaceBoxes::Tree> SurfaceBoxes::tree_of(const std::array<int, 3>& cell) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell[axis] < 0 || cell[axis] >= cells_[axis]) return std::nullopt;
  }
  const auto layer = static_cast<std::size_t>(cell[2]);
  const std::vector<std::uint32_t>& cells = layers_[layer].cells;
  const auto number = static_cast<std::uint32_t>(cell[0] + cell[1] * cells_[0]);
  const auto found = std::lower_bound(cells.begin(), cells.end(), number);
  if (found == cells.end() || *found != number) return std::nullopt;
  const Eigen::Vector3d low = spacing_.cwiseProduct(Eigen::Vector3d(cell[0], cell[1], cell[2]));
  return Tree{layer, layers_[layer].roots[static_cast<std::size_t>(found - cells.begin())], 0, {low, low + spacing_}};
}

/// Calls visit.enters(box) for each box and goes on to its parts if that returns true; calls visit.disc(box) for those
/// with a disc.
template <class Visit>
void SurfaceBoxes::descend(const Tree& tree, const Visit& visit) const {
  if (!visit.enters(tree.box)) return;
  const TreeNode& node = layers_[tree.layer].nodes[tree.node];
  if (!node.is_cut) {
    if (node.kind != BoxKind::disc) return;
    visit.disc(SurfaceBox{tree.box, tree.depth, component_[first_disc_[tree.layer] + node.next]});
    return;
  }
  const Eigen::Vector3d middle = (1.0 - cut_at_) * tree.box.low + cut_at_ * tree.box.high;
  for (std::uint32_t part = 0; part < 8; ++part) {
    Tree next{tree.layer, node.next + part, tree.depth + 1, tree.box};
    for (unsigned axis = 0; axis < 3; ++axis)
      ((part >> axis & 1U) != 0 ? next.box.low : next.box.high)[axis] = middle[axis];
    descend(next, visit);
  }
}

std::optional<std::uint32_t> SurfaceBoxes::component_at(const Eigen::Vector3d& x) const {
  struct Nearest {
    const Eigen::Vector3d& x;
    double& distance;
    std::optional<std::uint32_t>& component;
    bool enters(const CellBox& box) const { return squared_distance(box, x) < distance; }
    void disc(const SurfaceBox& box) const {
      distance = squared_distance(box.box, x);
      component = box.component;
    }
  };
  double distance = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> component;
  const Nearest nearest{x, distance, component};
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto coordinate = static_cast<Eigen::Index>(axis);
    const double at = std::clamp(x[coordinate] / spacing_[coordinate], 0.0, static_cast<double>(cells_[axis]));
    cell[axis] = std::min(static_cast<int>(at), cells_[axis] - 1);
  }
  if (const auto own = tree_of(cell)) descend(*own, nearest);
  if (distance == 0.0) return component;
  for (int n = 0; n < 27; ++n) {
    const auto next = tree_of({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
    if (next && n != 13) descend(*next, nearest);
  }
  return component;
}

void SurfaceBoxes::for_each(const std::function<void(const SurfaceBox&)>& visit) const {
  struct All {
    const std::function<void(const SurfaceBox&)>& visit;
    bool enters(const CellBox& /*box*/) const { return true; }
    void disc(const SurfaceBox& box) const { visit(box); }
  };
  for (int k = 0; k < cells_[2]; ++k) {
    for (const std::uint32_t number : layers_[static_cast<std::size_t>(k)].cells) {
      const int i = static_cast<int>(number) % cells_[0];
      const int j = static_cast<int>(number) / cells_[0];
      descend(*tree_of({i, j, k}), All{visit});
    }
  }
}

}  // namespace isobench
