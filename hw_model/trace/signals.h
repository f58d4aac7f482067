// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw_model/processor.h"
#include "hw_model/trace/trace_window.h"

namespace pyrasim::hw {

/// A signal of a waveform: VCD, FST.
struct Signal {
  enum class Kind : std::uint8_t {
    state,   ///< of a stage: a StageState
    fill,    ///< of a FIFO: tokens, from the cycle of their write to that of their read
    row,     ///< on the screen, of the pixel that a stage works on, or worked on last; x: what it works on has none
    column,  ///< likewise
    ray,     ///< by order of issue from 0, likewise
    valid,   ///< of a FIFO: a token can be read
    ready,   ///< of a FIFO: there is room for another token
  };

  Kind kind;
  std::size_t source;  ///< in Processor::stages(), or in Processor::fifos()
  std::string name;
  std::size_t bits;
  bool shown;  ///< in the window
};

/// States of all stages, then fills of all FIFOs. With the window's details then row, column and ray of each stage,
/// after those valid and ready of each FIFO; these two not where the window is of some pixels: they are of all tokens.
std::vector<Signal> signals_of(const Processor& processor, const TraceWindow& window);

}  // namespace pyrasim::hw
