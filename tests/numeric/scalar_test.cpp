// SPDX-License-Identifier: Apache-2.0
// The kernels in every number format: what they ask of a scalar is there, and wide formats agree with double.
#include "numeric/scalar.h"

#include <gtest/gtest.h>

#include <thread>

#include "camera/view_vector.h"
#include "intersect/box_test.h"
#include "numeric/number_types.h"
#include "surface/plane.h"
#include "surface/sphere.h"
#include "surface/triangle.h"
#include "surface/view_ray.h"

namespace pyrasim {
namespace {

/// What a format of P significand or F fraction bits may lose in a few operations on numbers of about 1 to 10.
template <class Scalar>
double tolerance() {
  return std::ldexp(static_cast<double>(epsilon<Scalar>()), 6);
}

template <class Scalar>
Vector<Scalar> vector(double x, double y, double z) {
  return to_scalar<Scalar>({x, y, z});
}

template <class Scalar>
void expect_vectors_work() {
  const auto v = vector<Scalar>(1, 2, -3) * Scalar(2) - vector<Scalar>(1, 1, 1) + Vector<Scalar>(0, 0, 1);
  EXPECT_EQ(v, vector<Scalar>(1, 3, -6));
  EXPECT_EQ(-v, vector<Scalar>(-1, -3, 6));
  EXPECT_EQ(static_cast<double>(dot(v, v)), 46);
  EXPECT_EQ(glm::dvec3(cross(v, vector<Scalar>(1, 0, 0))), glm::dvec3(0, -6, -3));
}

template <class Scalar>
void expect_hits() {
  const SurfaceIdentity identity{0, 0};
  const auto direction = vector<Scalar>(1, 0, 0);
  const ViewRay<Scalar> ray(direction);
  const SphereSurface<Scalar> sphere{vector<Scalar>(4, 0.5, 0), Scalar(1), Scalar(15.25), Scalar(1), identity};
  const Scalar t = sphere.intersect(ray);
  EXPECT_NEAR(static_cast<double>(t), 4 - std::sqrt(0.75), tolerance<Scalar>());
  const PlaneSurface<Scalar> plane{vector<Scalar>(-1, 0, 0), Scalar(-3), identity};
  EXPECT_EQ(plane.intersect(ray), Scalar(3));
  const std::array<std::array<Scalar, 3>, 3> vertices{
      {{Scalar(2), Scalar(-1), Scalar(-1)}, {Scalar(2), Scalar(1), Scalar(-1)}, {Scalar(2), Scalar(0), Scalar(1)}}};
  EXPECT_EQ((TriangleSurface<Scalar>{vertices, identity}.intersect(TriangleShear<Scalar>(direction))), Scalar(2));
}

/// A ray of slopes 0 and 0.5 through a box about it, past one beside it, along another's edge, and short of one.
template <class Scalar>
void expect_boxes_are_told_apart() {
  SlopeBoxes<Scalar> boxes{};
  const auto set = [&](std::size_t box, double depth, std::array<double, 4> slopes) {
    boxes.depth[box] = Scalar(depth);
    boxes.lower_y[box] = Scalar(slopes[0]);
    boxes.upper_y[box] = Scalar(slopes[1]);
    boxes.lower_z[box] = Scalar(slopes[2]);
    boxes.upper_z[box] = Scalar(slopes[3]);
  };
  set(0, 2, {-1, 1, 0, 1});
  set(1, 2, {0.5, 1, 0, 1});
  set(2, 2, {0, 1, 0.5, 1});
  set(3, 3, {-1, 1, 0, 1});
  EXPECT_EQ(met_boxes(boxes, ViewRay<Scalar>(vector<Scalar>(2, 0, 1)), DepthLimit<Scalar>(2.5)), 0b0101U);
}

TEST(Scalar, EveryFormatServesTheKernels) {
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    with_number_type(format, []<class Scalar>(std::type_identity<Scalar>) {
      expect_vectors_work<Scalar>();
      expect_hits<Scalar>();
      expect_boxes_are_told_apart<Scalar>();
    });
  }
}

TEST(Scalar, ViewVectorsComeFromIntegerGridPoints) {
  const Screen screen{.columns = 4, .rows = 2, .dx = 1, .dy = 0.25, .dz = 0.25};
  const ViewVectors vectors(screen, 8, NumberFormat::fixed(64, 20));
  EXPECT_EQ(vectors({0, 0}), glm::dvec3(1, 0.25, -0.5));
  EXPECT_EQ(vectors({16, 31}), glm::dvec3(1, -0.25, 0.46875));
}

TEST(Scalar, FunctionsOfTheFormatsAreFoundByTheirArguments) {
  const FormatScope<Flt> floating(fp24);
  EXPECT_EQ(abs(Flt(-2)), Flt(2));
  EXPECT_EQ(copysign(Flt(2), Flt(-0.0)), Flt(-2));
  EXPECT_TRUE(signbit(Flt(-0.0)) && isfinite(Flt(1)) && isnan(std::numeric_limits<Flt>::quiet_NaN()));
  EXPECT_EQ(std::max(Flt(1), Flt(2)), Flt(2));
  const FormatScope<Fix> fixed(NumberFormat::fixed(32, 16));
  EXPECT_EQ(abs(Fix(-2)), Fix(2));
  EXPECT_EQ(copysign(Fix(2), Fix(-1)), Fix(-2));
  EXPECT_TRUE(signbit(Fix(-1)) && isfinite(Fix(1)) && !isnan(Fix(1)));
  EXPECT_EQ(std::min(Fix(1), Fix(2)), Fix(1));
}

TEST(ArithmeticEvents, EachThreadCountsItsOwnAndCountsAddUp) {
  arithmetic_events = {};
  ArithmeticEvents other;
  std::thread([&other] {
    const FormatScope<Flt> scope(fp16);
    EXPECT_EQ(Flt(60000) + Flt(60000), std::numeric_limits<Flt>::infinity());
    EXPECT_EQ(static_cast<double>(Flt(0x1p-20) * Flt(0x1p-20)), 0);
    other = arithmetic_events;
  }).join();
  EXPECT_EQ(arithmetic_events, ArithmeticEvents());
  EXPECT_EQ(other, (ArithmeticEvents{.saturations = 1, .underflows = 1, .inexact = 2}));
  ArithmeticEvents sum{1, 2, 3, 4, 5};
  sum += other;
  EXPECT_EQ(sum, (ArithmeticEvents{2, 3, 5, 4, 5}));
}

TEST(ArithmeticEvents, EachEventOfAnOperationIsCounted) {
  const auto events_of = [](auto action) {
    arithmetic_events = {};
    action();
    return arithmetic_events;
  };
  const FormatScope<Flt> floating(fp24);
  const Flt one(1);
  const Flt zero(0);
  EXPECT_EQ(events_of([&] { return one + one; }), ArithmeticEvents());
  EXPECT_EQ(events_of([&] { return one / Flt(3); }), (ArithmeticEvents{.inexact = 1}));
  EXPECT_EQ(events_of([&] { return one / zero; }), (ArithmeticEvents{.divisions_by_zero = 1}));
  EXPECT_EQ(events_of([&] { return zero / zero; }), (ArithmeticEvents{.divisions_by_zero = 1}));
  EXPECT_EQ(events_of([&] { return sqrt(-one); }), (ArithmeticEvents{.invalid = 1}));
  EXPECT_EQ(events_of([&] { return one + Flt(0x1p-40); }), (ArithmeticEvents{.inexact = 1}));
  const FormatScope<Fix> fixed(NumberFormat::fixed(16, 8));
  EXPECT_EQ(events_of([] { return Fix(100) + Fix(100); }), (ArithmeticEvents{.saturations = 1, .inexact = 1}));
  EXPECT_EQ(events_of([] { return Fix::from_raw(1) * Fix::from_raw(1); }),
            (ArithmeticEvents{.underflows = 1, .inexact = 1}));
  EXPECT_EQ(events_of([] { return sqrt(Fix(-1)); }), (ArithmeticEvents{.invalid = 1}));
}

}  // namespace
}  // namespace pyrasim
