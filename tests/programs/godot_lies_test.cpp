// The engine as a world with false answers: a proxy falsifies them on their way to the bridge, in
// lockstep.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "godot.h"
#include "liar.h"

namespace tp100::test {
namespace {

using Json = nlohmann::json;
using Datagrams = std::vector<std::string>;

Json changed(Json answer, const Json& patch) {
  answer.merge_patch(patch);
  return answer;
}

class GodotLies : public Godot, public testing::WithParamInterface<const char*> {
 protected:
  std::string authority() const { return GetParam(); }
  /// The figures of a run in which the engine's answers pass through `liar`.
  Json drive_by(const Liar& liar, const std::string& course) const {
    const Finished driven = run({"tp100-sim", "course", course, "--json", "--world", liar.address(),
                                 "--config", config("authority = \"" + authority() + "\"\n")});
    Json figures = Json::parse(driven.output, nullptr, false);
    EXPECT_TRUE(figures.is_object()) << driven.output;
    EXPECT_GT(liar.lies(), 0);
    return figures.is_object() ? figures : Json::object();
  }
  /// Why a run on a short course ended.
  std::string cause(const Liar::Lie& lie) const {
    const std::string course = short_course(folder_);
    const Engine engine(course);
    const Liar liar(engine.address(), lie);
    const Json figures = drive_by(liar, course);
    EXPECT_FALSE(figures.value("completed", true));
    return figures.value("cause", "");
  }
};

/// Defects of an answer that also requests STOP, so that a bridge that accepts it would stop.
struct Falsified {
  const char* name;
  Json patch;
};

// Each false answer is sent just before the true one.
TEST_P(GodotLies, AnAnswerThatCannotBeIsNotAccepted) {
  const std::string course = short_course(folder_);
  const Engine engine(course);
  std::size_t at = 0;
  std::atomic<const char*> told = "";
  std::atomic<Liar*> everybody = nullptr;
  Liar liar(engine.address(), [&](const Json& answer) -> Datagrams {
    const std::uint64_t seq = answer["seq"], ack = answer["ack"], session = answer["session"];
    const double now_s = static_cast<double>(seq);
    const std::vector<Falsified> all = {
        {"of another session", {{"session", session + 1}}},
        {"of another version", {{"v", 2}}},
        {"of a tick long ago", {{"ack", ack - 5}}},
        {"of a tick that never was", {{"ack", ack + 1000}}},
        {"said once more", {{"seq", seq - 1}}},
        {"back in time", {{"timestamp", now_s - 5.0}}},
        {"no number for the height", {{"ground", {{"z", "high"}}}}},
        {"no height", {{"ground", {{"z", nullptr}}}}},
        {"above the clouds", {{"ground", {{"z", 150.0}}}}},
        {"upside down", {{"ground", {{"roll", 2.0}}}}},
        {"on its tail", {{"ground", {{"pitch", -2.0}}}}},
        {"a step as high as a house", {{"contact", {{"step", 3.0}}}}},
        {"blocked, but not yes or no", {{"contact", {{"blocked", "perhaps"}}}}},
        {"far away", {{"pose", {{"pos", {2000.0, 0.0, 0.0}}, {"rpy", {0.0, 0.0, 0.0}}}}}},
        {"a pose without attitude", {{"pose", {{"pos", {0.0, 0.0, 0.0}}, {"rpy", nullptr}}}}},
        {"longer than a datagram may be", {{"more", std::string(1200, 'x')}}},
        {"not a number", Json::object()},
        {"half of it", Json::object()},
        {"from elsewhere", Json::object()},
    };
    const Falsified& lie = all[at++ % all.size()];
    told = lie.name;
    const std::string name = lie.name;
    const Json stop = changed(answer, {{"cmd", {{"estop", true}}}, {"timestamp", now_s}});
    std::string text = changed(stop, lie.patch).dump();
    if (name == "not a number") text.replace(text.find("\"z\":") + 4, 1, "NaN,\"y\":1");
    if (name == "half of it") text.resize(text.size() / 2);
    const std::string truth = changed(answer, {{"timestamp", now_s}}).dump();
    if (name != "from elsewhere") return {text, truth};
    everybody.load()->send_from_elsewhere(text);
    return {truth};
  });
  everybody = &liar;
  const Json figures = drive_by(liar, course);
  EXPECT_TRUE(figures.value("completed", false)) << "accepted: " << told.load() << "; " << figures;
  EXPECT_GT(liar.lies(), 200) << "not every lie was told ten times";
}

TEST_P(GodotLies, AnswersFrozenAtOneTickAreALostWorld) {
  std::uint64_t first = 0;
  EXPECT_EQ(cause([&](const Json& answer) -> Datagrams {
              if (first == 0) first = answer["ack"];
              return {changed(answer, {{"ack", first}}).dump()};
            }),
            "world_lost");
}

TEST_P(GodotLies, NothingButHeightsThatCannotBeIsALostWorld) {
  EXPECT_EQ(cause([](const Json& answer) -> Datagrams {
              return {changed(answer, {{"ground", {{"z", 150.0}}}}).dump()};
            }),
            "world_lost");
}

TEST_P(GodotLies, ARobotThatIsSaidToBeBlockedIsImmobilised) {
  EXPECT_EQ(cause([](const Json& answer) -> Datagrams {
              return {changed(answer, {{"contact", {{"blocked", true}}}}).dump()};
            }),
            "immobilised");
}

INSTANTIATE_TEST_SUITE_P(Authorities, GodotLies, testing::Values("bridge", "world"),
                         [](const auto& param) { return std::string(param.param); });

/// Only a world that owns the pose can falsify it.
class GodotPoseLies : public GodotLies {};

TEST_P(GodotPoseLies, AJumpOffThePathEndsTheRun) {
  EXPECT_EQ(cause([](Json answer) -> Datagrams {
              answer["pose"]["pos"][1] = answer["pose"]["pos"][1].get<double>() + 0.35;
              return {answer.dump()};
            }),
            "world_against_odometry");
}

TEST_P(GodotPoseLies, ARobotThatIsSaidToFaceBackwardsEndsTheRun) {
  EXPECT_EQ(cause([](Json answer) -> Datagrams {
              answer["pose"]["rpy"][2] = answer["pose"]["rpy"][2].get<double>() + 3.1;
              return {answer.dump()};
            }),
            "world_against_odometry");
}

// The robot's tracks run, its gyro and encoders agree, but its position never changes.
TEST_P(GodotPoseLies, APoseThatStandsStillEndsTheRun) {
  Json frozen;
  EXPECT_EQ(cause([&](Json answer) -> Datagrams {
              if (frozen.is_null()) frozen = answer["pose"];
              answer["pose"] = frozen;
              return {answer.dump()};
            }),
            "world_against_odometry");
}

INSTANTIATE_TEST_SUITE_P(Authorities, GodotPoseLies, testing::Values("world"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace tp100::test
