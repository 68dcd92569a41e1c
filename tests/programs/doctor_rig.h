#pragma once
// `tp100d doctor` on emulated robots with defects: the real programs, connected by a
// pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.h"

namespace tp100::test {

class Doctor : public testing::Test {
 protected:
  std::string port() const { return folder_.file("tp100"); }
  /// Starts a robot with the further arguments `more`.
  void start_robot(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"tp100-sim", "robot", "--link", port()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    robot_ = std::make_unique<Process>(arguments);
    ASSERT_TRUE(robot_->wait_for("linked from")) << robot_->output();
  }
  void expect_motors_never_on() {
    EXPECT_THAT(robot_->output(),
                ::testing::Not(::testing::AnyOf(::testing::HasSubstr("motors on"),
                                                ::testing::HasSubstr("motors off"))));
  }
  /// Result of the doctor. `status` is -1 if it printed no JSON.
  struct Examined {
    int status = -1;
    nlohmann::json report;
    /// The first finding of that name; null if there is none.
    nlohmann::json finding(const std::string& name) const {
      for (const nlohmann::json& row : report.at("findings")) {
        if (row.at("name") == name) return row;
      }
      return nullptr;
    }
    /// "SEVERITY NAME: SEEN; FIX".
    std::string line(const std::string& name) const {
      const nlohmann::json row = finding(name);
      if (row.is_null()) return report.dump();
      return row.at("severity").get<std::string>() + " " + name + ": " +
             row.at("seen").get<std::string>() + "; " + row.at("fix").get<std::string>();
    }
  };
  Examined examine(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"tp100d", "doctor", "--json", "--port", port()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = run(arguments);
    const nlohmann::json report = nlohmann::json::parse(finished.output, nullptr, false);
    EXPECT_FALSE(report.is_discarded()) << finished.output;
    return {report.is_discarded() ? -1 : finished.status, report};
  }

  TemporaryFolder folder_;
  std::unique_ptr<Process> robot_;
};

}  // namespace tp100::test
