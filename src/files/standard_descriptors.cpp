// SPDX-License-Identifier: Apache-2.0
#include "files/standard_descriptors.h"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace pyrasim {

bool open_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest descriptor that is free is this one: those below it are open by now.
    if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDWR) != descriptor) return false;
  }
  return true;
}

}  // namespace pyrasim
