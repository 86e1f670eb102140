#include "isobench/experiments/runner/estimate.h"

#include <gtest/gtest.h>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

struct Sphere {
  explicit Sphere(const SizingRequest& sizing)
      : dataset(load_dataset("sphere", monitor)),
        task(*dataset.surface, sizing, Parameters(method("particles").parameters), 1, dataset.topology) {}

  Estimate expected() { return estimate(task, method("particles"), *task.sizing_field(monitor), monitor); }

  Monitor monitor;
  Dataset dataset;
  MeshingTask task;
};

std::string refusal(const Estimate& estimate, const MeshingTask& task, std::optional<double> most = std::nullopt) {
  try {
    refuse_if_too_large(estimate, task, most);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Estimate, IsNearTheNumberOfVerticesThatTheMeshGets) {
  SizingRequest uniform;
  uniform.edge_length = 2.0;
  SizingRequest adaptive;
  adaptive.epsilon = 0.5;
  adaptive.delta = 0.3;
  for (const SizingRequest& sizing : {uniform, adaptive}) {
    Sphere sphere(sizing);
    const auto made = method("particles").mesh(sphere.task, sphere.monitor).vertices.size();
    const Estimate expected = sphere.expected();
    EXPECT_NEAR(expected.vertices, static_cast<double>(made), 0.2 * static_cast<double>(made));
    EXPECT_GT(*expected.seconds, 0.0);
    EXPECT_GT(expected.bytes, 0.0);
  }
}

TEST(Estimate, RefusesWhatTheMachineOrTheUserDoesNotAllow) {
  SizingRequest sizing;
  sizing.edge_length = 1e-5;  // someone takes micrometres for millimetres
  Sphere sphere(sizing);
  const std::string too_large = refusal(sphere.expected(), sphere.task);
  EXPECT_NE(too_large.find("of memory are free; ask for longer edges (voxels are "), std::string::npos) << too_large;
  SizingRequest hundred;
  hundred.vertices = 100.0;
  Sphere small(hundred);
  EXPECT_EQ(refusal(small.expected(), small.task), "");
  EXPECT_EQ(refusal(small.expected(), small.task, 100.0), "");
  const std::string more = refusal(small.expected(), small.task, 99.0);
  EXPECT_EQ(more.find("this sizing asks for about 100 vertices, "), 0U) << more;
  EXPECT_NE(more.find("more than --max-vertices 99; "), std::string::npos) << more;
}

TEST(Estimate, IsSaidWithTwoDigits) {
  EXPECT_EQ(to_string({.vertices = 641.0, .seconds = std::nullopt, .bytes = 12.3e6}), "about 640 vertices, 12 MB");
  EXPECT_EQ(to_string({.vertices = 49321.0, .seconds = 3.52, .bytes = 2.46e9}),
            "about 49,000 vertices, 3.5 s on two cores, 2.5 GB");
  EXPECT_EQ(to_string({.vertices = 2.14e8, .seconds = std::nullopt, .bytes = 270e9}),
            "about 210 million vertices, 270.0 GB");
  EXPECT_EQ(to_string({.vertices = 1e7, .seconds = 700.0, .bytes = 13e9}),
            "about 10 million vertices, 12 minutes on two cores, 13.0 GB");
  EXPECT_EQ(to_string({.vertices = 2.3e8, .seconds = 16200.0, .bytes = 303.9e9}),
            "about 230 million vertices, 4.5 hours on two cores, 303.9 GB");
}

}  // namespace
}  // namespace isobench
