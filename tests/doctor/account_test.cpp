#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "../support/as_nobody.h"
#include "doctor/port_checks.h"
#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::expect_finding;
using test::FakeSystem;
using test::kDevice;
using ::testing::HasSubstr;

/// A device that belongs to the default group of new files; alice is not a member.
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
  /// The only finding for an account to which the kernel denies access.
  Findings look(const Account& account) const {
    Findings findings = permission_findings(fake_.system(), kDevice, account, false);
    EXPECT_EQ(findings.size(), 1U);
    return findings;
  }
  Account alice() const { return {"alice", {gid() + 1}}; }

  FakeSystem fake_;
};

TEST_F(Permission, ThatIsMissingIsAnErrorThatSaysHowToGetIt) {
  expect_finding(look(alice()), "permission", Severity::kError, "alice is not in group dialout",
                 "sudo adduser alice dialout");
  // Alice is in the group, but her session began before.
  write_group("bob,alice");
  expect_finding(look(alice()), "group", Severity::kError, "", "log out and in again");
  expect_finding(look(alice()), "group", Severity::kError, "", "newgrp dialout");
  // The session has the group, too: an access list forbids it.
  Account account = alice();
  account.groups.push_back(gid());
  expect_finding(look(account), "permission", Severity::kError, "", "getfacl /dev/ttyACM0");
  // The group itself has no permission.
  fake_.mode(kDevice, 0600);
  expect_finding(look(alice()), "permission", Severity::kError, "mode 0600", "plug it in again");
}

/// Lets `user` and the owner read and write `file`, as udev's "uaccess" does for the user at the
/// machine. Returns false and sets errno if the file system has no access lists.
bool let_in(const std::string& file, uid_t user) {
  constexpr std::uint16_t kRead = 4, kWrite = 2, kBoth = kRead | kWrite;
  constexpr std::uint32_t kNobodysId = 0xFFFFFFFFU;
  struct Entry {
    std::uint16_t tag, granted;
    std::uint32_t id;
  };
  struct {
    std::uint32_t version = 2;
    // The kernel requires this order: owner, user, group, mask, others.
    std::array<Entry, 5> entries;
  } list;
  list.entries = {Entry{0x01, kBoth, kNobodysId},
                  {0x02, kBoth, user},
                  {0x04, kBoth, kNobodysId},
                  {0x10, kBoth, kNobodysId},
                  {0x20, 0, kNobodysId}};
  return ::setxattr(file.c_str(), "system.posix_acl_access", &list, sizeof list, 0) == 0;
}

TEST_F(Permission, OfAnAccessListIsTheKernelsToSay) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can look as somebody else; run it as root";
  ASSERT_EQ(::chmod(fake_.system().file("/").c_str(), 0755), 0);
  const Account nobody{"nobody", {test::AsNobody::kNobody}};
  const auto looked = [&] {
    const test::AsNobody as_nobody;
    return permission_findings(fake_.system(), kDevice, nobody, fake_.system().usable(kDevice))
        .at(0);
  };
  EXPECT_THAT(looked().seen, HasSubstr("nobody is not in group dialout"));
  if (!let_in(fake_.system().file(kDevice), test::AsNobody::kNobody))
    GTEST_SKIP() << "no access lists on this file system (" << std::strerror(errno)
                 << "); give another TMPDIR";
  EXPECT_EQ(looked().severity, Severity::kOk) << looked().seen;
}

}  // namespace
}  // namespace tp100::doctor
