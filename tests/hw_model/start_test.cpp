// SPDX-License-Identifier: Apache-2.0
// What a firing waits for last, and which of several is named where they come at once.
#include "hw_model/stage/start.h"

#include <gtest/gtest.h>

#include "hw_model/fifo/fifo.h"

namespace pyrasim::hw {
namespace {

/// Holds one token, there from 5 on.
struct Token {
  explicit Token(const char* name) : fifo(name, 1) { fifo.write(0, 4, 1); }
  Fifo<int> fifo;
};

/// Has one cell, free from 5 on.
struct Cell {
  explicit Cell(const char* name) : fifo(name, 1) {
    fifo.write(0, 0, 1);
    fifo.read(4);
  }
  Fifo<int> fifo;
};

TEST(Start, IsTheLatestOfAll) {
  Token token("token");
  Cell cell("cell");
  EXPECT_EQ(Start(2).needs_token(token.fifo).at(), 5U);
  EXPECT_EQ(Start(2).needs_room(cell.fifo).at(), 5U);
  EXPECT_EQ(Start(9).needs_token(token.fifo).needs_room(cell.fifo).at(), 9U);
  EXPECT_FALSE(Start(2).needs_room(token.fifo).known()) << "its cell is not free";
}

TEST(Start, NamesTheTokenWhereTokenAndRoomComeAtOnce) {
  Token token("token");
  Cell cell("cell");
  EXPECT_EQ(Start(2).needs_token(token.fifo).needs_room(cell.fifo).cause(), &token.fifo.starved());
}

TEST(Start, NamesTheFirstOfSeveralThatComeAtOnce) {
  Token token("token");
  Token second_token("second_token");
  Cell cell("cell");
  Cell second_cell("second_cell");
  EXPECT_EQ(Start(2).needs_token(token.fifo).needs_token(second_token.fifo).cause(), &token.fifo.starved());
  EXPECT_EQ(Start(2).needs_room(cell.fifo).needs_room(second_cell.fifo).cause(), &cell.fifo.blocked());
}

TEST(Start, NamesNothingWhereTheStageIsReadyLast) {
  Token token("token");
  Cell cell("cell");
  EXPECT_EQ(Start(5).needs_token(token.fifo).needs_room(cell.fifo).cause(), nullptr);
}

}  // namespace
}  // namespace pyrasim::hw
