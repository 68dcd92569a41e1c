#include "sim/body/ode_body.h"

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <vector>

#include "core/arithmetic.h"
#include "sim/body/tracks.h"

namespace tp100::sim {
namespace {

// Half of ODE's default, 1.5 times as fast. The largest errors on the courses differ from those of
// 40 iterations by less than 0.4 mm; with 6 iterations by up to 9 mm.
constexpr int kSolverIterations = 10;

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

  /// Number of messages that ODE's solver has printed in this process; 0 in a sound run.
  static std::uint64_t solver_messages();

 private:
  dWorldID world_;
  dJointGroupID contacts_;
  std::uint64_t steps_ = 0;
};

std::atomic<std::uint64_t> g_messages{0};

std::mutex& ode_mutex() {
  static std::mutex mutex;
  return mutex;
}

[[gnu::format(printf, 2, 0)]] void count_message(int, const char* format, va_list arguments) {
  if (g_messages.fetch_add(1) == 0) {
    std::fputs("ODE: ", stderr);
    std::vfprintf(stderr, format, arguments);
    std::fputc('\n', stderr);
  }
}

[[noreturn, gnu::format(printf, 2, 0)]] void give_up(int number, const char* format,
                                                     va_list arguments) {
  count_message(number, format, arguments);
  std::abort();
}

void initialise_once() {
  static const bool done = [] {
    dInitODE2(0);
    dSetMessageHandler(count_message);
    dSetErrorHandler(give_up);
    dSetDebugHandler(give_up);
    return true;
  }();
  (void)done;
}

OdeWorld::OdeWorld() {
  const std::lock_guard lock(ode_mutex());
  initialise_once();
  world_ = dWorldCreate();
  contacts_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, 0.0, 0.0, -kGravityMps2);
  dWorldSetQuickStepNumIterations(world_, kSolverIterations);
}

OdeWorld::~OdeWorld() {
  const std::lock_guard lock(ode_mutex());
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
}

void OdeWorld::step(double dt_s) {
  const std::lock_guard lock(ode_mutex());
  thread_local const int allocated = dAllocateODEDataForThread(dAllocateFlagBasicData);
  static_cast<void>(allocated);
  dRandSetSeed(static_cast<unsigned long>(steps_++));
  dWorldQuickStep(world_, dt_s);
  dJointGroupEmpty(contacts_);
}

std::uint64_t OdeWorld::solver_messages() { return g_messages.load(); }

// Contact stiffness and damping, friction compliance: with these, slip and turning resistance stay
// the same to four digits for physics steps between 0.25 and 2 ms.
constexpr double kStiffnessNpm = 4000.0;
constexpr double kDampingNspm = 30.0;
constexpr double kErp =
    kPhysicsStepS * kStiffnessNpm / (kPhysicsStepS * kStiffnessNpm + kDampingNspm);
constexpr double kCfm = 1.0 / (kPhysicsStepS * kStiffnessNpm + kDampingNspm);
constexpr double kCreepFloor = 1e-5;
// The constants above hold for this mass; they are scaled so that heavier bodies sink in and creep
// at rest no more.
constexpr double kTheirMassKg = 0.922;
// At sliding speeds below this, the direction of slip is noise.
constexpr double kSlipDirectionMps = 1e-3;
constexpr int kSettleSteps = 500;
constexpr std::size_t kMaxContacts = 256;

Eigen::Vector3d to_vector(const dReal* v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d to_matrix(const dReal* r) {
  Eigen::Matrix3d m;
  m << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return m;
}

/// Direction in which the track points where it touches the ground.
Eigen::Vector3d forward_at(const Eigen::Vector3d& normal, const Eigen::Matrix3d& rotation) {
  Eigen::Vector3d forward = rotation.col(1).cross(normal);
  // A flank that rubs along a wall moves as the underside does.
  if (forward.squaredNorm() < 1e-2) {
    forward = rotation.col(0) - normal * normal.dot(rotation.col(0));
  }
  return forward.normalized();
}

void copy(const Eigen::Vector3d& from, std::array<double, 3>& to) {
  to = {from.x(), from.y(), from.z()};
}

}  // namespace

