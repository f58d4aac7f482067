// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hw_model/processor.h"

namespace pyrasim::hw {

/// Why the frame is not finished, or not within the limit of cycles; empty where it is. The first line names the circle
/// in which stages wait for each other, if they do; the machine's state follows.
std::string why_unfinished(Processor& processor);

/// Throws LimitError with why_unfinished(), unless that is empty.
void require_finished(Processor& processor);

/// A line for each stage (what it waits for) and for each FIFO (how full it is).
std::string machine_state(Processor& processor);

/// "a -> b -> a": each waits for the next; empty where no stages wait in a circle.
std::string wait_for_cycle(Processor& processor);

}  // namespace pyrasim::hw
