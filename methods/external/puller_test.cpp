// Reads the worked examples from README.md and runs one of them.
#include <gtest/gtest.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/toml.h"
#include "isobench/methods/external/program.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

/// The parameters of every [[method]] in README.md, by label.
std::map<std::string, Parameters> examples() {
  const std::string text = read_text(ISOBENCH_EXTERNAL_README);
  const ParameterSchema& schema = method("external").parameters;
  std::map<std::string, Parameters> found;
  for (std::size_t at = text.find("```toml\n"); at != std::string::npos; at = text.find("```toml\n", at + 1)) {
    const std::size_t begin = at + 8;
    const TomlValue document = TomlValue::parse_text(text.substr(begin, text.find("```", begin) - begin), "README.md");
    for (const TomlValue& table : document.require("method").as_array()) {
      Parameters parameters(schema);
      for (const std::string& key : table.keys()) {
        if (key == "name" || key == "label") continue;
        const TomlValue value = table.require(key);
        const ParameterValue given = value.is_bool() ? ParameterValue(value.as_bool()) : value.as_string();
        parameters.set(schema, key, given, value.place());
      }
      found.emplace(table.require("label").as_string(), parameters);
    }
  }
  return found;
}

TEST(Puller, TheExamplesOfThePageAreValid) {
  const std::map<std::string, Parameters> all = examples();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at("mesher").text("values"), "nodes");
  EXPECT_TRUE(all.at("remesher").flag("project"));
}

TEST(Puller, MeshesThePhantomAsThePageSays) {
  if (!has_program("teem-puller")) GTEST_SKIP() << "teem-puller is not installed (package teem-apps)";
  const Phantom p = phantom("torus");
  const Isosurface surface(sample_phantom(p, 48), 0.0);
  SizingRequest request;
  request.vertices = 1500;
  Monitor monitor;
  const TriangleMesh mesh = method("external").mesh(MeshingTask(surface, request, examples().at("puller"), 1), monitor);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.euler, 0);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  // The puller drops particles that do not reach the surface.
  EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 1500.0, 150.0);
  for (const Eigen::Vector3d& x : mesh.vertices) {
    const Jet jet = surface.value_gradient(x);
    // The puller stops within a ten-thousandth of a voxel of the surface; ten times that leaves room for its last
    // steps.
    ASSERT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-3 * surface.voxel());
  }
}

}  // namespace
}  // namespace isobench
