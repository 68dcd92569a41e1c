#pragma once
// A drive as identify takes it, collected from the steps of a run.

#include <vector>

#include "identify/drive.h"
#include "messages/sink.h"
#include "record/recording.h"

namespace tp100::identify {

/// The drive in a recording. Throws SetupError.
Drive recorded_drive(const record::Recording& recording);

class DriveSink : public messages::Sink {
 public:
  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

  /// Samples and camera poses in device time, of the last boot. Its name is empty.
  const Drive& drive() const { return drive_; }
  /// Exact poses at the drive's samples, where someone told; else all zero.
  const std::vector<Pose>& truth() const { return truth_; }

 private:
  Drive drive_;
  std::vector<HostNs> measured_ns_;  // of the samples
  std::vector<Pose> truth_;
};

}  // namespace tp100::identify
