#pragma once
// The steps of a run, kept for replay.

#include <vector>

#include "core/step_record.h"
#include "messages/sink.h"

namespace tp100::test {

class StepKeeper : public messages::Sink {
 public:
  void take(const StepRecord& record) override { records.push_back(record); }
  std::vector<StepRecord> records;
};

}  // namespace tp100::test