struct OdeBody::World {
  World(const course::EmulatedBody& v, bool stand, const course::Terrain& t, const UnevenFloor& f)
      : values(v), on_stand(stand), terrain(t), floor(f), tracks(v, t), feedback(kMaxContacts) {}

  /// From the reference point to the centre of mass, body frame.
  Eigen::Vector3d arm_m() const {
    return {values.com_forward_m, values.com_left_m, values.com_height_m};
  }
  void create(const Pose& start);
  void touch(double left_mps, double right_mps);
  /// Whether a track is worn smooth where it touches the ground this far ahead of the middle.
  bool slick(bool left, double ahead_m) const;
  void apply_disturbance();
  void observe();

  course::EmulatedBody values;
  bool on_stand;
  course::Terrain terrain;
  UnevenFloor floor;
  TrackContacts tracks;
  OdeWorld ode;
  dBodyID body = nullptr;
  std::vector<dJointFeedback> feedback;
  struct Traction {
    Eigen::Vector3d forward;  // in which the track pushes the ground back
    bool left;
  };
  std::vector<Traction> tractions;  // one per contact, in the order of `feedback`
  double left_travel_m = 0.0, right_travel_m = 0.0;
  Eigen::Vector3d last_velocity = Eigen::Vector3d::Zero();
  double disturbance_per_step_m = 0.0, disturbance_yaw_per_step = 0.0;
  int disturbance_steps = 0;  // to come
  bool disturbed = false;     // in the last step
  BodyState state{};
};

OdeBody::OdeBody(const course::EmulatedBody& values, const Pose& start, bool on_stand,
                 const course::Terrain& terrain, const UnevenFloor& floor)
    : world_(std::make_unique<World>(values, on_stand, terrain, floor)) {
  world_->create(start);
}
OdeBody::~OdeBody() = default;
OdeBody::OdeBody(OdeBody&&) noexcept = default;

bool OdeBody::disturbed() const { return world_->disturbance_steps > 0; }
const BodyState& OdeBody::state() const { return world_->state; }
std::uint64_t OdeBody::solver_messages() { return OdeWorld::solver_messages(); }

