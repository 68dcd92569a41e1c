#pragma once
// What the user is told when something is refused.

#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace tp100::test {

/// The message, one line, of the UserError that `action` throws; empty if it throws none.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return {};
}

}  // namespace tp100::test
