// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <systemc>

#include "cli/command.h"
#include "error.h"
#include "files/standard_descriptors.h"
#include "text/printable.h"
#include "version.h"

namespace {

/// SystemC's reports go to stderr; stdout is for data. What is thrown is told by who catches it.
void report(const sc_core::sc_report& report, const sc_core::sc_actions& actions) {
  if (report.get_severity() == sc_core::SC_INFO) return;
  if ((actions & sc_core::SC_THROW) != 0) throw report;
  std::cerr << "pyrasim: SystemC: " << pyrasim::message_line(report.what()) << '\n';
}

int run(int argc, char** argv) {
  using namespace pyrasim;
  sc_core::sc_report_handler::set_handler(report);
  cli::set_command_line(argc, argv);
  cli::CommandParser parser(
      "pyrasim",
      "pyrasim: what does a picture cost, in rays, cycles and accuracy?\n"
      "Edge anti-aliasing in ray tracing by pixel pyramids, rendered and simulated cycle by cycle.",
      std::string(version()),
      "Exit codes: 0 done, 1 a run failed, 2 usage, 3 input, 4 deadlock or limit, 128 + N ended by signal N.");
  const cli::Command program = parser.root();
  cli::add_render_command(program);
  cli::add_simulate_command(program);
  cli::add_sweep_command(program);
  cli::add_whatif_command(program);
  cli::add_view_command(program);
  cli::add_budget_command(program);
  cli::add_study_command(program);
  cli::add_compare_command(program);
  cli::add_check_command(program);
  cli::add_diagram_command(program);
  cli::add_export_command(program);
  cli::add_pixel_command(program);
  cli::add_level_command(program);
  cli::add_formats_command(program);
  cli::add_completion_command(parser);
  cli::add_man_command(parser);
  try {
    if (const auto action = parser.parse(argc, argv)) (*action)();
    return exit_ok;
  } catch (const LimitError& error) {  // of several lines: the state of the machine
    std::cerr << "pyrasim: " << error.what() << '\n';
    return error.exit_code();
  } catch (const Error& error) {
    std::cerr << "pyrasim: " << message_line(error.what()) << '\n';
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    std::cerr << "pyrasim: out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << "pyrasim: " << message_line(error.what()) << '\n';
  }
  return exit_run_failed;
}

}  // namespace

int sc_main(int argc, char** argv) {
  const int code = run(argc, argv);
  if (std::cout.flush() || code != pyrasim::exit_ok) return code;
  std::cerr << "pyrasim: stdout: cannot write\n";
  return pyrasim::exit_run_failed;
}

int main(int argc, char** argv) {
  if (!pyrasim::open_standard_descriptors()) return pyrasim::exit_run_failed;
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  return sc_core::sc_elab_and_sim(argc, argv);
}