void OdeBody::World::create(const Pose& start) {
  body = dBodyCreate(ode.id());
  dMass mass;
  dMassSetBoxTotal(&mass, values.mass_kg, values.length_m, values.width_m, values.height_m);
  dBodySetMass(body, &mass);
  dMatrix3 rotation;
  dRFromAxisAndAngle(rotation, 0.0, 0.0, 1.0, start.yaw_rad);
  dBodySetRotation(body, rotation);
  if (start.pitch_rad != 0.0 || start.roll_rad != 0.0) {
    const Eigen::Quaterniond q = Eigen::AngleAxisd(start.yaw_rad, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(start.pitch_rad, Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(start.roll_rad, Eigen::Vector3d::UnitX());
    const dQuaternion quaternion = {q.w(), q.x(), q.y(), q.z()};
    dBodySetQuaternion(body, quaternion);
  }
  const Eigen::Matrix3d r = to_matrix(dBodyGetRotation(body));
  const Eigen::Vector3d com = Eigen::Vector3d(start.x_m, start.y_m, start.z_m) + r * arm_m();
  dBodySetPosition(body, com.x(), com.y(), com.z());
  state.pose.yaw_rad = start.yaw_rad;
  if (!on_stand) {
    for (int i = 0; i < kSettleSteps; ++i) {
      touch(0.0, 0.0);
      ode.step(kPhysicsStepS);
    }
    // An off-centre mass tilts the body while it settles: keep the tilt, undo the drift.
    const Eigen::Matrix3d settled = to_matrix(dBodyGetRotation(body));
    const double heading = std::atan2(settled(1, 0), settled(0, 0));
    const Eigen::Matrix3d tilted =
        Eigen::AngleAxisd(wrap_angle(start.yaw_rad - heading), Eigen::Vector3d::UnitZ()) * settled;
    const Eigen::Vector3d reach = tilted * arm_m();
    const Eigen::Quaterniond q(tilted);
    const dQuaternion quaternion = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, start.x_m + reach.x(), start.y_m + reach.y(), dBodyGetPosition(body)[2]);
    dBodySetQuaternion(body, quaternion);
    dBodySetLinearVel(body, 0, 0, 0);
    dBodySetAngularVel(body, 0, 0, 0);
  }
  observe();
  copy(to_matrix(dBodyGetRotation(body)).transpose() * Eigen::Vector3d(0.0, 0.0, kGravityMps2),
       state.specific_force_mps2);
}

bool OdeBody::World::slick(bool left, double ahead_m) const {
  if (values.slick_m <= 0.0) return false;
  const double length_m = 2.0 * (values.axle_spacing_m + kPi * values.wheel_radius_m);
  // The worn stretches of the two tracks are half a turn apart.
  const double along_m = ahead_m + (left ? left_travel_m : right_travel_m + length_m / 2.0);
  return along_m - length_m * std::floor(along_m / length_m) < values.slick_m;
}

void OdeBody::World::touch(double left_mps, double right_mps) {
  const Eigen::Vector3d position = to_vector(dBodyGetPosition(body));
  const Eigen::Matrix3d rotation = to_matrix(dBodyGetRotation(body));
  const Eigen::Vector3d velocity = to_vector(dBodyGetLinearVel(body));
  const Eigen::Vector3d rate = to_vector(dBodyGetAngularVel(body));
  const std::vector<TrackContact>& contacts = tracks.touch(position, rotation);

  const double faster = std::max(std::abs(left_mps), std::abs(right_mps));
  double stations = 0.0;
  for (const TrackContact& at : contacts) stations += at.stations;
  const double per_creep = faster * stations / (values.mass_kg * kGravityMps2);
  const double lighter = kTheirMassKg / values.mass_kg;
  tractions.clear();
  for (std::size_t i = 0; i < std::min(contacts.size(), kMaxContacts); ++i) {
    const TrackContact& at = contacts[i];
    const course::Surface* surface = terrain.surface_at(at.point_m.x(), at.point_m.y());
    const FloorVariation ground = floor.at(at.point_m.x(), at.point_m.y());
    const Eigen::Vector3d forward = forward_at(at.normal, rotation);
    const double deficit = (at.left ? values.track_deficit_left : values.track_deficit_right) +
                           (surface == nullptr ? 0.0 : surface->slip_offset) + ground.slip_offset;
    const Eigen::Vector3d track = forward * ((at.left ? left_mps : right_mps) * (1.0 - deficit));
    Eigen::Vector3d slip = velocity + rate.cross(at.point_m - position) - track;
    slip -= at.normal * at.normal.dot(slip);
    const Eigen::Vector3d along =
        slip.norm() > kSlipDirectionMps ? slip.normalized().eval() : forward;
    const Eigen::Vector3d across = at.normal.cross(along);

    dContact contact{};
    contact.surface.mode = dContactMu2 | dContactFDir1 | dContactSoftERP | dContactSoftCFM |
                           dContactMotion1 | dContactMotion2 | dContactSlip1 | dContactSlip2 |
                           dContactApprox1;
    contact.surface.mu = contact.surface.mu2 =
        values.friction * (surface == nullptr ? 1.0 : surface->friction_factor) *
        ground.friction_factor *
        (slick(at.left, rotation.col(0).dot(at.point_m - position)) ? values.slick_factor : 1.0);
    contact.surface.soft_erp = kErp;
    contact.surface.soft_cfm = kCfm * lighter / at.stations;
    contact.surface.motion1 = track.dot(along);
    contact.surface.motion2 = track.dot(across);
    contact.surface.slip1 = contact.surface.slip2 =
        ((at.left ? values.creep_left : values.creep_right) * per_creep + kCreepFloor * lighter) /
        at.stations;
    for (int k = 0; k < 3; ++k) {
      contact.geom.pos[k] = at.point_m[k];
      contact.geom.normal[k] = at.normal[k];
      contact.fdir1[k] = along[k];
    }
    contact.geom.depth = at.depth_m;
    const dJointID joint = dJointCreateContact(ode.id(), ode.contacts(), &contact);
    dJointAttach(joint, body, nullptr);
    dJointSetFeedback(joint, &feedback[i]);
    tractions.push_back({forward, at.left});
  }
}

void OdeBody::World::apply_disturbance() {
  disturbed = disturbance_steps > 0;
  if (!disturbed) return;
  --disturbance_steps;
  const Eigen::Matrix3d rotation = to_matrix(dBodyGetRotation(body));
  const Eigen::Vector3d position = to_vector(dBodyGetPosition(body));
  const Eigen::Vector3d arm = rotation * arm_m();
  const Eigen::AngleAxisd turn(disturbance_yaw_per_step, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d moved =
      position - arm + rotation.col(1) * disturbance_per_step_m + turn * arm;
  const Eigen::Quaterniond q(turn.toRotationMatrix() * rotation);
  const dQuaternion quaternion = {q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(body, moved.x(), moved.y(), moved.z());
  dBodySetQuaternion(body, quaternion);
}

void OdeBody::World::observe() {
  const Eigen::Matrix3d rotation = to_matrix(dBodyGetRotation(body));
  const Eigen::Vector3d arm = rotation * arm_m();
  const Eigen::Vector3d reference = to_vector(dBodyGetPosition(body)) - arm;
  Eigen::Vector3d velocity = to_vector(dBodyGetLinearVel(body));
  Eigen::Vector3d rate = to_vector(dBodyGetAngularVel(body));

  copy(rotation.transpose() *
           ((velocity - last_velocity) / kPhysicsStepS + Eigen::Vector3d(0.0, 0.0, kGravityMps2)),
       state.specific_force_mps2);
  last_velocity = velocity;
  if (disturbed) {
    rate.z() += disturbance_yaw_per_step / kPhysicsStepS;
    velocity += rotation.col(1) * disturbance_per_step_m / kPhysicsStepS;
  }
  copy(velocity - rate.cross(arm), state.velocity_mps);
  copy(rotation.transpose() * rate, state.rate_radps);

  Pose& pose = state.pose;
  pose.x_m = reference.x();
  pose.y_m = reference.y();
  pose.z_m = reference.z();
  pose.roll_rad = std::atan2(rotation(2, 1), rotation(2, 2));
  pose.pitch_rad = std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0));
  const double heading = std::atan2(rotation(1, 0), rotation(0, 0));
  pose.yaw_rad += wrap_angle(heading - pose.yaw_rad);
}

void OdeBody::step(double left_track_mps, double right_track_mps) {
  World& w = *world_;
  if (w.on_stand) return;
  w.touch(left_track_mps, right_track_mps);
  w.ode.step(kPhysicsStepS);
  w.left_travel_m += left_track_mps * kPhysicsStepS;
  w.right_travel_m += right_track_mps * kPhysicsStepS;
  w.state.left_load_n = w.state.right_load_n = 0.0;
  for (std::size_t i = 0; i < w.tractions.size(); ++i) {
    const double traction = to_vector(w.feedback[i].f1).dot(w.tractions[i].forward);
    (w.tractions[i].left ? w.state.left_load_n : w.state.right_load_n) += traction;
  }
  w.apply_disturbance();
  w.observe();
}

void OdeBody::turn_tracks(double left_m, double right_m) {
  world_->left_travel_m += left_m;
  world_->right_travel_m += right_m;
}

void OdeBody::disturbance(double sideways_m, double yaw_rad, double duration_s) {
  World& w = *world_;
  if (w.on_stand) return;
  w.disturbance_steps = std::max(1, static_cast<int>(std::lround(duration_s / kPhysicsStepS)));
  w.disturbance_per_step_m = sideways_m / w.disturbance_steps;
  w.disturbance_yaw_per_step = yaw_rad / w.disturbance_steps;
}

}  // namespace tp100::sim
