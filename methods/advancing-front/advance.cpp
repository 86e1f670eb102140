#include "isobench/methods/advancing-front/advance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isobench::advancing_front {

namespace {

/// A lower bound on the step at `distance` from a point with step `step`: sizing fields have a slope of at most 0.3.
double least_step(double step, double distance) { return std::max(0.1 * step, step - 0.3 * distance); }

}  // namespace

struct Advance::Rules {
  double margin;     ///< least distance between a grown triangle and fences, in steps
  double agreement;  ///< least cosine between a triangle's normal and the normals at its corners
  double reach;      ///< greatest distance of a vertex to connect to, in edge lengths
  double shrink;     ///< factor on the sides of a grown triangle
};

const Advance::Rules& Advance::rules(int n) {
  static constexpr std::array<Rules, 3> all{{{0.5, 0.5, 2.0, 1.0}, {0.35, 0.5, 3.0, 0.75}, {0.2, 0.2, 4.0, 0.6}}};
  return all[static_cast<std::size_t>(n)];
}

void Advance::add_loop(int node) {
  int n = node;
  do {
    push_grow(n, 0);
    n = front_.next(n);
  } while (n != node);
}

bool Advance::valid(const Entry& entry) const {
  const Node& node = front_.node(entry.node);
  return node.alive && node.stamp == entry.stamp;
}

std::optional<Vertex> Advance::apex_of(int node, int rules) {
  const int end = front_.next(node);
  auto apex = grown_apex(surface_, step_, front_.vertex(node), front_.vertex(end), Advance::rules(rules).shrink,
                         {gap_angle(front_, node), gap_angle(front_, end)});
  if (!apex || bounds_.contains(apex->x)) return apex;
  strayed_ = true;
  return std::nullopt;
}

void Advance::push_grow(int node, int rules) {
  if (apexes_.size() <= static_cast<std::size_t>(node)) apexes_.resize(static_cast<std::size_t>(node) + 1);
  const Vertex &a = front_.vertex(node), &b = front_.vertex(front_.next(node));
  std::optional<Vertex>& apex = apexes_[static_cast<std::size_t>(node)];
  apex = apex_of(node, rules);
  if (!apex) {
    push_connect(node, rules, 0.0);
    return;
  }
  const double key = circumradius_over_inradius({{&a, &b, &*apex}, node, -1});
  queue_.push({Kind::grow, rules, key, order_++, node, front_.node(node).stamp});
}

void Advance::push_connect(int node, int rules, double angle) {
  queue_.push({Kind::connect, rules, -angle, order_++, node, front_.node(node).stamp});
}

bool Advance::is_meshed(const Vertex& apex, int rules) const {
  // In steps: the new vertex of an equilateral triangle is 0.87 from its base edge, which lies on the meshed side.
  const double distance = 0.7 * Advance::rules(rules).shrink * apex.step;
  return front_.is_behind(apex, distance, least_step(apex.step, distance));
}

std::optional<int> Advance::vertex_at(const Vertex& apex) const {
  for (const int n : near_) {
    if ((front_.vertex(n).x - apex.x).norm() < 0.01 * apex.step) return n;
  }
  return std::nullopt;
}

