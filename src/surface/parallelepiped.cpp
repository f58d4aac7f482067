// SPDX-License-Identifier: Apache-2.0
#include "surface/parallelepiped.h"

#include "surface/pov_writer.h"

namespace pyrasim {

Parallelepiped Parallelepiped::transformed(const AffineMap& map) const {
  Parallelepiped mapped{map.point(corner), {}};
  static_cast<void>(mapped_point(map, rounded(corner)));
  for (std::size_t k = 0; k < 3; ++k) {
    mapped.edges[k] = map.direction(edges[k]);
    static_cast<void>(mapped_length(length(mapped.edges[k])));
  }
  return mapped;
}

/// Of each pair of faces: their normal, and how far away the corner's face and the other one are along it.
Prepared<BoxSurface> Parallelepiped::prepared(const Preparation& preparation) const {
  Prepared<BoxSurface> prepared{};
  const QuadrupleVector away = difference(corner, exactly(preparation.frame.position()));
  for (std::size_t k = 0; k < 3; ++k) {
    QuadrupleVector across = unit(cross(edges[(k + 1) % 3], edges[(k + 2) % 3]));
    if (dot(across, edges[k]) < 0) across = {-across[0], -across[1], -across[2]};
    const QuadrupleVector normal = exactly(rounded(across));
    const Quadruple lower = dot(normal, away);
    const glm::dvec3 observed = preparation.frame.direction(rounded(normal));
    prepared.surface.slabs[k] = {observed, static_cast<double>(lower),
                                 static_cast<double>(lower + dot(normal, edges[k]))};
    prepared.shading.faces[k] = flat_shading(observed, preparation.lighting);
  }
  return prepared;
}

void Parallelepiped::write_pov(PovWriter& pov) const {
  pov.begin("box");
  pov.add(glm::dvec3(0), glm::dvec3(1));
  pov.matrix({rounded(edges[0]), rounded(edges[1]), rounded(edges[2])}, rounded(corner));
  pov.end();
}

}  // namespace pyrasim
