// SPDX-License-Identifier: Apache-2.0
#include "oracle.h"

#include <algorithm>

#include "explanation.h"

namespace pyrasim::silhouettes {
namespace {

/// Two million times what double rounds: whoever decides by a wider margin than that need not ask Real.
constexpr Rounding doubt{.relative = 0x1p-32, .slope_relative = 0x1p-32};

std::uint32_t nearest(const std::vector<Contact>& contacts) {
  return contacts.empty() || !contacts.front().hit ? no_object : contacts.front().identity.object;
}

}  // namespace

std::uint32_t object_seen_in_real(const ExactScene& scene, const Ray& ray) {
  return nearest(contacts<Real>(scene, ray, doubt));
}

std::uint32_t object_seen(const ExactScene& scene, const Ray& ray) {
  const std::vector<Contact> near = contacts<double>(scene, ray, doubt);
  const std::uint32_t object = nearest(near);
  const Explanation explanation(scene, ray, near, doubt);
  bool doubtful = object != no_object && explanation.allows(no_object);
  for (const Contact& contact : near) {
    const std::uint32_t other = contact.identity.object;
    doubtful = doubtful || (other != object && explanation.allows(other));
  }
  return doubtful ? object_seen_in_real(scene, ray) : object;
}

}  // namespace pyrasim::silhouettes
