// SPDX-License-Identifier: Apache-2.0
#include "mesh/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>
#include <utility>

namespace pyrasim {
namespace {

using Point = glm::dvec2;

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// Whether two sides that lie on one line with the corner b leave it in one direction, or one of them has no length.
bool folds(const Point& a, const Point& b, const Point& c) { return a == b || b == c || glm::dot(a - b, c - b) > 0; }

/// A triangle that turns left, and what of the polygon is in its way.
class Ear {
 public:
  Ear(const Point& previous, const Point& tip, const Point& next, double slack)
      : corners_{previous, tip, next},
        slack_(slack),
        low_(glm::min(glm::min(previous, tip), next) - slack),
        high_(glm::max(glm::max(previous, tip), next) + slack) {}

  bool is_far(const Point& point) const {
    return glm::any(glm::lessThan(point, low_)) || glm::any(glm::greaterThan(point, high_));
  }

  /// Where a point is: to the left (1), on (0) or to the right (-1) of each of the three sides.
  std::array<int, 3> sides_of(const Point& point) const {
    return {side_of(point, 0), side_of(point, 1), side_of(point, 2)};
  }

  /// Whether a line from a point with `sides`, none of which is -1, to the point `to` passes through the inside.
  bool is_entered(const std::array<int, 3>& sides, const Point& to) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides[k] == 0 && side_of(to, k) <= 0) return false;
    }
    return true;
  }

  /// Whether a polygon that goes by the three points passes the ear's corners on its way back.
  bool is_walked_back(const Point& previous, const Point& point, const Point& next) const {
    return point == corners_[1] && previous == corners_[2] && next == corners_[0];
  }

 private:
  int side_of(const Point& point, std::size_t side) const {
    const Point& from = corners_[side];
    const Point& to = corners_[(side + 1) % 3];
    if (slack_ == 0) return orientation(from, to, point);
    const double area = cross(to - from, point - from);
    return std::abs(area) <= slack_ * glm::length(to - from) ? 0 : area < 0 ? -1 : 1;
  }

  std::array<Point, 3> corners_;
  double slack_;
  Point low_;
  Point high_;
};

}  // namespace

EarClipping::EarClipping(const PlanePoints& corners, double slack) : slack_(slack), left_(corners.size()) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  nodes_.reserve(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    nodes_.push_back({corners[k], k > 0 ? k - 1 : count - 1, k + 1 < count ? k + 1 : 0});
  }
  triangles_.reserve(count);
  for (const Pass pass : {Pass::clean, Pass::touching, Pass::slack, Pass::blocked, Pass::any}) run(pass);
}

bool EarClipping::Candidate::operator<(const Candidate& other) const {
  return std::tie(cut, at.x, at.y) > std::tie(other.cut, other.at.x, other.at.y);
}

void EarClipping::push(std::uint32_t corner) {
  const Node& node = nodes_[corner];
  const Point cut = nodes_[node.next].at - nodes_[node.previous].at;
  candidates_.push({glm::dot(cut, cut), node.at, corner, node.previous, node.next});
}

void EarClipping::run(Pass pass) {
  if (left_ < 3) return;
  std::uint32_t corner = some_;
  for (std::size_t k = 0; k < left_; ++k, corner = nodes_[corner].next) push(corner);
  while (left_ >= 3 && !candidates_.empty()) {
    const Candidate candidate = candidates_.top();
    candidates_.pop();
    const Node& node = nodes_[candidate.corner];
    const bool is_current =
        !node.clipped && node.previous == candidate.previous && node.next == candidate.next;  // else pushed again since
    if (!is_current || !may_be_clipped(candidate.corner, pass)) continue;
    clip(candidate.corner);
    push(node.previous);
    push(node.next);
  }
}

bool EarClipping::may_be_clipped(std::uint32_t corner, Pass pass) const {
  if (pass == Pass::any) return true;
  const Node& node = nodes_[corner];
  const Point& previous = nodes_[node.previous].at;
  const Point& next = nodes_[node.next].at;
  const int turn = orientation(previous, node.at, next);
  if (turn <= 0) return turn == 0 && folds(previous, node.at, next);
  switch (pass) {
    case Pass::clean:
      return contact_of(corner, 0) == Contact::none;
    case Pass::touching:
      return contact_of(corner, 0) != Contact::inside;
    case Pass::slack:
      return contact_of(corner, slack_) != Contact::inside;
    default:
      return true;
  }
}

EarClipping::Contact EarClipping::contact_of(std::uint32_t corner, double slack) const {
  const Node& tip = nodes_[corner];
  const Ear ear(nodes_[tip.previous].at, tip.at, nodes_[tip.next].at, slack);
  Contact contact = Contact::none;
  for (std::uint32_t k = nodes_[tip.next].next; k != tip.previous; k = nodes_[k].next) {
    const Node& node = nodes_[k];
    if (ear.is_far(node.at)) continue;
    const std::array<int, 3> sides = ear.sides_of(node.at);
    if (std::min({sides[0], sides[1], sides[2]}) < 0) continue;
    const Point& previous = nodes_[node.previous].at;
    const Point& next = nodes_[node.next].at;
    if (ear.is_entered(sides, previous) || ear.is_entered(sides, next)) return Contact::inside;
    const bool on_cut = sides[0] > 0 && sides[1] > 0;
    if (on_cut || ear.is_walked_back(previous, node.at, next)) contact = Contact::touching;
  }
  return contact;
}

void EarClipping::clip(std::uint32_t corner) {
  Node& node = nodes_[corner];
  node.clipped = true;
  nodes_[node.previous].next = node.next;
  nodes_[node.next].previous = node.previous;
  some_ = node.next;
  --left_;
  const Point& previous = nodes_[node.previous].at;
  const Point& next = nodes_[node.next].at;
  const int turn = orientation(previous, node.at, next);
  if (turn == 0) return;
  const double area = std::abs(cross(node.at - previous, next - previous));
  total_area_ += area;
  if (turn < 0) reversed_area_ += area;
  const std::uint32_t first = turn > 0 ? node.previous : node.next;
  triangles_.push_back({first, corner, turn > 0 ? node.next : node.previous});
}

}  // namespace pyrasim
