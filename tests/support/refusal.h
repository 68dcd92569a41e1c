#pragma once
// What the user is told when something is refused.

#include <string>

#include "core/error.h"

namespace tp100::test {

/// The message of the SetupError that `action` throws; empty if it throws none.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

}  // namespace tp100::test
