// SPDX-License-Identifier: Apache-2.0
#include "hw_model/subdivision_controller.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "frames.h"
#include "one_pixel_setup.h"

namespace pyrasim::hw {
namespace {

constexpr const char* nodes_to_split = "pyramid_classifier_to_subdivision_controller";
constexpr const char* requests = "subdivision_controller_to_view_vector_generator";
constexpr const char* parents = "subdivision_controller_to_pyramid_classifier";

TEST(SubdivisionController, ARequestIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.subdivision_controller.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(requests)), frame.spec.subdivision_controller.latency);
  }
}

TEST(SubdivisionController, FiringsLieAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {1, 2, 7}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.subdivision_controller.interval = interval;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::vector<Cycle> firings = merged(frame.fifo(nodes_to_split).reads, frame.fifo(requests).writes);
    EXPECT_EQ(least_gap(firings), frame.spec.subdivision_controller.interval);
  }
}

TEST(SubdivisionController, SendsTheParentWithTheRequest) {
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}})) {
    SCOPED_TRACE(frame.name);
    ASSERT_GT(frame.fifo(requests).writes.size(), 4U);
    EXPECT_EQ(frame.fifo(parents).writes, frame.fifo(requests).writes);
  }
}

/// A request is issued only where no node could be accepted, not even since that very cycle.
TEST(SubdivisionController, AcceptsBeforeItIssuesAtTheSameDate) {
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 4}})) {
    SCOPED_TRACE(frame.name);
    const FifoDates& nodes = frame.fifo(nodes_to_split);
    std::size_t accepted = 0;
    for (const Cycle issued : frame.fifo(requests).writes) {
      while (accepted < nodes.reads.size() && nodes.reads[accepted] < issued) ++accepted;
      if (accepted < nodes.writes.size()) {
        ASSERT_GT(nodes.writes[accepted] + frame.spec.pyramid_classifier.latency, issued);
      }
    }
  }
}

/// A controller by itself: the test is the rest of the machine, which always has room.
struct Bench {
  Fifo<NodeMessage> nodes{sc_core::sc_gen_unique_name("nodes"), 4096};
  Fifo<SubdivisionRequest> requests{sc_core::sc_gen_unique_name("requests"), 4096};
  Fifo<NodeMessage> parents{sc_core::sc_gen_unique_name("parents"), 4096};
  SubdivisionController controller;
  std::uint32_t max_level;
  Cycle now = 0;

  Bench(std::size_t pool, int its_max_level)
      : controller(sc_core::sc_gen_unique_name("controller"), setup(pool, its_max_level).frame()),
        max_level(static_cast<std::uint32_t>(its_max_level)) {
    controller.pyramid_classifier(nodes);
    controller.view_vector_generator(requests);
    controller.parents(parents);
  }

  static OnePixelSetup setup(std::size_t pool, int max_level) {
    OnePixelSetup setup;
    setup.spec.subdivision_controller.latency = 1;
    setup.spec.subdivision_pool = pool;
    setup.options.max_level = max_level;
    return setup;
  }

  void send(std::uint32_t level, std::uint32_t pixel, bool subdivide = true, bool closes_family = false) {
    NodeMessage node{};
    node.cell.log2_side = max_level - level;
    node.tag.pixel = pixel;
    node.subdivide = subdivide;
    node.closes_family = closes_family;
    nodes.write(node, ++now, 1);
  }

  /// Lets the controller fire until it waits; the parents of the requests that it issues, in order.
  std::vector<NodeMessage> issued() {
    for (Start start = controller.next_start(); start.known(); start = controller.next_start()) {
      controller.fire_next();
      now = std::max(now, controller.ready());
    }
    std::vector<NodeMessage> all;
    while (!parents.empty()) {
      all.push_back(parents.read(std::max(now, parents.token_at())));
      requests.read(std::max(now, requests.token_at()));
    }
    return all;
  }
};

std::vector<std::uint32_t> pixels_of(const std::vector<NodeMessage>& nodes) {
  std::vector<std::uint32_t> pixels;
  for (const NodeMessage& node : nodes) pixels.push_back(node.tag.pixel);
  return pixels;
}

/// It could issue at 3; then a node comes that can be read at 3, and it would accept.
TEST(SubdivisionController, FiresAsPlannedWhateverIsAskedAfterwards) {
  Bench bench(64, 1);
  bench.send(0, 7);
  bench.controller.fire_next();
  const auto issue = bench.controller.plan();
  ASSERT_EQ(issue.start.at(), 3U);
  bench.send(0, 8);
  EXPECT_EQ(bench.controller.next_start().at(), 3U);
  bench.controller.fire_planned(issue);
  ASSERT_EQ(bench.requests.size(), 1U);
  EXPECT_EQ(bench.parents.front().tag.pixel, 7U);
  EXPECT_EQ(bench.nodes.size(), 1U);
}

TEST(SubdivisionController, IssuesPixelsOldestFirst) {
  Bench bench(64, 1);
  for (const std::uint32_t pixel : {3, 1, 2}) bench.send(0, pixel);
  EXPECT_EQ(pixels_of(bench.issued()), (std::vector<std::uint32_t>{3, 1, 2}));
}

TEST(SubdivisionController, IssuesSubpixelsNewestFirstAndBeforeAnyPixel) {
  Bench bench(64, 2);
  bench.send(0, 1);
  ASSERT_EQ(pixels_of(bench.issued()), (std::vector<std::uint32_t>{1}));
  for (const std::uint32_t name : {11, 12, 13}) bench.send(1, name);
  bench.send(0, 2);
  bench.send(1, 14, true, true);
  EXPECT_EQ(pixels_of(bench.issued()), (std::vector<std::uint32_t>{14, 13, 12, 11, 2}));
}

