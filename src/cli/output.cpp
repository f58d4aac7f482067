// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "error.h"
#include "files/output_file.h"
#include "image/write_image.h"
#include "run/interrupt.h"
#include "text/utf8.h"
#include "version.h"

namespace pyrasim::cli {
namespace {

std::string& stored_command_line() {
  static std::string line;
  return line;
}

/// What a shell reads between $' and ': each byte of a control character or of what is not UTF-8 as a number, so that
/// the line is text, and stays one line, wherever it is shown.
std::string escaped(std::string_view argument) {
  std::string text;
  for (std::size_t position = 0; position < argument.size();) {
    const std::size_t begin = position;
    const std::optional<char32_t> code_point = next_code_point(argument, position);
    const std::string_view bytes = argument.substr(begin, position - begin);
    if (!code_point || is_control(*code_point)) {
      for (const char byte : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    } else {
      if (bytes == "'" || bytes == "\\") text += '\\';
      text += bytes;
    }
  }
  return text;
}

/// An argument as a shell would take it.
std::string quoted(const std::string& argument) {
  constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./:,@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
  const std::string text = escaped(argument);
  return text == argument ? fmt::format("'{}'", text) : fmt::format("$'{}'", text);
}

}  // namespace

const std::string& command_line() { return stored_command_line(); }

void set_command_line(int argc, char** argv) {
  std::string line = "pyrasim";
  for (int k = 1; k < argc; ++k) line.append(1, ' ').append(quoted(argv[k]));
  stored_command_line() = line;
}

void ImageOutput::add(const Command& command) {
  command.add_text("-o,--output", file, "picture to write: .png or .pfm").type_name("IMAGE");
  command.add_choice<int>("--png-bits", format.bits, {{"8", 8}, {"16", 16}}, "bits a PNG sample");
  command.add_choice<bool>("--png-encoding", format.srgb, {{"srgb", true}, {"linear", false}},
                           "transfer function of a PNG, stated in the file");
}

struct TextOutput::File {
  explicit File(const std::string& name) : output(name) {}
  OutputFile output;
};

TextOutput::TextOutput(const std::string& file) {
  if (file != "-") file_ = std::make_unique<File>(file);
}
TextOutput::TextOutput(TextOutput&&) noexcept = default;
TextOutput::~TextOutput() = default;

void TextOutput::write(const std::string& text) {
  if (file_) {
    file_->output.write(text);
    file_->output.commit();
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw RunError("stdout: cannot write");
}

struct PictureOutput::File {
  explicit File(const std::string& name) : output(name) {}
  OutputFile output;
};

PictureOutput::PictureOutput(ImageOutput options) : options_(std::move(options)) {
  if (options_.file.empty()) return;
  image_file_kind(options_.file);
  file_ = std::make_unique<File>(options_.file);
}
PictureOutput::PictureOutput(PictureOutput&&) noexcept = default;
PictureOutput::~PictureOutput() = default;

void PictureOutput::write(const Image& image) {
  if (!file_) return;
  write_image(file_->output, image, options_.format,
              {{"Software", fmt::format("pyrasim {}", version())}, {"Comment", command_line()}});
}

Progress progress_bar(const std::string& label) {
  using Clock = std::chrono::steady_clock;
  const bool terminal = isatty(STDERR_FILENO) == 1;
  auto last = std::make_shared<Clock::time_point>(Clock::now());
  return [=](double share) {
    const bool go_on = !interrupted();
    const bool shown = share < 1 && go_on;
    const auto now = Clock::now();
    if (now - *last < (terminal ? std::chrono::milliseconds(100) : std::chrono::seconds(10)) && (!terminal || shown)) {
      return go_on;
    }
    *last = now;
    const int percent = static_cast<int>(share * 100);
    if (!terminal) {
      std::cerr << fmt::format("{}: {} %\n", label, percent);
      return go_on;
    }
    constexpr int width = 40;
    const auto filled = static_cast<std::size_t>(share * width);
    std::cerr << (shown ? fmt::format("\r{} [{:<{}}] {:3} %", label, std::string(filled, '#'), width, percent)
                        : fmt::format("\r{:{}}\r", "", label.size() + width + 10))
              << std::flush;
    return go_on;
  };
}

}  // namespace pyrasim::cli
