#include "isobench/methods/particles/pipeline.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench {
namespace {

struct Choice {
  std::string stage;
  std::string name;
};

SizingRequest adaptive() {
  SizingRequest request;
  request.epsilon = 0.5;
  request.delta = 0.3;
  return request;
}

TriangleMesh mesh_by(const std::string& preset, const std::vector<Choice>& choices, Monitor& monitor,
                     const std::string& name = "torus", int nodes = 40, const SizingRequest& request = adaptive()) {
  const Isosurface surface(sample_phantom(phantom(name), nodes), 0.0);
  const Method& chosen = method(preset);
  Parameters parameters(chosen.parameters);
  for (const Choice& choice : choices) parameters.set_text(chosen.parameters, choice.stage, choice.name);
  return chosen.mesh(MeshingTask(surface, request, parameters, 1), monitor);
}

const std::vector<Choice> published{
    {"medial_axis", "foot-points"}, {"sizing_nodes", "bounding"}, {"limiter", "iteration"}, {"seeds", "marching-cubes"},
    {"relaxation", "gauss-seidel"}, {"surface", "tight-cocone"},  {"finish", "0"},          {"critical_floor", "100"}};
const std::vector<Choice> ours{{"medial_axis", "shrinking-balls"}, {"sizing_nodes", "projected"},
                               {"limiter", "fast-iterative"},      {"seeds", "elimination"},
                               {"relaxation", "newton"},           {"surface", "labelled-delaunay"},
                               {"critical_floor", "0.02"},         {"finish", "3"}};

TEST(ParticlePresets, AreOnePipelineWithOtherDefaults) {
  Monitor monitor;
  EXPECT_EQ(checksum(mesh_by("particles", published, monitor)), checksum(mesh_by("particles-2007", {}, monitor)));
  EXPECT_EQ(checksum(mesh_by("particles-2007", ours, monitor)), checksum(mesh_by("particles", {}, monitor)));
}

TEST(ParticlePresets, MeshClosedWhicheverStageIsExchanged) {
  Monitor own;
  mesh_by("particles", {}, own);
  const double usual = own.counters().at("particles/count");
  for (const auto& [preset, others] : {std::pair{"particles", published}, std::pair{"particles-2007", ours}}) {
    for (const Choice& choice : others) {
      Monitor monitor;
      const MeshFacts facts = mesh_facts(mesh_by(preset, {choice}, monitor));
      EXPECT_EQ(facts.open_edges, 0U) << preset << " with " << choice.name;
      EXPECT_EQ(facts.euler, 0) << preset << " with " << choice.name;
      EXPECT_EQ(facts.components, 1U) << preset << " with " << choice.name;
      // The sizing decides how many particles there are, whatever they start from. Population control leaves up to 1.3
      // times the ideal number, and at this resolution `bounding` nodes ask for half as many again.
      EXPECT_GT(monitor.counters().at("particles/count"), 0.8 * usual) << preset << " with " << choice.name;
      EXPECT_LT(monitor.counters().at("particles/count"), 2.0 * usual) << preset << " with " << choice.name;
    }
  }
}

// Changes one stage at a time, on a phantom where it matters: F has a saddle close to its surface only where two
// spheres nearly touch. `surface` is left out, because on phantoms the cocone gives nearly the same facets as the
// labels.
TEST(ParticlePresets, EveryStageChangesTheMesh) {
  Monitor monitor;
  const std::map<std::string, TriangleMesh> bases{
      {"two-spheres", mesh_by("particles", {}, monitor, "two-spheres", 64)},
      {"near-spheres", mesh_by("particles", {}, monitor, "near-spheres", 64)}};
  for (const Choice& choice : published) {
    if (choice.stage == "surface") continue;
    const std::string name = choice.stage == "critical_floor" ? "near-spheres" : "two-spheres";
    const TriangleMesh other = mesh_by("particles", {choice}, monitor, name, 64);
    EXPECT_NE(checksum(bases.at(name)), checksum(other)) << choice.stage << " = " << choice.name;
  }
}

// Without rounds of the newton relaxation, the limits of population control act in the cure only.
TEST(ParticlePresets, PopulationLimitsReachTheCure) {
  SizingRequest request;
  request.edge_length = 2.0;
  const auto mesh_with = [&](const Choice& choice) {
    Monitor monitor;
    const TriangleMesh mesh = mesh_by("particles", {{"rounds", "0"}, choice}, monitor, "near-spheres", 64, request);
    EXPECT_GT(monitor.counters().at("cure/relaxations"), 0.0) << "the cure has nothing to relax";
    return checksum(mesh);
  };
  const std::string usual = mesh_with({"split_below", "0.6"});
  EXPECT_NE(usual, mesh_with({"split_below", "0.9"}));
  EXPECT_NE(usual, mesh_with({"delete_above", "1.1"}));
}

TEST(Particles2007, MeshesPhantomsClosedWithTheRightTopology) {
  for (const char* name : {"sphere", "torus", "ellipsoid", "slab", "two-spheres", "capsule", "rounded-box"}) {
    Monitor monitor;
    const MeshFacts facts = mesh_facts(mesh_by("particles-2007", {}, monitor, name, 48));
    EXPECT_EQ(facts.open_edges, 0U) << name;
    EXPECT_EQ(facts.nonmanifold_edges, 0U) << name;
    EXPECT_EQ(facts.euler, phantom(name).euler) << name;
    EXPECT_EQ(facts.components, static_cast<std::size_t>(phantom(name).components)) << name;
    EXPECT_GT(facts.volume, 0.0) << name;
  }
}

TEST(Particles2007, LeavesTracesAndArtefacts) {
  Monitor monitor;
  monitor.keep_artefacts(true);
  const TriangleMesh mesh = mesh_by("particles-2007", {}, monitor);
  const auto& traces = monitor.traces();
  ASSERT_GT(traces.at("energy").size(), 10U);
  EXPECT_EQ(traces.at("moves").size(), traces.at("energy").size());
  EXPECT_LE(traces.at("particles").size(), monitor.counters().at("particles/rounds"));
  EXPECT_EQ(monitor.artefacts().size(), 5U);
  const Artefact& particles = monitor.artefacts().at("particles");
  EXPECT_EQ(static_cast<double>(particles.points.size()), monitor.counters().at("particles/count"));
  EXPECT_EQ(particles.data.at("h").size(), particles.points.size());
  EXPECT_EQ(particles.data.at("energy").size(), particles.points.size());
}

TEST(Particles2007, IsTheSameForAnyNumberOfThreads) {
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Monitor monitor;
    return mesh_by("particles-2007", {}, monitor);
  };
  const TriangleMesh one = with_threads(1);
  EXPECT_EQ(checksum(one), checksum(with_threads(4)));
}

}  // namespace
}  // namespace isobench
