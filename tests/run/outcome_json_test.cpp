// SPDX-License-Identifier: Apache-2.0
#include "run/outcome_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <ranges>

#include "../error_of.h"
#include "error.h"
#include "run/outcome_fields.h"

namespace pyrasim {
namespace {

Outcome through_text(const Outcome& outcome) { return unpack(nlohmann::json::parse(pack(outcome).dump())); }

/// The listed fields of a struct lie in memory one behind the other, and fill it: none is left out.
template <class Struct>
void expect_all_fields_listed() {
  const auto aligned = [](std::size_t at, std::size_t alignment) {
    return (at + alignment - 1) / alignment * alignment;
  };
  const Struct its{};
  std::size_t end = 0;
  for_each_field(its, [&](const char* name, const auto& field) {
    const auto at = reinterpret_cast<const char*>(&field) - reinterpret_cast<const char*>(&its);
    EXPECT_EQ(static_cast<std::size_t>(at), aligned(end, alignof(std::decay_t<decltype(field)>))) << name;
    end = static_cast<std::size_t>(at) + sizeof field;
  });
  EXPECT_EQ(aligned(end, alignof(Struct)), sizeof(Struct));
}

TEST(OutcomeJson, ListsEveryField) {
  expect_all_fields_listed<Outcome>();
  expect_all_fields_listed<FrameStatistics>();
  expect_all_fields_listed<Work>();
  expect_all_fields_listed<DatapathEvents>();
  expect_all_fields_listed<ArithmeticEvents>();
  expect_all_fields_listed<UnitAccount>();
  expect_all_fields_listed<hw::StageStatistics>();
  expect_all_fields_listed<WaitAccount>();
  expect_all_fields_listed<hw::MachinePart>();
  expect_all_fields_listed<FifoAccount>();
  expect_all_fields_listed<hw::FifoStatistics>();
  expect_all_fields_listed<OccupancyAccount>();
  expect_all_fields_listed<hw::BottleneckLink>();
  expect_all_fields_listed<hw::LowerBound>();
  expect_all_fields_listed<LatencyAccount>();
  expect_all_fields_listed<LatencyAccount::Class>();
  expect_all_fields_listed<SlowPixel>();
  expect_all_fields_listed<ReferenceError>();
  expect_all_fields_listed<FormatError>();
  expect_all_fields_listed<DecisionFlips>();
}

/// Gives every field another value, of lists each element: large numbers, odd fractions, texts with all kinds of
/// characters.
class Filler {
 public:
  explicit Filler(std::uint64_t first) : next_(first) {}

  template <class Value>
  void fill(Value& value) {
    if constexpr (std::same_as<Value, bool>) {
      value = next() % 2 == 0;
    } else if constexpr (std::integral<Value>) {
      value = static_cast<Value>(next());
    } else if constexpr (std::same_as<Value, double>) {
      value = std::bit_cast<double>(next() >> 2U);  // finite, of any size
    } else if constexpr (std::same_as<Value, std::string>) {
      value = "\n\"\\\u00e9 " + std::to_string(next());
    } else if constexpr (requires { value.emplace(); }) {
      fill(value.emplace());
    } else if constexpr (requires { value.emplace_back(); }) {
      for (int k = 0; k < 3; ++k) fill(value.emplace_back());
    } else if constexpr (std::ranges::range<Value>) {
      for (auto& element : value) fill(element);
    } else {
      for_each_field(value, [&](const char*, auto& field) { fill(field); });
    }
  }

 private:
  std::uint64_t next() { return next_ = next_ * 6364136223846793005U + 1442695040888963407U; }

  std::uint64_t next_;
};

TEST(OutcomeJson, EveryFieldComesBack) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Outcome outcome;
    Filler(seed).fill(outcome);
    EXPECT_EQ(through_text(outcome), outcome) << seed;
  }
  EXPECT_EQ(through_text({}), Outcome());
}

TEST(OutcomeJson, ExtremesComeBackBitForBit) {
  using Limits = std::numeric_limits<double>;
  for (const double number : {Limits::infinity(), -Limits::infinity(), Limits::max(), Limits::denorm_min(),
                              Limits::min(), 0.1, 1 / 3.0, -0.0, 0.0, 1e22, 9007199254740993.0}) {
    Outcome outcome;
    outcome.error = {number, number, 0};
    outcome.format_error = {0, number, {}};
    outcome.host_seconds = number;
    const Outcome back = through_text(outcome);
    for (const double read : {back.error->rmse, back.error->maximum, back.format_error->psnr, back.host_seconds}) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(number)) << number;
    }
  }
  Outcome outcome;
  outcome.error = {Limits::quiet_NaN(), 0, std::numeric_limits<std::uint64_t>::max()};
  outcome.cycles = hw::never;
  const Outcome back = through_text(outcome);
  EXPECT_TRUE(std::isnan(back.error->rmse));
  EXPECT_EQ(back.error->rays, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(back.cycles, hw::never);
}

TEST(OutcomeJson, RefusesWhatIsNone) {
  nlohmann::json without = pack({});
  without["counts"].erase("subdivisions");
  nlohmann::json text = pack({});
  text["cycles"] = "many";
  nlohmann::json few = pack({});
  few["counts"]["rays_by_level"].erase(0);
  for (const nlohmann::json& document : {nlohmann::json(), nlohmann::json::array(), without, text, few}) {
    EXPECT_TRUE(error_of<InputError>([&] { unpack(document); }).starts_with("it is not a run's outcome")) << document;
  }
}

}  // namespace
}  // namespace pyrasim
