#include "isobench/methods/particles/finish/tail.h"

#include <array>
#include <cstddef>

#include "isobench/methods/particles/mesh_edits/bad_spots.h"

namespace isobench::particles {

namespace {

/// The searches become wider. The last ones are slow, but few spots are left for them.
constexpr std::array<SearchEffort, 10> searches{
    {{3, 1, 1}, {3, 1, 1}, {4, 2, 3}, {4, 2, 3}, {5, 3, 4}, {5, 3, 4}, {6, 4, 4}, {6, 4, 4}, {7, 6, 8}, {8, 8, 12}}};

constexpr double strict_share = 0.1;  // of the budget

class Tail {
 public:
  Tail(const FinishContext& context, EditableMesh& mesh, double share, Monitor& monitor)
      : context_(context), mesh_(mesh), monitor_(monitor) {
    constexpr double moves_per_vertex = 1000.0;
    constexpr double least_moves = 2e6;
    budget_.moves = share * (least_moves + moves_per_vertex * static_cast<double>(mesh.vertex_count()));
  }

  void improve() {
    const auto stage = monitor_.stage("tail");
    const double before = budget_.moves;
    const double reserved = (1.0 - strict_share) * before;
    budget_.moves -= reserved;
    search_for(strict_goal(context_.sizing));
    budget_.moves += reserved;
    search_for(ShapeGoal{});
    monitor_.add("finish/searched moves", before - budget_.moves);
    monitor_.set("finish/places left", static_cast<double>(count_bad_spots(context_, mesh_, goal_)));
  }

 private:
  void search_for(const ShapeGoal& goal) {
    goal_ = goal;
    for (std::size_t n = 0; n < searches.size() && budget_.moves > 0.0; ++n) {
      if (count_bad_spots(context_, mesh_, goal_) == 0) return;
      if (n > 0 && searches[n].rings > searches[n - 1].rings) repeat_while_dear(searches[n - 1], searches[n]);
      search(searches[n]);
    }
  }

  /// A search may spend half of the budget, so that something is left for wider searches at the worst spots.
  std::size_t search(const SearchEffort& effort) {
    monitor_.check();
    SearchBudget half{0.5 * budget_.moves};
    budget_.moves -= half.moves;
    const std::size_t improved = improve_bad_spots(context_, mesh_, goal_, effort, half);
    budget_.moves += half.moves;
    monitor_.trace("finish/places improved", static_cast<double>(improved));
    return improved;
  }

  /// Crowded spots are treated one after another, because their submeshes overlap. The narrower search mends many of
  /// them at a small part of the cost.
  void repeat_while_dear(const SearchEffort& effort, const SearchEffort& wider) {
    constexpr int most_repeats = 20;
    for (int repeat = 0; repeat < most_repeats; ++repeat) {
      if (expected_moves(context_, mesh_, goal_, wider) <= 0.25 * budget_.moves) return;
      if (search(effort) == 0) return;
    }
  }

  const FinishContext& context_;
  EditableMesh& mesh_;
  Monitor& monitor_;
  ShapeGoal goal_;
  SearchBudget budget_;
};

}  // namespace

ShapeGoal strict_goal(const SizingField& sizing) { return {sizing.uniform() ? 0.88 : 0.87, 40.1, 83.9}; }

void improve_tail(const FinishContext& context, EditableMesh& mesh, double share, Monitor& monitor) {
  Tail(context, mesh, share, monitor).improve();
}

}  // namespace isobench::particles
