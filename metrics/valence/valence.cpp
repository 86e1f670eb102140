#include "isobench/metrics/valence/valence.h"

namespace isobench {

std::vector<int> valences(const TriangleMesh& mesh, const MeshEdges& edges) {
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (const std::array<std::uint32_t, 2>& ends : edges.ends) {
    ++valence[ends[0]];
    ++valence[ends[1]];
  }
  return valence;
}

ValenceFigures summarize_valences(const std::vector<int>& valences) {
  ValenceFigures figures;
  std::size_t used = 0;
  for (const int valence : valences) {
    if (valence == 0) {
      ++figures.unused_vertices;
      continue;
    }
    ++used;
    const auto v = static_cast<std::size_t>(valence);
    if (figures.counts.size() <= v) figures.counts.resize(v + 1, 0);
    ++figures.counts[v];
  }
  if (used == 0) return figures;
  std::size_t below = 0;
  std::size_t above = 0;
  for (std::size_t v = 0; v < figures.counts.size(); ++v) {
    if (v < 5) below += figures.counts[v];
    if (v > 7) above += figures.counts[v];
  }
  const auto count = [&](std::size_t v) { return v < figures.counts.size() ? figures.counts[v] : 0; };
  const auto percent = [&](std::size_t n) { return 100.0 * static_cast<double>(n) / static_cast<double>(used); };
  figures.lt5_percent = percent(below);
  figures.v5_percent = percent(count(5));
  figures.v6_percent = percent(count(6));
  figures.v7_percent = percent(count(7));
  figures.gt7_percent = percent(above);
  figures.extreme_count = below + above;
  return figures;
}

}  // namespace isobench
