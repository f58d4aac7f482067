// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/trace.h"

#include "hw_model/record/run_trace.h"
#include "hw_model/trace/chrome_trace.h"
#include "hw_model/trace/fst_trace.h"
#include "hw_model/trace/gtkw_save.h"
#include "hw_model/trace/kanata_trace.h"
#include "hw_model/trace/perfetto_trace.h"
#include "hw_model/trace/timeline.h"
#include "hw_model/trace/vcd_trace.h"
#include "hw_model/view/page_trace.h"

namespace pyrasim::hw {
namespace {

template <class Kind>
std::unique_ptr<Trace> make(Processor& processor, const TraceWindow& window, const nlohmann::ordered_json& /*run*/,
                            OutputFile& output) {
  return std::make_unique<Kind>(processor, window, output);
}

/// Of the whole frame, whatever the window.
template <class Kind>
std::unique_ptr<Trace> make_of_run(Processor& processor, const TraceWindow& /*window*/,
                                   const nlohmann::ordered_json& run, OutputFile& output) {
  return std::make_unique<Kind>(processor, run, output);
}

/// A writer, and the timeline that it is told.
template <class Writer>
class Written final : public Trace {
 public:
  Written(Processor& processor, const TraceWindow& window, OutputFile& output)
      : writer_(processor, output), timeline_(processor, window, writer_, output) {}
  void finish(Cycle cycles) override { timeline_.finish(cycles); }
  std::optional<Cycle> full() const override { return timeline_.full(); }

 private:
  Writer writer_;
  Timeline timeline_;
};

}  // namespace

const std::array<TraceFormat, 8> trace_formats{{{".vcd", true, true, true, make<VcdTrace>},
                                                {".fst", true, true, true, make<FstTrace>},
                                                {".pftrace", false, false, true, make<Written<PerfettoTrace>>},
                                                {".json", false, false, true, make<Written<ChromeTrace>>},
                                                {".kanata", false, false, true, make<KanataTrace>},
                                                {".gtkw", false, true, true, make<GtkwSave>},
                                                {".ptrace", false, false, false, make_of_run<RunTrace>},
                                                {".html", true, false, false, make_of_run<PageTrace>}}};

}  // namespace pyrasim::hw
