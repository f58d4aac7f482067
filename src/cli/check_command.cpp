// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "hw_model/machine_spec.h"
#include "json/json_file.h"
#include "scene/load_scene.h"
#include "scene/nff_scene.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

void report(const std::string& file, const Scene& scene) {
  print_warnings(scene);
  std::cout << fmt::format("{}: a scene of {} on {}x{} pixels\n", one_line(file),
                           counted(scene.objects.size(), "object"), scene.camera.screen.columns,
                           scene.camera.screen.rows);
}

void check(const std::string& file) {
  if (is_nff(file)) return report(file, load_nff(file));
  const nlohmann::json document = read_json_file(file);
  if (document.is_object() && (document.contains("camera") || document.contains("objects"))) {
    return report(file, read_scene(file, document));
  }
  const hw::MachineSpec spec = hw::read_machine(file, document);
  std::cout << fmt::format("{}: machine {} with {} at {} MHz\n", one_line(file), excerpt(spec.name),
                           counted(static_cast<std::uint64_t>(spec.intersection_units), "intersection unit"),
                           spec.clock_mhz);
}

}  // namespace

void add_check_command(const Command& program) {
  auto file = std::make_shared<std::string>();
  const Command command = program.add_command("check", "Read a scene or machine file and say what is wrong with it.",
                                              [file] { check(*file); });
  command.add_text("FILE", *file, "scene file (JSON or NFF) or machine file (JSON)").required();
}

}  // namespace pyrasim::cli
