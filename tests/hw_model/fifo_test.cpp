// SPDX-License-Identifier: Apache-2.0
#include "hw_model/fifo/fifo.h"

#include <gtest/gtest.h>

#include <random>

namespace pyrasim::hw {
namespace {

TEST(Fifo, TokenIsVisibleAfterItsLatencyAndNotBefore) {
  for (const Cycle latency : {1, 2, 7, 64}) {
    Fifo<int> fifo(sc_core::sc_gen_unique_name("fifo"), 4);
    EXPECT_EQ(fifo.token_at(), never);
    fifo.write(42, 10, latency);
    EXPECT_EQ(fifo.token_at(), 10 + latency);
    EXPECT_EQ(fifo.front(), 42);
    EXPECT_EQ(fifo.read(10 + latency), 42);
    EXPECT_EQ(fifo.token_at(), never);
  }
}

TEST(Fifo, CellReadIsFreeOneCycleLater) {
  Fifo<int> fifo("fifo", 1);
  EXPECT_EQ(fifo.room_at(), 0U);
  fifo.write(1, 5, 3);
  EXPECT_EQ(fifo.room_at(), never);
  fifo.read(9);
  EXPECT_EQ(fifo.room_at(), 10U);
}

/// Writer ahead of the reader: each next cell is free when the token that lies `depth` before it has been read.
TEST(Fifo, RoomIsThatOfTheCellNextInTurn) {
  Fifo<int> fifo("fifo", 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(fifo.room_at(), 0U);
    fifo.write(k, 0, 1);
  }
  EXPECT_EQ(fifo.room_at(), never);
  for (const Cycle at : {4, 8, 15}) fifo.read(at);
  for (const Cycle at : {5, 9, 16}) {
    EXPECT_EQ(fifo.room_at(), at);
    fifo.write(0, at, 1);
  }
  EXPECT_EQ(fifo.room_at(), never);
}

TEST(Fifo, KeepsOrderAtEveryDepth) {
  for (const std::size_t depth : {1, 2, 3, 5, 8, 13}) {
    Fifo<int> fifo(sc_core::sc_gen_unique_name("fifo"), depth);
    std::mt19937_64 random(depth);
    Cycle now = 0;
    int written = 0;
    int read = 0;
    while (read < 500) {
      ++now;
      if (written < 500 && fifo.room_at() <= now && random() % 2 == 0) fifo.write(written++, now, 1 + random() % 3);
      if (fifo.token_at() <= now && random() % 2 == 0) {
        ASSERT_EQ(fifo.read(now), read);
        ++read;
      }
      EXPECT_LE(fifo.size(), depth);
      EXPECT_EQ(fifo.size(), static_cast<std::size_t>(written - read));
    }
    EXPECT_EQ(fifo.statistics().tokens, 500U);
    EXPECT_LE(fifo.statistics().max, depth);
  }
}

TEST(Fifo, PreloadedTokensAreThereFromTheStart) {
  Fifo<int> fifo("fifo", 2);
  fifo.preload(7);
  fifo.preload(8);
  EXPECT_EQ(fifo.token_at(), 0U);
  EXPECT_EQ(fifo.room_at(), never);
  EXPECT_EQ(fifo.read(0), 7);
  EXPECT_EQ(fifo.read(1), 8);
}

/// Three tokens at 0, 1 and 2 that are read at 5, 6 and 7, and one alone at 20, read at 21:
/// 6 + 6 + 6 + 2 cycles, three at once.
TEST(Fifo, StatisticsByHand) {
  Fifo<int> fifo("fifo", 8);
  for (const Cycle at : {0, 1, 2}) fifo.write(0, at, 1);
  for (const Cycle at : {5, 6, 7}) fifo.read(at);
  fifo.write(0, 20, 1);
  fifo.read(21);
  EXPECT_EQ(fifo.statistics().max, 3U);
  EXPECT_EQ(fifo.statistics().token_cycles, 20U);
  EXPECT_EQ(fifo.statistics().tokens, 4U);
}

/// At 3 there are three tokens: that of 0, which is read at 5, and those of 1 and 3, which nobody reads.
TEST(Fifo, TokensThatNobodyReadsCountBesideThoseThatWereRead) {
  Fifo<int> fifo("fifo", 8);
  for (const Cycle at : {0, 1, 3}) fifo.write(0, at, 1);
  fifo.read(5);
  EXPECT_EQ(fifo.statistics(10).max, 3U);
  EXPECT_EQ(fifo.statistics(10).token_cycles, 6U + 9 + 7);
}

/// Whichever of writer and reader runs ahead, the statistics are those of the dates.
TEST(Fifo, StatisticsDoNotDependOnTheOrderOfCalls) {
  struct Dates {
    Cycle write, read;
  };
  const std::vector<Dates> tokens{{0, 3}, {1, 4}, {4, 6}, {5, 9}, {6, 12}, {10, 13}, {30, 31}};
  Fifo<int> in_step("in_step", 4);
  for (Cycle now = 0; now <= 31; ++now) {
    for (const Dates& token : tokens) {
      if (token.read == now) in_step.read(now);
    }
    for (const Dates& token : tokens) {
      if (token.write == now) in_step.write(0, now, 1);
    }
  }
  Fifo<int> ahead("ahead", 4);
  std::size_t read = 0;
  for (const Dates& token : tokens) {
    while (ahead.room_at() > token.write) ahead.read(tokens[read++].read);
    ahead.write(0, token.write, 1);
  }
  while (read < tokens.size()) ahead.read(tokens[read++].read);
  // Cycle by cycle: a token is in the FIFO from its write to its read, both included.
  std::size_t most = 0;
  std::uint64_t sum = 0;
  for (Cycle now = 0; now <= 31; ++now) {
    std::size_t inside = 0;
    for (const Dates& token : tokens) inside += token.write <= now && now <= token.read ? 1 : 0;
    most = std::max(most, inside);
    sum += inside;
  }
  for (const auto* fifo : {&in_step, &ahead}) {
    EXPECT_EQ(fifo->statistics().max, most);
    EXPECT_EQ(fifo->statistics().token_cycles, sum);
  }
}

struct CountingEnd : FifoEnd {
  int wakes = 0;
  void woken() override {
    ++wakes;
    sleep();
  }
};

TEST(Fifo, WakesTheReaderWhenItWasEmptyAndTheWriterWhenItWasFull) {
  Fifo<int> fifo("fifo", 2);
  CountingEnd writer;
  CountingEnd reader;
  fifo.connect(writer, reader);
  fifo.write(0, 0, 1);
  fifo.write(0, 1, 1);
  EXPECT_EQ(reader.wakes, 1);
  EXPECT_EQ(writer.wakes, 0);
  fifo.read(2);
  EXPECT_EQ(writer.wakes, 1);
  fifo.read(3);
  EXPECT_EQ(writer.wakes, 1);
  fifo.write(0, 4, 1);
  EXPECT_EQ(reader.wakes, 2);
}

TEST(Fifo, WakesAPatientReaderOnlyWhenItIsFull) {
  Fifo<int> fifo("fifo", 3);
  CountingEnd writer;
  CountingEnd reader;
  fifo.connect(writer, reader);
  fifo.wake_reader_when_full();
  fifo.write(0, 0, 1);
  fifo.write(0, 1, 1);
  EXPECT_EQ(reader.wakes, 0);
  fifo.write(0, 2, 1);
  EXPECT_EQ(reader.wakes, 1);
}

TEST(FifoEnd, IsToldOnceUntilItSleepsAgain) {
  struct End : FifoEnd {
    int wakes = 0;
    void woken() override { ++wakes; }
  } end;
  end.wake();
  end.wake();
  EXPECT_EQ(end.wakes, 1);
  end.sleep();
  end.wake();
  EXPECT_EQ(end.wakes, 2);
}

TEST(FifoEnd, IsPutOnAListInsteadWhereItHasOne) {
  CountingEnd end;
  WokenEnds list;
  end.enlist(list);
  end.wake();
  end.wake();
  EXPECT_EQ(list, WokenEnds{&end});
  end.sleep();
  end.wake();
  EXPECT_EQ(list, (WokenEnds{&end, &end}));
  EXPECT_EQ(end.wakes, 0);
}

}  // namespace
}  // namespace pyrasim::hw
