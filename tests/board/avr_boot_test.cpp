#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "avr_rig.h"
#include "core/error.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

TEST(AvrBoot, SaysHelloAsAMegaWithTheCauseOfTheReset) {
  AvrRig rig;
  const std::pair<PowerUp, wire::ResetCause> causes[] = {
      {PowerUp::kPowerOn, wire::ResetCause::kPowerOn},
      {PowerUp::kExternal, wire::ResetCause::kExternal},
      {PowerUp::kBrownOut, wire::ResetCause::kBrownOut},
      {PowerUp::kWatchdog, wire::ResetCause::kWatchdog}};
  for (const auto& [cause, reported] : causes) {
    ASSERT_TRUE(rig.boot(cause));
    const wire::Hello& hello = rig.hellos.back();
    EXPECT_EQ(hello.board, static_cast<std::uint8_t>(wire::BoardType::kMega2560));
    EXPECT_EQ(hello.schema, wire::kSchemaHash);
    EXPECT_EQ(hello.reset_cause, static_cast<std::uint8_t>(reported));
  }
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(AvrBoot, EachBootHasANonceOfItsOwn) {
  std::set<std::uint32_t> nonces;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    AvrRig rig({.seed = seed});
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(rig.boot(i % 2 == 0 ? PowerUp::kPowerOn : PowerUp::kExternal));
      nonces.insert(rig.nonce);
    }
  }
  EXPECT_EQ(nonces.size(), 12U);
  EXPECT_FALSE(nonces.contains(0));
}

TEST(AvrBoot, AByteThatHasNotLeftAtAResetNeverArrives) {
  AvrRig rig;
  rig.board.reset(PowerUp::kPowerOn, 0);
  while (rig.bytes.size() < 5) rig.run(1);
  const std::int64_t reset_ns = rig.now_ns;
  const std::size_t before = rig.bytes.size();
  rig.board.reset(PowerUp::kExternal, reset_ns);
  rig.run(10);
  // A byte may have left during the instruction that the reset ended.
  const std::size_t next = before + (rig.bytes.at(before).at_ns == reset_ns ? 1U : 0U);
  EXPECT_GT(rig.bytes.at(next).at_ns, reset_ns + 1'000'000);
}

TEST(AvrBoot, StandsStillWhileItIsHeldInReset) {
  AvrRig rig({.reset_hold_ns = 50'000'000});
  rig.board.reset(PowerUp::kPowerOn, 0);
  rig.run(50);
  EXPECT_TRUE(rig.bytes.empty());
  rig.run(20);
  EXPECT_FALSE(rig.bytes.empty());
}

TEST(AvrBoot, TheStockBootloaderIsSilentForASecondAndThenStartsTheFirmware) {
  AvrRig rig({.bootloader = true});
  rig.board.reset(PowerUp::kExternal, 0);
  rig.run(500);
  EXPECT_TRUE(rig.bytes.empty());
  rig.run(700);
  ASSERT_FALSE(rig.hellos.empty());
  // The bootloader clears the chip's record of the reset cause.
  EXPECT_EQ(rig.hellos.back().reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kUnknown));
}

TEST(AvrBoot, TheHexFileIsTheSameProgram) {
  AvrRig elf;
  AvrBoardSettings settings;
  settings.image = build_path("firmware/tp100.hex");
  AvrRig hex(settings);
  elf.boot();
  hex.boot();
  elf.run(300);
  hex.run(300);
  ASSERT_EQ(elf.bytes.size(), hex.bytes.size());
  for (std::size_t i = 0; i < elf.bytes.size(); ++i) {
    ASSERT_EQ(elf.bytes[i].at_ns, hex.bytes[i].at_ns);
    ASSERT_EQ(elf.bytes[i].value, hex.bytes[i].value);
  }
}

TEST(AvrBoot, RefusesWhatIsNoImage) {
  for (const std::string& path : {source_path("none.elf"), source_path("README.md"),
                                  source_path("CMakeLists.txt"), source_path()}) {
    AvrBoardSettings settings;
    settings.image = path;
    try {
      AvrBoard board(settings, nullptr);
      ADD_FAILURE() << path << " was accepted";
    } catch (const SetupError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(path));
    }
  }
}

}  // namespace
}  // namespace tp100::sim
