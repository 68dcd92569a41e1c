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
    for (const char* line : {"", "g", "o", "GO", "go go", "\n", "\ngo", "go\n", "yes", "..."})
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
    for (const char* line : {"", "go", "anything", "\n\n"})
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
