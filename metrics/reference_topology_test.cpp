#include "metrics/reference_topology.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "metrics/kuhn_topology.h"
#include "metrics/sign_lattice.h"
#include "metrics/topology.h"

namespace isobench {

namespace {

/// Samples of `function` (positive inside) at the nodes of a lattice of `size` nodes of anisotropic spacing.
template <class Function>
Isosurface sampled(std::array<int, 3> size, Function function, Kernel kernel = Kernel::bspline) {
  Volume volume;
  volume.lattice.size = size;
  volume.lattice.spacing = {1.0, 0.8, 1.3};
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const Eigen::Vector3d x = volume.lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
        volume.samples.push_back(static_cast<float>(function(x)));
      }
    }
  }
  return {std::move(volume), 0.0, Inside::above, kernel};
}

const Eigen::Vector3d middle(20.0, 16.0, 26.0);
constexpr std::array<int, 3> size{41, 41, 41};

double ball(const Eigen::Vector3d& x, const Eigen::Vector3d& centre, double radius) {
  return radius - (x - centre).norm();
}

void expect_topology(const Isosurface& surface, long euler, std::size_t components) {
  for (const int k : {1, 2, 3}) {
    Monitor monitor;
    const ReferenceTopology topology = reference_topology(surface, k, monitor);
    EXPECT_EQ(topology.k, k);
    EXPECT_EQ(topology.euler, euler) << "k = " << k;
    EXPECT_EQ(topology.components, components) << "k = " << k;
  }
}

TEST(ReferenceTopology, Sphere) {
  expect_topology(sampled(size, [](const auto& x) { return ball(x, middle, 11.0); }), 2, 1);
  expect_topology(sampled(
                      size, [](const auto& x) { return ball(x, middle, 11.0); }, Kernel::catmull_rom),
                  2, 1);
}

TEST(ReferenceTopology, Torus) {
  const auto torus = [](const Eigen::Vector3d& x) {
    const Eigen::Vector3d p = x - middle;
    return 4.0 - std::hypot(std::hypot(p.x(), p.y()) - 8.0, p.z());
  };
  expect_topology(sampled(size, torus), 0, 1);
}

TEST(ReferenceTopology, TwoSpheres) {
  const Eigen::Vector3d shift(0.0, 0.0, 12.0);
  expect_topology(
      sampled(size,
              [&](const auto& x) { return std::max(ball(x, middle - shift, 8.0), ball(x, middle + shift, 8.0)); }),
      4, 2);
}

TEST(ReferenceTopology, HollowSphere) {
  const auto hollow = [](const Eigen::Vector3d& x) { return std::min(ball(x, middle, 12.0), -ball(x, middle, 6.0)); };
  expect_topology(sampled(size, hollow), 4, 2);
}

TEST(ReferenceTopology, AnObjectThatLeavesTheLatticeIsClosedThere) {
  expect_topology(sampled(size, [](const auto& x) { return 16.0 - x.y(); }), 2, 1);
}

/// One triangulated polygon for each bichromatic tetrahedron, its corners the midpoints of bichromatic edges: the
/// surface whose topology is counted, built the long way.
TriangleMesh kuhn_surface(const SignLattice& signs) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;  // by the sum of the edge's ends
  using Node = std::array<int, 3>;
  const auto corner = [&](const Node& a, const Node& b) {
    const Node sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const auto [found, is_new] = numbers.try_emplace(sum, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(0.5 * Eigen::Vector3d(sum[0], sum[1], sum[2]));
    return found->second;
  };
  const auto [nx, ny, nz] = signs.size();
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int z = 0; z + 1 < nz; ++z) {
      for (int y = 0; y + 1 < ny; ++y) {
        for (int x = 0; x + 1 < nx; ++x) {
          std::vector<Node> in;
          std::vector<Node> out;
          Node node{x, y, z};
          for (int step = 0; step < 4; ++step) {
            (signs.inside(node[0], node[1], node[2]) ? in : out).push_back(node);
            if (step < 3) ++node[static_cast<std::size_t>(axes[static_cast<std::size_t>(step)])];
          }
          if (in.empty() || out.empty()) continue;
          if (in.size() == 1 || out.size() == 1) {
            Triangle triangle{};
            for (std::size_t i = 0; i < 3; ++i) {
              triangle[i] = corner(in[in.size() == 1 ? 0 : i], out[out.size() == 1 ? 0 : i]);
            }
            mesh.triangles.push_back(triangle);
          } else {
            mesh.triangles.push_back({corner(in[0], out[0]), corner(in[0], out[1]), corner(in[1], out[1])});
            mesh.triangles.push_back({corner(in[0], out[0]), corner(in[1], out[1]), corner(in[1], out[0])});
          }
        }
      }
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return mesh;
}

