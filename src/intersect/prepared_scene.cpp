// SPDX-License-Identifier: Apache-2.0
#include "intersect/prepared_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "camera/observer_frame.h"
#include "intersect/margin.h"
#include "intersect/wide_hierarchy.h"
#include "numeric/number_range.h"
#include "numeric/vectors.h"
#include "surface/preparation.h"

namespace pyrasim {
namespace {

/// By what power of two the largest coordinate may exceed 1, so that products of three coordinates, which a triangle's
/// depth takes, stay within the format. Fixed point so uses the bits that it has.
int largest_exponent(const NumberFormat& format) {
  constexpr int enough = 16;
  return std::min((integer_bits(format) - 4) / 3, enough);
}

Lighting<double> lighting_of(const std::optional<SingleLight>& light, const ObserverFrame& frame) {
  if (!light) return {};
  return {true, light->ambient, -normalized(frame.direction(light->direction))};
}

/// Puts a scene's objects into a PreparedScene, in the order of the scene.
class Filling {
 public:
  explicit Filling(const Scene& scene)
      : preparation_{ObserverFrame(scene.camera), lighting_of(scene.light, ObserverFrame(scene.camera))} {
    prepared_.lighting = preparation_.lighting;
    for (const Object& object : scene.objects) {
      std::visit([this](const auto& surface) { add(surface); }, object.surface);
      ++object_;
    }
  }

  /// Multiplies all lengths by the power of two that brings the largest to the exponent that suits the format: a scene
  /// 2^k times as large is the same to the datapath, bit for bit, and its squares neither over- nor underflow.
  PreparedScene<double> scaled_for(const NumberFormat& format) {
    prepared_.rounding = rounding_units_of(format);
    if (!(largest_ > 0)) return std::move(prepared_);
    share_meshes(largest_exponent(format));
    const Scaling scaling{largest_exponent(format) - std::ilogb(largest_)};
    for_each_kind([&](auto kind) {
      for (auto& surface : std::get<kind>(prepared_.kinds).surfaces) {
        surface = surface.template mapped<double>(scaling);
      }
    });
    prepared_.exponent = scaling.exponent;
    prepared_.rounding.place = std::min(scaling(largest(preparation_.frame.position()), 1), 0x1p500);
    return std::move(prepared_);
  }

 private:
  template <class Description>
  void add(const Description& description) {
    const auto put = [this](const auto& prepared) { this->put(prepared); };
    if constexpr (requires { description.prepared(preparation_); }) {
      put(description.prepared(preparation_));
    } else {
      description.prepare(preparation_, put);
    }
  }

  void add(const MeshInstance& instance) {
    const auto known = numbers_.emplace(instance.of.get(), numbers_.size());
    if (known.second) instanced_.push_back(instance.of);
    put(instance.prepared(preparation_));
    surfaces_of_instances().back().mesh = known.first->second;
    order_ += static_cast<std::uint32_t>(instance.of->mesh.triangles.size()) - 1;  // as if they were its own
  }

  /// Each mesh once, as large as suits the format.
  void share_meshes(int exponent) {
    for (const auto& mesh : instanced_) prepared_.meshes.push_back(shared_mesh(*mesh, exponent));
    for (auto& instance : surfaces_of_instances()) instance.scale = std::ldexp(instance.scale, -exponent);
  }
  std::vector<InstanceSurface<double>>& surfaces_of_instances() {
    return std::get<index_of_kind<InstanceSurface>>(prepared_.kinds).surfaces;
  }

  template <template <class> class Surface>
  void put(const Prepared<Surface>& prepared) {
    auto& [surfaces, shading] = std::get<index_of_kind<Surface>>(prepared_.kinds);
    surfaces.push_back(prepared.surface);
    surfaces.back().identity = {object_, order_++};
    shading.push_back(prepared.shading);
    largest_ = std::max(largest_, reach(prepared.surface));
  }

  Preparation preparation_;
  std::uint32_t object_ = 0;
  std::uint32_t order_ = 0;
  std::vector<std::shared_ptr<const InstancedMesh>> instanced_;
  std::map<const InstancedMesh*, std::uint32_t> numbers_;  ///< among these
  double largest_ = 0;                                     ///< coordinate in observer's coordinates
  PreparedScene<double> prepared_;
};

/// What is known of the errors of surfaces that know it themselves.
void note_errors(PreparedScene<double>& prepared) {
  for_each_kind([&](auto kind) {
    for (auto& surface : std::get<kind>(prepared.kinds).surfaces) {
      if constexpr (requires { surface.error; }) surface.error = relative_error(surface, prepared.rounding);
    }
  });
}

/// Once instances are in their order, and as far as each reaches is known: the numbers of their triangles, and by how
/// much boxes about these are grown.
void finish_instances(PreparedScene<double>& prepared, const Margin& margin) {
  std::uint32_t first = 0;
  for (auto& instance : std::get<index_of_kind<InstanceSurface>>(prepared.kinds).surfaces) {
    instance.first = first;
    instance.within.margin = 2 * margin.of(instance.within.reach);
    first += static_cast<std::uint32_t>(prepared.meshes[instance.mesh].triangles.size());
  }
}

}  // namespace

PreparedScene<double> prepare_scene(const Scene& scene, const NumberFormat& format) {
  PreparedScene<double> prepared = Filling(scene).scaled_for(format);
  note_errors(prepared);
  const Margin margin = margin_of_view_rays(prepared, scene.camera.screen, format);
  build_wide_hierarchy(prepared, scene.camera.screen, margin);
  finish_instances(prepared, margin);
  return prepared;
}

}  // namespace pyrasim
