// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view/page.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "hw_model/record/compressed.h"
#include "hw_model/report/bottleneck.h"
#include "hw_model/view/page_text.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

using nlohmann::ordered_json;

constexpr int compression = 6;

/// RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = k; j < k + 3; ++j) {
      three = three << 8U | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += k + j > bytes.size() ? '=' : digits[three >> (18 - 6 * j) & 63U];
    }
  }
  return text;
}

/// As text that ends no script.
std::string script_text(const ordered_json& document) {
  std::string text = document.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string page_run(const Processor& processor, const FrameTables& tables, Cycle cycles, const ordered_json& run,
                     const std::string& name, std::string_view picture) {
  ordered_json document{{"pyrasim", version()},
                        {"name", name},
                        {"run", run},
                        {"clock_mhz", processor.spec().clock_mhz},
                        {"budget", processor.spec().budget()},
                        {"complete", processor.complete()},
                        {"cycles", cycles},
                        {"picture", base64(picture)}};
  if (processor.complete()) document["bottleneck"] = bottleneck_text(bottleneck_chain(processor));
  document.update(tables.description());
  return R"(<script type="application/json" class="run">)" + script_text(document) + "</script>\n" +
         R"(<script type="text/plain" class="columns">)" + base64(compressed(tables.bytes(), compression)) +
         "</script>\n";
}

void write_page(OutputFile& output, std::span<const std::string> runs) {
  for (const std::string_view piece : page_text) {
    if (piece != runs_mark) {
      output.write(piece);
      continue;
    }
    for (const std::string& run : runs) output.write(run);
  }
}

}  // namespace pyrasim::hw
