// SPDX-License-Identifier: Apache-2.0
#include "explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pyrasim::silhouettes {

Explanation::Explanation(const ExactScene& scene, const Ray& ray, const std::vector<Contact>& contacts,
                         const Rounding& rounding)
    : scene_(scene), contacts_(contacts) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    verdicts_.push_back(verdict(scene, ray, contacts[k], rounding));
    if (contacts[k].kind == kind_of<TriangleSurface>) facets_.emplace(contacts[k].index, k);
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    certain_.push_back(contacts[k].hit ? certain_hit(k) : std::nullopt);
  }
}

/// From triangle to triangle across all edges that the ray may run through. Where the ray is sure to be inside what has
/// been gathered, one of these triangles counts as hit.
std::optional<Explanation::Certain> Explanation::certain_hit(std::size_t contact) const {
  if (!verdicts_[contact].certain) return std::nullopt;
  Certain furthest{verdicts_[contact].highest_behind, verdicts_[contact].ends_behind};
  if (contacts_[contact].kind != kind_of<TriangleSurface>) return furthest;
  const auto determinant = [&](const Contact& of) { return of.margins[0] + of.margins[1] + of.margins[2]; };
  std::set<std::uint32_t> gathered{contacts_[contact].index};
  std::vector<std::size_t> pending{contact};
  while (!pending.empty()) {
    const std::size_t here = pending.back();
    pending.pop_back();
    furthest.behind = std::max(furthest.behind, verdicts_[here].highest_behind);
    furthest.ends = std::max(furthest.ends, verdicts_[here].ends_behind);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (!verdicts_[here].near_edge[edge]) continue;
      const auto [facet, turned] = scene_.neighbor(contacts_[here].index, edge);
      if (facet < 0) return std::nullopt;  // the border
      const auto index = static_cast<std::uint32_t>(facet);
      if (gathered.contains(index)) continue;
      const auto there = facets_.find(index);
      if (there == facets_.end()) continue;
      const std::size_t next = there->second;
      if (!verdicts_[next].possible) continue;  // the ray may run through the edge's line only
      const bool faces_alike = (determinant(contacts_[here]) > 0) == (determinant(contacts_[next]) > 0);
      if (!verdicts_[next].certain || faces_alike == turned) return std::nullopt;  // nothing left of it; a silhouette
      gathered.insert(index);
      pending.push_back(next);
    }
  }
  return furthest;
}

bool Explanation::allows(const Contact& contact, const Verdict& verdict) const {
  if (!verdict.possible) return false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (!certain_[k] || contacts_[k].identity.object == contact.identity.object) continue;
    if (verdict.lowest_behind <= certain_[k]->behind) continue;
    const bool first = contact.identity.object < contacts_[k].identity.object;
    if (first ? verdict.begins_behind > certain_[k]->ends : !ties_before(contact, verdict, *certain_[k])) return false;
  }
  return true;
}

bool Explanation::ties_before(const Contact& contact, const Verdict& verdict, const Certain& certain) const {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Verdict& other = verdicts_[k];
    const bool nearer = other.possible && other.lowest_behind < certain.behind;
    if (nearer && contact.identity.object < contacts_[k].identity.object &&
        verdict.begins_behind <= other.ends_behind) {
      return true;
    }
  }
  return false;
}

bool Explanation::allows(std::uint32_t object) const {
  if (object == no_object) {
    return std::none_of(certain_.begin(), certain_.end(), [](const auto& certain) { return certain.has_value(); });
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (contacts_[k].identity.object == object && allows(contacts_[k], verdicts_[k])) return true;
  }
  return false;
}

std::optional<double> part_of_bound(const ExactScene& scene, const Ray& ray, const std::vector<Contact>& contacts,
                                    const Rounding& rounding, std::uint32_t object) {
  const auto explained = [&](double part) {
    return Explanation(scene, ray, contacts, rounding.times(part)).allows(object);
  };
  if (!explained(1)) return std::nullopt;
  double not_explained = 0, part = 1;
  while (part - not_explained > 1.0 / 256) {
    const double middle = (not_explained + part) / 2;
    (explained(middle) ? part : not_explained) = middle;
  }
  return part;
}

}  // namespace pyrasim::silhouettes
