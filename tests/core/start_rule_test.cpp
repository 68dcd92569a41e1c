#include "core/start_rule.h"

#include <gtest/gtest.h>

#include "core/board.h"

namespace tp100 {
namespace {

TEST(StartRule, OnlyTheFirstRunStartsByItselfAndNeverAsAService) {
  EXPECT_EQ(start_consent({}), StartConsent::kEnter);
  EXPECT_EQ(start_consent({.emulator = true}), StartConsent::kNone);
  EXPECT_EQ(start_consent({.go = true}), StartConsent::kNone);
  EXPECT_EQ(start_consent({.emulator = true, .service = true}), StartConsent::kEnter);
  EXPECT_EQ(start_consent({.go = true, .service = true}), StartConsent::kEnter);
}

TEST(StartRule, OnceSomethingHasRunNothingButTheWordStarts) {
  for (int i = 0; i < 16; ++i) {
    const StartFacts facts{.emulator = (i & 1) != 0,
                           .go = (i & 2) != 0,
                           .service = (i & 4) != 0,
                           .has_run = true,
                           .ran_before = (i & 8) != 0};
    const StartConsent consent = start_consent(facts);
    EXPECT_EQ(consent, StartConsent::kWord) << i;
    EXPECT_EQ(meaning_of("go", consent, false), LineMeaning::kStart);
    EXPECT_EQ(meaning_of("go start", consent, false), LineMeaning::kStartPlaced);
    EXPECT_EQ(meaning_of("go here", consent, false), LineMeaning::kStartHere);
    for (const char* line :
         {"", "g", "o", "GO", "go go", "\n", "\ngo", "go\n", "here", "go start here", "..."})
      EXPECT_EQ(meaning_of(line, consent, false), LineMeaning::kStop) << line;
  }
  // Whoever typed --go may no longer watch the next drive of an identification.
  EXPECT_EQ(start_consent({.ran_before = true}), StartConsent::kWord);
  EXPECT_EQ(start_consent({.go = true, .ran_before = true}), StartConsent::kWord);
  EXPECT_EQ(start_consent({.emulator = true, .ran_before = true}), StartConsent::kNone);
}

TEST(StartRule, WhateverIsTypedDuringARunIsStop) {
  for (const StartConsent consent :
       {StartConsent::kNone, StartConsent::kEnter, StartConsent::kWord}) {
    for (const char* line : {"", "go", "go here", "anything", "\n\n"})
      EXPECT_EQ(meaning_of(line, consent, true), LineMeaning::kStop) << line;
  }
}

TEST(StartRule, TheFirstStartIsOneEnterOrTheWord) {
  EXPECT_EQ(meaning_of("", StartConsent::kEnter, false), LineMeaning::kStart);
  EXPECT_EQ(meaning_of("go", StartConsent::kEnter, false), LineMeaning::kStart);
  // Several lines at once are not a deliberate answer.
  EXPECT_EQ(meaning_of("\n", StartConsent::kEnter, false), LineMeaning::kNothing);
  EXPECT_EQ(meaning_of("yes", StartConsent::kEnter, false), LineMeaning::kNothing);
}

// Otherwise the run would be steered by a pose that the robot does not have.
TEST(StartRule, WhereTheRobotStandsIsAskedOnceItMayBeElsewhereThanAtTheStart) {
  const Pose start{.x_m = 0.5, .y_m = -0.2, .yaw_rad = 3.0};
  const PlaceFacts there{.start = start, .shown = start, .on_path = true};
  EXPECT_FALSE(start_places(there).asks());
  PlaceFacts facts = there;
  facts.shown.x_m += 0.029;
  facts.shown.yaw_rad += 4.0 * kPi - 2.9 * kRadPerDeg;
  EXPECT_FALSE(start_places(facts).asks());
  facts.shown.x_m += 0.002;
  EXPECT_TRUE(start_places(facts).asks());
  facts = there;
  facts.shown.yaw_rad -= 3.1 * kRadPerDeg;
  EXPECT_TRUE(start_places(facts).asks());
  facts = there;
  facts.moved = true;
  EXPECT_TRUE(start_places(facts).asks());
  EXPECT_EQ(refusal_of(start_places(facts), OperatorRequest::kStartPlaced), StartRefusal::kNone);
  EXPECT_EQ(refusal_of(start_places(facts), OperatorRequest::kDrive), StartRefusal::kNone);
  facts = there;
  facts.seen = Pose{};
  EXPECT_EQ(start_places(facts).unsaid, StartRefusal::kWhere);
  EXPECT_EQ(start_places(facts).placed, StartRefusal::kNone) << "the camera saw it before";
  facts.seen_now = true;
  EXPECT_EQ(start_places(facts).placed, StartRefusal::kSeenElsewhere);
  EXPECT_EQ(start_places(facts).here, StartRefusal::kNone);
  facts.on_path = false;
  EXPECT_EQ(start_places(facts).here, StartRefusal::kOffPath);
}

constexpr auto kMega = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
constexpr auto kNative = static_cast<std::uint8_t>(wire::BoardType::kNative);
constexpr auto kFake = static_cast<std::uint8_t>(wire::BoardType::kFakeRobot);
constexpr auto kUnknown = static_cast<std::uint8_t>(wire::BoardType::kUnknown);

TEST(Board, APortIsPhysicalUnlessPtyAndHelloProveAnEmulator) {
  EXPECT_TRUE(is_emulator(true, kNative));
  // A pty may be a serial server with a real robot behind it, or the robot may be a user's own.
  EXPECT_FALSE(is_emulator(true, kMega));
  EXPECT_FALSE(is_emulator(true, kUnknown));
  EXPECT_FALSE(is_emulator(true, 77));
  EXPECT_FALSE(is_emulator(false, kNative));
  EXPECT_FALSE(is_emulator(false, kMega));
}

TEST(Board, ARobotInsideItsBoardIsShownAsSimulatedButStartsAsARealOne) {
  EXPECT_EQ(robot_kind(true, kNative), RobotKind::kEmulated);
  EXPECT_EQ(robot_kind(false, kNative), RobotKind::kPhysical);
  EXPECT_EQ(robot_kind(false, kMega), RobotKind::kPhysical);
  for (const bool pseudo_terminal : {false, true}) {
    EXPECT_EQ(robot_kind(pseudo_terminal, kFake), RobotKind::kSimulated);
    EXPECT_FALSE(is_emulator(pseudo_terminal, kFake));
  }
}

}  // namespace
}  // namespace tp100
