#include "isobench/metrics/reference_topology/reference_topology.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "isobench/metrics/reference_topology/kuhn_topology.h"
#include "isobench/metrics/reference_topology/sign_lattice.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

/// Samples of `function` (positive inside) at the nodes of a lattice of `size` nodes of anisotropic spacing.
template <class Function>
Isosurface sampled(std::array<int, 3> size, Function function, Kernel kernel = Kernel::bspline) {
  FloatVolume volume;
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

/// Noise with an outside layer all round, less of it inside than out.
SignLattice noise(std::array<int, 3> nodes, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution inside(0.4);
  SignLattice signs(nodes);
  for (int z = 1; z < nodes[2] - 1; ++z) {
    for (int y = 1; y < nodes[1] - 1; ++y) {
      for (int x = 1; x < nodes[0] - 1; ++x) {
        if (inside(random)) signs.set_inside(x, y, z);
      }
    }
  }
  return signs;
}

SignLattice cut_out(const SignLattice& signs, const NodeBox& box) {
  SignLattice part({box.high[0] - box.low[0] + 1, box.high[1] - box.low[1] + 1, box.high[2] - box.low[2] + 1});
  for (int z = 0; z < part.size()[2]; ++z) {
    for (int y = 0; y < part.size()[1]; ++y) {
      for (int x = 0; x < part.size()[0]; ++x) {
        if (signs.inside(box.low[0] + x, box.low[1] + y, box.low[2] + z)) part.set_inside(x, y, z);
      }
    }
  }
  return part;
}

TEST(KuhnTopology, WhatABoxAddsIsWhatChangesWithIt) {
  const SignLattice signs = noise({30, 24, 27}, 4);
  Monitor monitor;
  EXPECT_EQ(2 * kuhn_euler_within(signs), kuhn_euler(signs, monitor));
  // Other noise strictly within a box.
  const NodeBox box{{5, 7, 6}, {21, 19, 25}};
  const SignLattice others = noise({30, 24, 27}, 5);
  SignLattice changed(signs.size());
  for (int z = 0; z < 27; ++z) {
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 30; ++x) {
        const bool within = 5 < x && x < 21 && 7 < y && y < 19 && 6 < z && z < 25;
        if ((within ? others : signs).inside(x, y, z)) changed.set_inside(x, y, z);
      }
    }
  }
  const long difference = kuhn_euler(changed, monitor) - kuhn_euler(signs, monitor);
  EXPECT_NE(difference, 0);
  EXPECT_EQ(2 * (kuhn_euler_within(cut_out(changed, box)) - kuhn_euler_within(cut_out(signs, box))), difference);
}

TEST(KuhnTopology, RegionsAroundAHoleJoinedThroughItAreThoseOfTheWhole) {
  for (const unsigned seed : {6U, 7U, 8U}) {
    const SignLattice signs = noise({70, 24, 27}, seed);
    Monitor monitor;
    const NodeBox box{{5, 7, 6}, {66, 19, 25}};
    KuhnRegions around(signs, {box}, monitor);
    KuhnRegions part(cut_out(signs, box), {}, monitor);
    std::map<std::uint32_t, std::uint32_t> met;
    for (int z = 6; z <= 25; ++z) {
      for (int y = 7; y <= 19; ++y) {
        for (int x = 5; x <= 66; ++x) {
          if (5 < x && x < 66 && 7 < y && y < 19 && 6 < z && z < 25) continue;
          const auto [known, is_new] = met.try_emplace(part.region_of(x - 5, y - 7, z - 6), around.run_of(x, y, z));
          if (!is_new) around.unite(known->second, around.run_of(x, y, z));
        }
      }
    }
    EXPECT_EQ(around.regions().size() + part.regions().size() - met.size() - 1, kuhn_components(signs, monitor));
  }
}

/// Two bodies, joined by a bridge of some hundredths of a voxel or separated by a gap of that size.
Isosurface dumb_bell(double off) {
  const Eigen::Vector3d a(13.2, 16.4, 19.7);
  const Eigen::Vector3d b(26.1, 16.4, 19.7);
  const auto f = [&](const Eigen::Vector3d& x) {
    return std::exp(-(x - a).squaredNorm() / 30.0) + std::exp(-(x - b).squaredNorm() / 30.0);
  };
  const double between = f(0.5 * (a + b)) + off;
  return sampled(
      size, [&](const Eigen::Vector3d& x) { return f(x) - between; }, Kernel::interpolating_bspline);
}

TEST(ReferenceTopology, TellsABridgeFromAGapThatNoNodeShows) {
  Monitor monitor;
  for (const int k : {1, 2, 3}) {
    const ReferenceTopology joined = reference_topology(dumb_bell(-0.0005), k, monitor);
    EXPECT_EQ(joined.euler, 2) << "k = " << k;
    EXPECT_EQ(joined.components, 1U) << "k = " << k;
    const ReferenceTopology parted = reference_topology(dumb_bell(0.0005), k, monitor);
    EXPECT_EQ(parted.euler, 4) << "k = " << k;
    EXPECT_EQ(parted.components, 2U) << "k = " << k;
  }
  // The plain count does not tell them apart.
  EXPECT_EQ(lattice_topology(dumb_bell(-0.0005), 3, monitor).euler,
            lattice_topology(dumb_bell(0.0005), 3, monitor).euler);
}

TEST(SignLattice, OfABoxAreThoseOfTheWhole) {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> noise_of(-1.0, 1.0);
  const Isosurface surface = sampled({13, 12, 9}, [&](const auto&) { return noise_of(random); });
  Monitor monitor;
  const SignLattice all = refined_signs(surface, 6, monitor);
  for (const NodeBox& box :
       {NodeBox{{3, 4, 2}, {7, 6, 5}}, NodeBox{{0, 0, 0}, {12, 11, 8}}, NodeBox{{9, 0, 3}, {12, 2, 8}}}) {
    const SignLattice part = refined_signs(surface, box, 6, 1, monitor);
    const auto [nx, ny, nz] = part.size();
    ASSERT_EQ(nx, 6 * (box.high[0] - box.low[0]) + 1);
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
          ASSERT_EQ(part.inside(x, y, z), all.inside(6 * box.low[0] + x, 6 * box.low[1] + y, 6 * box.low[2] + z));
      }
    }
  }
  // The border of a lattice refined three times more than that of k = 2 is as thick as there.
  const SignLattice coarse = refined_signs(surface, 2, monitor);
  const SignLattice fine = refined_signs(surface, NodeBox{{0, 0, 0}, {12, 11, 8}}, 2, 3, monitor);
  for (int z = 0; z < coarse.size()[2]; ++z) {
    for (int y = 0; y < coarse.size()[1]; ++y) {
      for (int x = 0; x < coarse.size()[0]; ++x) EXPECT_EQ(coarse.inside(x, y, z), fine.inside(3 * x, 3 * y, 3 * z));
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
  const Isosurface surface = sampled({20, 20, 36}, [&](const auto&) { return noise(random); });
  Monitor monitor;
  const ReferenceTopology topology = reference_topology(surface, 2, monitor);
  EXPECT_GT(topology.components, 10U);
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
