#pragma once
// Runs code without the rights of root.

#include <grp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

namespace tp100::test {

/// Switches to an account other than root, which has all rights, during its lifetime.
class AsNobody {
 public:
  static constexpr uid_t kNobody = 65534;
  AsNobody() : groups_(static_cast<std::size_t>(::getgroups(0, nullptr))) {
    ::getgroups(static_cast<int>(groups_.size()), groups_.data());
    EXPECT_TRUE(::setgroups(0, nullptr) == 0 && ::setegid(kNobody) == 0 && ::seteuid(kNobody) == 0);
  }
  ~AsNobody() {
    EXPECT_TRUE(::seteuid(0) == 0 && ::setegid(0) == 0 &&
                ::setgroups(groups_.size(), groups_.data()) == 0);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  std::vector<gid_t> groups_;
};

}  // namespace tp100::test
