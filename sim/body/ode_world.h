#pragma once
// Owners for ODE's handles, and ODE's process-wide state behind one lock.

#include <ode/ode.h>

#include <cstdint>

namespace tp100::sim {

/// One world with its contact joints.
class OdeWorld {
 public:
  OdeWorld();
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  dWorldID id() const { return world_; }
  dJointGroupID contacts() const { return contacts_; }
  /// One step of `dt_s`; empties the contact group afterwards. ODE's solver shuffles its rows with
  /// a process-wide random generator: it is seeded with this world's own step number, under a lock,
  /// so that worlds in one process or in several threads never influence each other.
  void step(double dt_s);

  /// Messages that ODE's solver has printed in this process; 0 in a sound run.
  static std::uint64_t solver_messages();

 private:
  dWorldID world_;
  dJointGroupID contacts_;
  std::uint64_t steps_ = 0;
};

}  // namespace tp100::sim
