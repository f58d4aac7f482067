// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace pyrasim {

/// The message of the `ErrorType` that `action` throws; a text that no test expects when it throws none.
template <class ErrorType, class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const ErrorType& error) {
    return error.what();
  }
  return "(no error)";
}

}  // namespace pyrasim
