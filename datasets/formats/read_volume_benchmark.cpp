// What reading costs beside the least that it can cost: `times` is the time over that of copying the file's bytes into
// memory, or of inflating them, measured in the same run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/foundation/random.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

constexpr int nodes = 512;  // along each axis

/// A ball with the noise of a scanner.
const std::string& samples() {
  static const std::string bytes = [] {
    std::string result;
    result.reserve(std::size_t{2} * nodes * nodes * nodes);
    for (int k = 0; k < nodes; ++k) {
      for (int j = 0; j < nodes; ++j) {
        for (int i = 0; i < nodes; ++i) {
          const std::uint64_t n = result.size();
          const double depth = 200.0 - std::hypot(i - 255.5, j - 255.5, k - 255.5);
          const double value = std::clamp(1000.0 + 100.0 * depth, 0.0, 2000.0) + 16.0 * uniform_random(1, n, 0);
          result += bytes_of_value(static_cast<std::uint16_t>(value));
        }
      }
    }
    return result;
  }();
  return bytes;
}

std::string header(const char* encoding) {
  return fmt::format("NRRD0004\ntype: ushort\ndimension: 3\nsizes: {0} {0} {0}\nendian: little\nencoding: {1}\n\n",
                     nodes, encoding);
}

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Reads the file again and again, and does `least` before each time.
template <class Least>
void read_beside(benchmark::State& state, const std::filesystem::path& path, Least&& least) {
  double reading = 0.0;
  double least_possible = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    least_possible += seconds(least);
    const double taken = seconds([&] { benchmark::DoNotOptimize(read_volume(path)); });
    reading += taken;
    state.SetIterationTime(taken);
  }
  state.counters["times"] = reading / least_possible;
}

std::string whole_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::filesystem::file_size(path), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

void raw(benchmark::State& state) {
  const TestFolder folder;
  const auto path = folder.write("raw.nrrd", header("raw") + samples());
  read_beside(state, path, [&] { benchmark::DoNotOptimize(whole_file(path)); });
}

void gzip(benchmark::State& state) {
  const TestFolder folder;
  const std::string packed = deflated(samples(), true);
  const auto path = folder.write("gzip.nrrd", header("gzip") + packed);
  read_beside(state, path, [&] {
    std::string bytes(samples().size(), '\0');
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) std::abort();
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    if (inflate(&stream, Z_FINISH) != Z_STREAM_END) std::abort();
    inflateEnd(&stream);
    benchmark::DoNotOptimize(bytes);
  });
}

BENCHMARK(raw)->Name("ReadVolume/512 cubed, uint16, raw")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(gzip)->Name("ReadVolume/512 cubed, uint16, gzip")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace isobench
