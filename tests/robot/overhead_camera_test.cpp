// The emulated overhead camera sends over the network to the daemon that controls the robot.

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../link/udp_receiver.h"
#include "../programs/process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

class OverheadCameraRun : public testing::Test {
 protected:
  OverheadCameraRun() {
    // The robot is pushed aside, which neither the encoders nor the gyro can measure.
    std::ifstream curve(source_path("config/courses/1-curve.toml"));
    std::ofstream(course()) << curve.rdbuf()
                            << "\n[[disturbance]]\nat_m = 0.3\nsideways_m = 0.04\nyaw_deg = 0.0\n"
                               "duration_s = 0.4\n";
    std::ofstream(folder_.file("fused.toml")) << "[estimation]\nsteering = \"fused\"\n"
                                                 "[control]\nmax_cross_track_m = 0.5\n";
  }
  std::string course() const { return folder_.file("1-curve.toml"); }
  std::string port() const { return folder_.file("tp100"); }
  std::string address() const { return "udp:" + std::to_string(udp_port_); }
  Words robot() const { return robot_on(course()); }
  Words robot_on(const std::string& course) const {
    return {"tp100-sim", "robot",   "--link",   port(),        "--course", course,
            "--robot",   "uniform", "--camera", "--camera-to", address()};
  }
  Words daemon() const {
    return {"tp100d",     "run",
            "--port",     port(),
            "--course",   course(),
            "--robot",    "uniform",
            "--config",   folder_.file("fused.toml"),
            "--camera",   address(),
            "--duration", "50",
            "--stats",    folder_.file("stats.json")};
  }
  nlohmann::json stats() const {
    return nlohmann::json::parse(std::ifstream(folder_.file("stats.json")));
  }

  /// Drives a run to its end and returns the robot's output. On a busy machine the robot may stop
  /// because no command arrived for 200 ms. This has nothing to do with the camera, so the run is
  /// repeated.
  std::string drive() {
    for (int attempt = 0;; ++attempt) {
      Process body(robot());
      EXPECT_TRUE(body.wait_for("linked from"));
      Process bridge(daemon());
      const int status = bridge.wait();
      body.signal(SIGTERM);
      EXPECT_EQ(body.wait(), 0);
      bool stalled = false;
      for (const char* cause : {"command_timeout", "samples_stale", "link_lost"})
        stalled = stalled || bridge.output().find(cause) != std::string::npos;
      if (status == 1 && stalled && attempt < 4) continue;
      EXPECT_EQ(status, 0) << bridge.output();
      return body.output();
    }
  }

  TemporaryFolder folder_;
  std::uint16_t udp_port_ = free_udp_port();
};

TEST_F(OverheadCameraRun, PushedAsideFusedSteersBackByTheDatagramsAndEndsWhereTheRobotIs) {
  const std::string output = drive();
  double x_m = 0.0, y_m = 0.0, yaw_deg = 0.0;
  const std::size_t at = output.find("robot: stands at");
  ASSERT_NE(at, std::string::npos) << output;
  ASSERT_EQ(std::sscanf(output.c_str() + at, "robot: stands at x %lf m, y %lf m, yaw %lf deg", &x_m,
                        &y_m, &yaw_deg),
            3);

  const nlohmann::json figures = stats();
  const nlohmann::json& fused = figures.at("fused");
  EXPECT_NEAR(fused.at("x_m").get<double>(), x_m, 0.006);
  EXPECT_NEAR(fused.at("y_m").get<double>(), y_m, 0.006);
  EXPECT_NEAR(std::remainder(fused.at("yaw_rad").get<double>() * 57.29578 - yaw_deg, 360.0), 0.0,
              1.0);
  EXPECT_NEAR(x_m, 0.0, 0.015) << "the robot must stop at the end of the path";
  EXPECT_NEAR(y_m, 0.7, 0.015);
  const nlohmann::json& odometry = figures.at("odometry");
  EXPECT_GT(
      std::hypot(odometry.at("x_m").get<double>() - x_m, odometry.at("y_m").get<double>() - y_m),
      0.025)
      << "only the camera can measure the disturbance";
  const nlohmann::json& camera = figures.at("camera");
  EXPECT_GT(camera.at("accepted").get<int>(), 300) << camera;
  EXPECT_GT(camera.at("used").get<int>(), 100) << camera;
  EXPECT_GT(camera.at("missing").get<int>(), 0) << "the camera drops 3 % of its images";
  EXPECT_EQ(camera.at("malformed").get<int>(), 0) << camera;
  EXPECT_EQ(camera.at("dropped").get<int>(), 0) << camera;
}

TEST_F(OverheadCameraRun, ABusyPortABadAddressAndAStandAreErrorsOfOneLine) {
  const UdpReceiver busy(udp_port_);
  Process body(robot());
  ASSERT_TRUE(body.wait_for("linked from"));
  const Finished taken = run(daemon());
  EXPECT_EQ(taken.status, 2);
  EXPECT_EQ(lines(taken.output), 1U) << taken.output;
  EXPECT_NE(taken.output.find("cannot listen"), std::string::npos) << taken.output;
  for (const Words& more : {Words{"--camera", "47100"}, {"--camera", "udp:1", "--setup", "stand"}})
    EXPECT_EQ(run(joined({"tp100d", "run", "--port", port()}, more)).status, 2);
  for (const char* option : {"--camera-to=udp:", "--camera=nothing"})
    EXPECT_EQ(run({"tp100-sim", "robot", option}).status, 2);
}

// With a wide goal for the intervals: only a few manoeuvres are driven.
TEST_F(OverheadCameraRun, AnIdentificationThatDrivesItselfAsksForNothing) {
  for (int attempt = 0;; ++attempt) {
    Process body(robot_on("1-straight"));
    ASSERT_TRUE(body.wait_for("linked from"));
    Process identify({"tp100d", "identify", "--drive", "--auto", "--narrow", "8", "--port", port(),
                      "--camera", address(), "--out", folder_.file("mine.toml")});
    const int status = identify.wait();
    body.signal(SIGTERM);
    EXPECT_EQ(body.wait(), 0);
    const std::string& output = identify.output();
    if (status == 1 && attempt < 4 && output.find("not completed") != std::string::npos) continue;
    ASSERT_EQ(status, 0) << output;
    EXPECT_NE(output.find("manoeuvre 2, "), std::string::npos) << output;
    EXPECT_NE(output.find("all intervals are narrow enough after"), std::string::npos) << output;
    EXPECT_EQ(output.find('?'), std::string::npos) << output;
    break;
  }
  const Finished check = run({"tp100d", "check", folder_.file("mine.toml")});
  EXPECT_EQ(check.status, 0) << check.output;
}

}  // namespace
}  // namespace tp100::test
