// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/chrome_trace.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "version.h"

namespace pyrasim::hw {

ChromeTrace::ChromeTrace(const Processor& processor, OutputFile& output) : processor_(processor), output_(output) {
  output_.write(fmt::format(
      R"([{{"ph":"M","pid":1,"name":"process_name","args":{{"name":"{}, {} MHz: 1 us here is 1 cycle; pyrasim {}"}}}})",
      processor.basename(), processor.spec().clock_mhz, version()));
  for (std::size_t k = 0; k < processor.stages().size(); ++k) name_thread(k + 1, processor.stages()[k]->basename());
}

/// Threads are shown in the order of their numbers.
void ChromeTrace::name_thread(std::size_t number, std::string_view name) {
  output_.write(
      fmt::format(",\n"
                  R"({{"ph":"M","pid":1,"tid":{0},"name":"thread_name","args":{{"name":"{1}"}}}})"
                  ",\n"
                  R"({{"ph":"M","pid":1,"tid":{0},"name":"thread_sort_index","args":{{"sort_index":{0}}}}})",
                  number, name));
}

void ChromeTrace::span(const Span& span) {
  std::string record = fmt::format(
      ",\n"
      R"({{"ph":"X","pid":1,"tid":{},"ts":{},"dur":{},"name":"{}")",
      span.unit + 1, span.begin, span.end - span.begin, state_names[static_cast<std::size_t>(span.state)]);
  if (span.subject.ray != no_number) {
    record += fmt::format(R"(,"args":{{"ray":{})", span.subject.ray);
    if (span.subject.request != no_number) record += fmt::format(R"(,"request":{})", span.subject.request);
    record += '}';
  }
  output_.write(record += '}');  // in one piece: whatever ends the run, no part of a record is left
}

void ChromeTrace::fill(std::size_t fifo, Cycle at, std::size_t tokens) {
  output_.write(
      fmt::format(",\n"
                  R"({{"ph":"C","pid":1,"ts":{},"name":"{}","args":{{"tokens":{}}}}})",
                  at, processor_.fifos()[fifo]->basename(), tokens));
}

void ChromeTrace::stretch(const PathStretch& stretch) {
  const std::size_t thread = processor_.stages().size() + 1;
  if (!std::exchange(path_is_named_, true)) name_thread(thread, "critical path");
  output_.write(
      fmt::format(",\n"
                  R"({{"ph":"X","pid":1,"tid":{},"ts":{},"dur":{},"name":"{}"}})",
                  thread, stretch.begin, stretch.end - stretch.begin, text_of(processor_, stretch)));
}

void ChromeTrace::finish(Cycle) { output_.write("]\n"); }

}  // namespace pyrasim::hw