void Advance::try_grow(const Entry& entry) {
  // The gaps at the edge's ends may have changed since the entry was queued.
  const Vertex apex = apex_of(entry.node, entry.rules).value_or(*apexes_[static_cast<std::size_t>(entry.node)]);
  const Vertex &a = front_.vertex(entry.node), &b = front_.vertex(front_.next(entry.node));
  Tentative t{{&a, &b, &apex}, entry.node, -1};
  const Rules& rule = rules(entry.rules);
  const double margin = rule.margin * apex.step;
  const Eigen::Vector3d centre = (a.x + b.x + apex.x) / 3.0;
  const double radius = std::sqrt(
      std::max({(a.x - centre).squaredNorm(), (b.x - centre).squaredNorm(), (apex.x - centre).squaredNorm()}));
  near_.clear();
  front_.edges().near(centre, radius + margin, least_step(apex.step, radius + margin), near_);

  if (const auto same = vertex_at(apex)) {
    t.corners[2] = &front_.vertex(*same);
    t.apex = *same;
    if (front_.connectable(t.base, t.apex) && normal_agreement(t) >= rule.agreement && gaps_left(front_, t) &&
        fences(front_, t, near_, 0.0) == Fence::clear) {
      connect(t.base, t.apex);
      return;
    }
  } else if (normal_agreement(t) >= rule.agreement && gaps_left(front_, t) && !is_meshed(apex, entry.rules) &&
             fences(front_, t, near_, margin) == Fence::clear) {
    const int made = front_.grow(entry.node, apex);
    ++counts_.grown;
    push_grow(entry.node, 0);
    push_grow(made, 0);
    return;
  }
  const auto best = best_candidate(entry.node, entry.rules);
  if (best) {
    push_connect(entry.node, entry.rules, best->angle);
  } else {
    waiting_.push_back(entry);
  }
}

std::optional<Advance::Candidate> Advance::best_candidate(int node, int rules) {
  const Rules& rule = Advance::rules(rules);
  const Vertex &a = front_.vertex(node), &b = front_.vertex(front_.next(node));
  const double edge = (b.x - a.x).norm();
  const double reach = rule.reach * std::max(edge, 0.5 * (a.step + b.step));
  const Eigen::Vector3d middle = 0.5 * (a.x + b.x);
  near_.clear();
  front_.edges().near(middle, reach, least_step(std::min(a.step, b.step), reach), near_);
  candidates_.clear();
  for (const int n : near_) {
    const Vertex& c = front_.vertex(n);
    if (&c == &a || &c == &b || (c.x - middle).norm() > reach) continue;
    const Tentative t{{&a, &b, &c}, node, n};
    if (normal_agreement(t) < rule.agreement) continue;
    const auto left = gaps_left(front_, t);
    if (left) candidates_.push_back({n, std::min(smallest_angle(t), *left)});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
    return x.angle != y.angle ? x.angle > y.angle : x.node < y.node;
  });
  for (const Candidate& candidate : candidates_) {
    const Tentative t{{&a, &b, &front_.vertex(candidate.node)}, node, candidate.node};
    if (front_.connectable(node, candidate.node) && fences(front_, t, near_, 0.0) == Fence::clear) {
      return candidate;
    }
  }
  return std::nullopt;
}

void Advance::try_connect(const Entry& entry) {
  const auto best = best_candidate(entry.node, entry.rules);
  if (!best) {
    waiting_.push_back(entry);
  } else if (best->angle < -entry.key - 1e-12) {
    push_connect(entry.node, entry.rules, best->angle);  // other edges may have a better candidate now
  } else {
    connect(entry.node, best->node);
  }
}

void Advance::connect(int node, int apex) {
  changed_.clear();
  switch (front_.connect(node, apex, changed_)) {
    case Link::split:
      ++counts_.split;
      break;
    case Link::merge:
      ++counts_.merged;
      break;
    default:
      ++counts_.connected;
  }
  for (const int n : changed_) push_grow(n, 0);
}

bool Advance::retry_waiting() {
  std::vector<Entry> again;
  again.swap(waiting_);
  std::erase_if(again, [&](const Entry& entry) { return !valid(entry); });
  if (again.empty()) return false;
  const bool moved = front_.triangles().size() > triangles_at_retry_;
  retry_rules_ = moved ? 0 : retry_rules_ + 1;
  triangles_at_retry_ = front_.triangles().size();
  if (retry_rules_ > 2) return false;
  for (const Entry& entry : again) push_grow(entry.node, retry_rules_);
  return true;
}

void Advance::run(const Monitor& monitor) {
  do {
    while (!queue_.empty() && !is_endless()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (!valid(entry)) continue;
      monitor.check();
      if (entry.kind == Kind::grow) {
        try_grow(entry);
      } else {
        try_connect(entry);
      }
    }
  } while (!is_endless() && retry_waiting());
}

}  // namespace isobench::advancing_front
