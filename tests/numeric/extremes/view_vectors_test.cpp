// SPDX-License-Identifier: Apache-2.0
// Extremes: view vectors of large screens at deep levels.
#include "../real.h"
#include "camera/view_vector.h"
#include "formats.h"

namespace pyrasim {
namespace {

/// A component by its formula, (N steps - 2 k) size / (2 dx steps).
Real component(int pixels, std::int64_t steps, std::uint32_t point, double size, double dx) {
  const auto doubled = static_cast<double>(pixels * steps - 2 * static_cast<std::int64_t>(point));
  return Real(doubled) * Real(size) / (Real(dx) * Real(2.0 * static_cast<double>(steps)));
}

/// Screens whose grid grows to 2^21 points a side, with pixels that no format holds exactly.
Screen screen_of(int columns) { return {columns, columns - 1, 1.3, 0.7 / columns / 1.1, 1.1 / columns / 0.9}; }

/// Half a unit of the component's last place, and what double's two roundings, of dy / dx and of the product, add: each
/// 2^-53 of the component. In double itself the product's rounding is the half unit.
TEST(ExtremesViewVectors, ComponentsErrByHalfAUnit) {
  for_every_format([]<class Scalar>() {
    const NumberFormat format = format_of<Scalar>();
    double worst = 0;
    Random random(1);
    for (const int columns : {5, 640, 16384, max_screen_size}) {
      for (const int level : {0, 5, 16}) {
        const Screen screen = screen_of(columns);
        const std::int64_t steps = std::int64_t{1} << level;
        const ViewVectors view_vectors(screen, steps, format);
        for (int k = 0; k < 40; ++k) {
          const auto row =
              static_cast<std::uint32_t>(random.below(static_cast<std::uint64_t>(screen.rows * steps) + 1));
          const auto column =
              static_cast<std::uint32_t>(random.below(static_cast<std::uint64_t>(screen.columns * steps) + 1));
          const glm::dvec3 v = view_vectors({row, column});
          const Real y = component(screen.rows, steps, row, screen.dy, screen.dx);
          const Real z = -component(screen.columns, steps, column, screen.dz, screen.dx);
          for (const auto& [held, exact] : {std::pair(v.y, y), std::pair(v.z, z)}) {
            const double size = std::abs(static_cast<double>(exact));
            const double unit = size > 0 ? spacing<Scalar>(size) : 1;
            const double in_double = std::ldexp(size, significand_bits<Scalar>() == 53 ? -53 : -52);
            const double error = static_cast<double>(abs(Real(held) - exact));
            ASSERT_LE(error, unit / 2 + in_double * (1 + 1e-9)) << columns << " " << level << " " << row;
            worst = std::max(worst, error / unit);
          }
        }
      }
    }
    print_figure("view vectors", format, fmt::format("max {:.3f} ulp", worst));
  });
}

/// The deepest grid that P >= log2(N) + L + 4 admits, up to 2^21 points a side: every step is seen. (Fixed point has
/// its own limit; DatapathFormats.AreRefusedWhereFixedPointCannotTellPointsApart.)
TEST(ExtremesViewVectors, PointsStayApartWhileTheFormatHasFourBitsMoreThanTheGrid) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const int grid_bits = std::min(significand_bits<Scalar>() - 4, 21);
    for (int level = 0; level <= std::min(grid_bits - 1, 5); level += 5) {
      const Screen screen = screen_of(1 << (grid_bits - level));
      const ViewVectors view_vectors(screen, 1 << level, format_of<Scalar>());
      glm::dvec3 last = view_vectors({0, 0});
      for (std::uint32_t k = 1; k <= static_cast<std::uint32_t>(screen.rows) << level; ++k) {
        const glm::dvec3 next = view_vectors({k, k});
        ASSERT_LT(next.y, last.y) << k;
        ASSERT_GT(next.z, last.z) << k;
        last = next;
      }
    }
  });
}

/// The case of the table: 16384 columns at MAX_LEVEL 5 in single precision.
TEST(ExtremesViewVectors, LargeScreenInSinglePrecision) {
  const Screen screen = screen_of(16384);
  const ViewVectors view_vectors(screen, 32, NumberFormat::single());
  double last = view_vectors({0, 0}).z;
  for (std::uint32_t k = 1; k <= 16384 * 32; ++k) {
    const double next = view_vectors({0, k}).z;
    ASSERT_GT(next, last) << k;
    last = next;
  }
}

}  // namespace
}  // namespace pyrasim
