#include "doctor/account.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::FakeSystem;
using ::testing::HasSubstr;

constexpr const char* kDevice = "/dev/ttyACM0";

/// A device of the group that new files get; alice is neither its owner nor root.
class Permission : public testing::Test {
 protected:
  Permission() {
    fake_.plug_in_mega();
    fake_.mode(kDevice, 0660);
    write_group("");
  }
  void write_group(const std::string& members) {
    fake_.write("/etc/group", "root:x:99991:\ndialout:x:" + std::to_string(gid()) + ":" + members +
                                  "\nusers:x:99992:alice\n");
  }
  gid_t gid() const { return fake_.system().device(kDevice)->gid; }
  Finding look(const Account& account) const {
    const Findings findings = permission_findings(fake_.system(), kDevice, account);
    return findings.size() == 1 ? findings[0] : Finding{Severity::kError, "not one", "", ""};
  }
  Account alice() const { return {"alice", ::geteuid() + 1000, {gid() + 1}}; }

  FakeSystem fake_;
};

TEST_F(Permission, IsGrantedToTheGroupOfTheSession) {
  Account account = alice();
  account.groups.push_back(gid());
  EXPECT_EQ(look(account).severity, Severity::kOk);
  EXPECT_EQ(look({"root", 0, {}}).severity, Severity::kOk);
}

TEST_F(Permission, IsRefusedToOthers) {
  const Finding refused = look(alice());
  EXPECT_EQ(refused.severity, Severity::kError);
  EXPECT_EQ(refused.name, "permission");
  EXPECT_THAT(refused.seen, HasSubstr("alice is not in group dialout"));
  EXPECT_THAT(refused.fix, HasSubstr("sudo adduser alice dialout"));
}

TEST_F(Permission, OfAGroupThatTheSessionDoesNotKnowYetNeedsANewSession) {
  write_group("bob,alice");
  const Finding stale = look(alice());
  EXPECT_EQ(stale.severity, Severity::kError);
  EXPECT_EQ(stale.name, "group");
  EXPECT_THAT(stale.fix, HasSubstr("log out and in again"));
  EXPECT_THAT(stale.fix, HasSubstr("newgrp dialout"));
}

TEST_F(Permission, ThatNoGroupHasIsNotMendedByAGroup) {
  fake_.mode(kDevice, 0600);
  const Finding closed = look(alice());
  EXPECT_EQ(closed.severity, Severity::kError);
  EXPECT_EQ(closed.name, "permission");
  EXPECT_THAT(closed.seen, HasSubstr("mode 0600"));
  EXPECT_THAT(closed.fix, HasSubstr("plug it in again"));
}

}  // namespace
}  // namespace tp100::doctor
