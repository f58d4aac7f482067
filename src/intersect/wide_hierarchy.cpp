// SPDX-License-Identifier: Apache-2.0
#include "intersect/wide_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "intersect/hierarchy_builder.h"
#include "intersect/margin.h"
#include "numeric/number_range.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

/// Nodes of up to node_width children out of a binary hierarchy.
class Widening {
 public:
  Widening(PreparedScene<double>& scene, const Screen& screen, const Margin& margin)
      : scene_(scene), source_(std::exchange(scene.kinds, {})) {
    RunsOfKinds apart{};
    RunsOfKinds everything{};
    for_each_kind([&](auto kind) {
      apart[kind] = {0, take_bounds<kind>(margin)};
      const auto surfaces = static_cast<std::uint32_t>(std::get<kind>(source_).surfaces.size());
      everything[kind] = {apart[kind].count, surfaces - apart[kind].count};
    });
    const bool any_apart = std::any_of(apart.begin(), apart.end(), [](const RunOfKind& run) { return run.count > 0; });
    if (any_apart) scene_.apart = add_leaf(apart, std::numeric_limits<double>::infinity());
    double error = 0;
    for (const double of_surface : errors_) error = std::max(error, of_surface);
    scene_.everything = scene_.root = add_leaf(everything, error);
    std::vector<BoundingBox> visible;
    visible.reserve(bounds_.size());
    for (const BoundingBox& bounds : bounds_) visible.push_back(on_screen(bounds, screen));
    hierarchy_ = build_hierarchy(visible, Course::along_x);
  }

  void build() {
    if (!hierarchy_.nodes.empty()) scene_.root = convert(hierarchy_.nodes.front()).reference;
  }

 private:
  using Node = PreparedScene<double>::Node;
  struct RunOfKind {
    std::uint32_t first, count;
  };
  using RunsOfKinds = std::array<RunOfKind, surface_kinds>;
  struct Source {
    SurfaceKind kind;
    std::uint32_t index;  ///< in source_
  };

  /// Notes the surfaces of a kind that have bounds; the others go to their place in the scene. Returns their number.
  template <std::size_t kind>
  std::uint32_t take_bounds(const Margin& margin) {
    const auto& surfaces = std::get<kind>(source_).surfaces;
    std::uint32_t apart = 0;
    for (std::uint32_t k = 0; k < surfaces.size(); ++k) {
      if (const auto bounds = slope_bounds(surfaces[k], margin.of(surfaces[k]))) {
        bounded_.push_back({kind_at<kind>, k});
        bounds_.push_back(*bounds);
        using Surface = std::decay_t<decltype(surfaces[k])>;
        if constexpr (requires { surfaces[k].error; } || SharesMesh<Surface>) {
          errors_.push_back(0);  // it knows its own, or each of its triangles does
        } else {
          errors_.push_back(relative_error(surfaces[k], scene_.rounding));
        }
      } else {
        move<kind>(k);
        ++apart;
      }
    }
    return apart;
  }

  /// Appends a surface to those of its kind in the scene.
  template <std::size_t kind>
  void move(std::uint32_t index) {
    std::get<kind>(scene_.kinds).surfaces.push_back(std::get<kind>(source_).surfaces[index]);
    std::get<kind>(scene_.kinds).shading.push_back(std::get<kind>(source_).shading[index]);
  }

  struct Converted {
    BoundingBox bounds;          ///< of all surfaces in it, those off the screen too
    std::int32_t reference = 0;  ///< as Node::child
  };

  Converted convert(const BinaryNode& node) {
    if (node.count > 0) return convert_leaf(node);
    const std::size_t index = scene_.nodes.size();
    scene_.nodes.emplace_back();
    const std::vector<const BinaryNode*> sources = wide_children(hierarchy_, node);
    std::array<Converted, node_width> children;
    BoundingBox bounds;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      children[k] = convert(*sources[k]);
      bounds.include(children[k].bounds);
    }
    // Children without a surface before the observer, and those that there are not, begin at infinity.
    std::stable_sort(children.begin(), children.end(),
                     [](const Converted& a, const Converted& b) { return a.bounds.lower.x < b.bounds.lower.x; });
    Node& wide = scene_.nodes[index];
    wide.children = static_cast<std::uint32_t>(sources.size());
    for (std::size_t k = 0; k < node_width; ++k) {
      wide.boxes.set(k, children[k].bounds);
      wide.child[k] = children[k].reference;
    }
    return {bounds, static_cast<std::int32_t>(index)};
  }

  Converted convert_leaf(const BinaryNode& node) {
    RunsOfKinds runs{};
    for_each_kind([&](auto kind) {
      runs[kind].first = static_cast<std::uint32_t>(std::get<kind>(scene_.kinds).surfaces.size());
    });
    BoundingBox bounds;
    double error = 0;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t reference = hierarchy_.references[k];
      bounds.include(bounds_[reference]);
      error = std::max(error, errors_[reference]);
      const Source source = bounded_[reference];
      with_kind(source.kind, [&](auto kind) {
        move<kind>(source.index);
        ++runs[kind].count;
      });
    }
    return {bounds, add_leaf(runs, error)};
  }

  /// Its reference, as Node::child. A leaf of nothing has one run, of nothing.
  std::int32_t add_leaf(const RunsOfKinds& runs, double error) {
    const auto leaf = static_cast<std::int32_t>(scene_.runs.size());
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
      const auto [first, count] = runs[kind];
      if (count > 0) scene_.runs.push_back({first, count, SurfaceKind{static_cast<std::uint8_t>(kind)}, true, error});
    }
    if (scene_.runs.size() == static_cast<std::size_t>(leaf)) scene_.runs.push_back({});
    scene_.runs.back().more = false;
    return ~leaf;
  }

  PreparedScene<double>& scene_;
  SurfaceStore<double> source_;      // in the order of the scene
  std::vector<Source> bounded_;      // the surfaces with bounds, kind by kind; the hierarchy's references
  std::vector<BoundingBox> bounds_;  // in slope space, of the same
  std::vector<double> errors_;       // relative, of the same
  Hierarchy hierarchy_{Course::along_x, {}, {}};
};

}  // namespace

Margin margin_of_view_rays(const PreparedScene<double>& scene, const Screen& screen, const NumberFormat& format) {
  const double half_y = screen.rows * screen.dy / (2 * screen.dx);
  const double half_z = screen.columns * screen.dz / (2 * screen.dx);
  const double longest_squared = 1 + half_y * half_y + half_z * half_z;
  return {format, longest_squared, scene.rounding};
}

void build_wide_hierarchy(PreparedScene<double>& scene, const Screen& screen, const Margin& margin) {
  Widening(scene, screen, margin).build();
}

}  // namespace pyrasim
