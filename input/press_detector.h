#pragma once

#include "input/bindings.h"

#include <bitset>
#include <vector>

namespace input {

/// Finds the actions that were pressed since the last sample, whichever device they came from.
class PressDetector {
  public:
    /// Actions that went from less than half to more than half pressed, in the order of the table.
    std::vector<Action> presses(const DeviceState& devices);

  private:
    std::bitset<static_cast<std::size_t>(Action::count)> down_;
};

} // namespace input
