// SPDX-License-Identifier: Apache-2.0
#include "pyramid/classifier.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pyrasim {
namespace {

PyramidCase classified(std::array<std::uint32_t, 4> objects) {
  return classify({{{{objects[0]}}, {{objects[1]}}, {{objects[2]}}, {{objects[3]}}}});
}

TEST(Classifier, CaseOneNoRayHits) {
  EXPECT_EQ(classified({no_object, no_object, no_object, no_object}), PyramidCase::empty);
}

TEST(Classifier, CaseTwoAllRaysHitTheSameObject) {
  EXPECT_EQ(classified({0, 0, 0, 0}), PyramidCase::covered);
  EXPECT_EQ(classified({7, 7, 7, 7}), PyramidCase::covered);
}

/// The corners do not show an object between the rays: the pyramid looks empty (decision D9).
TEST(Classifier, CaseFourLooksEmpty) {
  EXPECT_EQ(classify({Sample{}, Sample{}, Sample{}, Sample{}}), PyramidCase::empty);
}

TEST(Classifier, CaseThreeInEveryArrangement) {
  for (std::array<std::uint32_t, 4> corners : {std::array<std::uint32_t, 4>{0, no_object, no_object, no_object},
                                               {0, 0, no_object, no_object},
                                               {0, 0, 0, no_object},
                                               {0, 0, 0, 1},
                                               {0, 0, 1, 1},
                                               {0, 1, 2, 3},
                                               {0, 1, no_object, no_object},
                                               {0, 1, 2, no_object}}) {
    std::sort(corners.begin(), corners.end());
    do {
      EXPECT_EQ(classified(corners), PyramidCase::edge);
    } while (std::next_permutation(corners.begin(), corners.end()));
  }
}

/// Decision D5: the border of a shadow is an edge.
TEST(Classifier, LightsDecide) {
  EXPECT_EQ(classify({{{{3, 2}}, {{3, 2}}, {{3, 2}}, {{3, 2}}}}), PyramidCase::covered);
  EXPECT_EQ(classify({{{{3, 2}}, {{3, 2}}, {{3, 0}}, {{3, 2}}}}), PyramidCase::edge);
  EXPECT_EQ(classify({{{{3, 2}}, {{3, 2}}, {{3, 2}}, {{3, 3}}}}), PyramidCase::edge);
}

TEST(Classifier, ShadingDoesNotDecide) {
  EXPECT_EQ(classify({{{{3}, 0.1}, {{3}, 0.9}, {{3}, 0}, {{3}, 1}}}), PyramidCase::covered);
}

TEST(Classifier, OnlyEdgesAboveMaxLevelSubdivide) {
  EXPECT_TRUE(subdivides(PyramidCase::edge, {{}, 1}));
  EXPECT_TRUE(subdivides(PyramidCase::edge, {{}, 3}));
  EXPECT_FALSE(subdivides(PyramidCase::edge, {{}, 0}));
  for (const PyramidCase which : {PyramidCase::covered, PyramidCase::empty, PyramidCase::hidden}) {
    EXPECT_FALSE(subdivides(which, {{}, 3}));
  }
}

}  // namespace
}  // namespace pyrasim
