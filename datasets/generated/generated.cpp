#include "isobench/datasets/generated/generated.h"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "isobench/datasets/generated/generators.h"

namespace isobench {

namespace {

/// Raised whenever a generator gives other samples, so that no earlier result is reused.
constexpr int generator_revision = 1;

/// Turns an object above the isovalue into one below it.
void turn_over(GeneratedVolume& generated) {
  generated.volume.samples.visit([](auto& samples) {
    using T = SampleOf<decltype(samples)>;
    for (T& sample : samples) {
      if constexpr (std::is_integral_v<T>)
        sample = static_cast<T>(1 - sample);  // a mask
      else
        sample = -sample;
    }
  });
  if (generated.volume.samples.type() == SampleType::f32) generated.isovalue = -generated.isovalue;
}

GeneratedVolume generate_above(const GeneratedRequest& request, Monitor& monitor) {
  switch (request.generator) {
    case Generator::random_field: {
      RandomField random = random_field(request, monitor);
      return {std::move(random.field), random.isovalue};
    }
    case Generator::mask:
      return {random_mask(request, monitor), 0.5};
    case Generator::foam:
      return {foam(request), 0.0};
    case Generator::islands:
      break;
  }
  return {islands_volume(request), 0.0};
}

std::string own_numbers(const GeneratedRequest& request) {
  switch (request.generator) {
    case Generator::random_field:
    case Generator::mask:
      return fmt::format("correlation {} voxels, quantile {}", request.correlation, request.quantile);
    case Generator::foam:
      return fmt::format("{} bubbles, walls of {} voxels", request.bubbles, request.wall);
    case Generator::islands:
      break;
  }
  return fmt::format("{} islands, radii {} to {} voxels", request.islands, request.radii[0], request.radii[1]);
}

}  // namespace

const char* to_string(Generator generator) {
  switch (generator) {
    case Generator::random_field:
      return "random-field";
    case Generator::mask:
      return "mask";
    case Generator::foam:
      return "foam";
    case Generator::islands:
      break;
  }
  return "islands";
}

GeneratedVolume generate(const GeneratedRequest& request, Inside inside, Monitor& monitor) {
  if (inside == Inside::above) return generate_above(request, monitor);
  GeneratedRequest above = request;
  above.quantile = 1.0 - request.quantile;
  GeneratedVolume generated = generate_above(above, monitor);
  turn_over(generated);
  return generated;
}

std::string describe(const GeneratedRequest& request) {
  const auto [nx, ny, nz] = request.size;
  return fmt::format("{}, revision {}, seed {}, size {} × {} × {}, spacing {} × {} × {} mm, {}",
                     to_string(request.generator), generator_revision, request.seed, nx, ny, nz, request.spacing[0],
                     request.spacing[1], request.spacing[2], own_numbers(request));
}

}  // namespace isobench