/// At MAX_LEVEL 2 a pixel reserves four entries, and is issued while 3 (2 - 1 - 0) + 1 are left: a pool of 4 n to
/// 4 n + 3 holds n pixels under way.
TEST(BankersRule, IssuesAPixelWhileItsTreeFitsAndNoFurther) {
  for (std::size_t pool = required_pool(2); pool <= 20; ++pool) {
    Bench bench(pool, 2);
    for (std::uint32_t pixel = 0; pixel < 10; ++pixel) bench.send(0, pixel);
    EXPECT_EQ(bench.issued().size(), pool / 4) << pool;
    bench.send(1, 0, false, true);  // the family is over: its entries are free
    EXPECT_EQ(bench.issued().size(), 1U) << pool;
  }
}

TEST(BankersRule, SaysWhatIsKeptAndWhatTheNextRequestNeeds) {
  Bench bench(7, 2);
  EXPECT_EQ(bench.controller.pool_kept(), 0U);
  EXPECT_EQ(bench.controller.pool_needed(), 0U) << "no node waits";
  for (const std::uint32_t pixel : {1, 2}) bench.send(0, pixel);
  ASSERT_EQ(bench.issued().size(), 1U);
  EXPECT_EQ(bench.controller.pool_kept(), 4U);
  EXPECT_EQ(bench.controller.pool_needed(), 4U);
}

TEST(BankersRule, RequestsWhoseFamilyEndsThereNeedNoPool) {
  Bench bench(0, 1);
  for (std::uint32_t pixel = 0; pixel < 10; ++pixel) bench.send(0, pixel);
  EXPECT_EQ(bench.issued().size(), 10U);
}

TEST(BankersRule, APixelNeedsTheWholeOfTheSmallestPool) {
  for (int max_level = 2; max_level <= 10; ++max_level) {
    for (const std::size_t missing : {0, 1}) {
      Bench bench(required_pool(max_level) - missing, max_level);
      bench.send(0, 1);
      EXPECT_EQ(bench.issued().size(), 1 - missing) << "MAX_LEVEL " << max_level;
    }
  }
}

/// Plays the rest of the machine with random trees, and keeps its own account of the pool's entries.
class RandomTrees {
 public:
  RandomTrees(std::size_t pool, int max_level, int percent, std::uint64_t seed)
      : bench_(pool, max_level), max_level_(static_cast<std::uint32_t>(max_level)), percent_(percent), random_(seed) {}

  std::size_t most_entries() const { return most_; }
  std::size_t pool_max() const { return bench_.controller.pool_max(); }

  /// Whether all `pixels` trees come to their end.
  bool finish(std::uint32_t pixels) {
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) bench_.send(0, pixel);
    waiting_ = pixels;
    take_issued();
    while (!under_way_.empty()) {
      answer(under_way_.front());
      under_way_.erase(under_way_.begin());  // the classifier takes requests in order
    }
    return waiting_ == 0;
  }

 private:
  void take_issued() {
    for (const NodeMessage& node : bench_.issued()) {
      --waiting_;
      const std::uint32_t level = max_level_ - node.cell.log2_side;
      if (level > 0) --entries_;
      if (level + 1 < max_level_) entries_ += 4;
      most_ = std::max(most_, entries_);
      under_way_.push_back(level);
    }
  }

  /// The four subpixels of a request of `level`, with the controller at work in between or not.
  void answer(std::uint32_t level) {
    if (level + 1 >= max_level_) return;  // all are terminal, and the controller hears of none
    std::size_t split = 0;
    for (int child = 0; child < 4; ++child) {
      const bool subdivide = static_cast<int>(random_() % 100) < percent_;
      if (!subdivide && child < 3) continue;
      bench_.send(level + 1, 0, subdivide, child == 3);
      waiting_ += subdivide ? 1 : 0;
      split += subdivide ? 1 : 0;
      if (child < 3 && random_() % 2 == 0) take_issued();
    }
    entries_ -= 4 - split;
    take_issued();
  }

  Bench bench_;
  std::uint32_t max_level_;
  int percent_;
  std::mt19937_64 random_;
  std::vector<std::uint32_t> under_way_;  ///< levels of the requests, in order of issue
  std::size_t waiting_ = 0;               ///< nodes sent and not issued
  std::size_t entries_ = 0;               ///< in use or reserved; until a family is over all of its four
  std::size_t most_ = 0;
};

TEST(BankersRule, ThePoolIsNeverExceededAndTheSmallestFinishesEveryTree) {
  for (int max_level = 2; max_level <= 6; ++max_level) {
    for (const std::size_t extra : {0, 1, 2, 3, 5, 17}) {
      for (const int percent : {30, 60, 100}) {
        const std::size_t pool = required_pool(max_level) + extra;
        RandomTrees trees(pool, max_level, max_level == 6 ? std::min(percent, 60) : percent, pool);
        EXPECT_TRUE(trees.finish(12)) << "MAX_LEVEL " << max_level << ", pool " << pool << ", " << percent << " %";
        EXPECT_LE(trees.pool_max(), pool);
        EXPECT_LE(trees.most_entries(), pool);
        if (percent == 100 && extra == 0) {
          EXPECT_EQ(trees.pool_max(), pool) << "a full tree needs it all";
        }
      }
    }
  }
}

}  // namespace
}  // namespace pyrasim::hw
