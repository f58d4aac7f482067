// SPDX-License-Identifier: Apache-2.0
// Commands that print what the command line's own definition makes: the manual page, and completion for a shell.
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/completion.h"
#include "cli/man_page.h"
#include "version.h"

namespace pyrasim::cli {

void add_completion_command(CommandParser& parser) {
  using Completion = std::string (*)(const CommandDescription&);
  auto completion = std::make_shared<Completion>(nullptr);
  const Command command =
      parser.root().add_command("completion", "Print a script that completes pyrasim's command line in a shell.",
                                [completion, &parser] { std::cout << (*completion)(parser.description()); });
  command
      .add_choice<Completion>("SHELL", *completion,
                              {{"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}},
                              "the shell: bash, zsh or fish")
      .required();
}

void add_man_command(CommandParser& parser) {
  parser.root().add_command("man", "Print the manual page, for man -l - to show.",
                            [&parser] { std::cout << man_page(parser.description(), version()); });
}

}  // namespace pyrasim::cli