TEST(KuhnTopology, NoiseAgreesWithTheSurfaceBuiltFromTetrahedra) {
  std::mt19937 random(3);
  for (const int size_x : {20, 63, 64, 65}) {
    for (const double share : {0.1, 0.4, 0.6}) {
      SignLattice signs({size_x, 12, 35});
      std::bernoulli_distribution inside(share);
      for (int z = 1; z < 34; ++z) {
        for (int y = 1; y < 11; ++y) {
          for (int x = 1; x + 1 < size_x; ++x) {
            if (inside(random)) signs.set_inside(x, y, z);
          }
        }
      }
      Monitor monitor;
      const TopologyFigures built = measure_connectivity(kuhn_surface(signs));
      EXPECT_EQ(built.boundary_edges + built.nonmanifold_edges + built.nonmanifold_vertices, 0U);
      EXPECT_EQ(kuhn_euler(signs, monitor), built.euler) << size_x << " nodes along x, " << share << " inside";
      EXPECT_EQ(kuhn_components(signs, monitor), built.components)
          << size_x << " nodes along x, " << share << " inside";
    }
  }
}

TEST(SignLattice, SignsAreThoseOfTheSurfacesOwnFunction) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  for (const Kernel kernel : {Kernel::bspline, Kernel::catmull_rom}) {
    const Isosurface surface = sampled(
        {23, 12, 9}, [&](const auto&) { return noise(random); }, kernel);
    for (const int k : {1, 3}) {
      Monitor monitor;
      const SignLattice signs = refined_signs(surface, k, monitor);
      ASSERT_EQ(signs.size(), (std::array<int, 3>{22 * k + 1, 11 * k + 1, 8 * k + 1}));
      const auto [nx, ny, nz] = signs.size();
      for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
          for (int x = 0; x < nx; ++x) {
            const bool border = std::min({x, y, z, nx - 1 - x, ny - 1 - y, nz - 1 - z}) < 2;
            const Eigen::Vector3d at = surface.lattice().spacing.cwiseProduct(Eigen::Vector3d(x, y, z)) / k;
            const double value = surface.value(at);
            // Within rounding of zero either sign is right.
            if (!border && std::abs(value) < 1e-12) continue;
            ASSERT_EQ(signs.inside(x, y, z), !border && value > 0.0) << x << ' ' << y << ' ' << z << ", k = " << k;
          }
        }
      }
    }
  }
}

TEST(ReferenceTopology, DoesNotDependOnThreads) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  const Isosurface surface = sampled({40, 40, 70}, [&](const auto&) { return noise(random); });
  Monitor monitor;
  const ReferenceTopology topology = reference_topology(surface, 2, monitor);
  EXPECT_GT(topology.components, 50U);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const ReferenceTopology again = reference_topology(surface, 2, monitor);
    EXPECT_EQ(again.euler, topology.euler);
    EXPECT_EQ(again.components, topology.components);
  }
}

TEST(ReferenceTopology, StopsWhenCancelled) {
  const Isosurface surface = sampled(size, [](const auto& x) { return ball(x, middle, 11.0); });
  Monitor monitor;
  monitor.cancel();
  EXPECT_ANY_THROW(reference_topology(surface, 1, monitor));
}

}  // namespace

}  // namespace isobench
