#pragma once
// The services of the protocol, and checks of the arguments of their requests, which are treated as
// hostile. Pure.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.h"
#include "messages/figures.h"
#include "messages/messages.h"
#include "server/controls.h"
#include "server/protocol.h"

namespace tp100::server {

using Arguments = std::vector<RequestField>;

enum class Service : std::uint32_t {
  kStart = 1,
  kHold,
  kStop,
  kRecordStart,
  kRecordStop,
  kDriveTake,
  kDrive,
  kDriveRelease,
  kChoose,
  kPlace,
  kFileSave,
  kFileDelete,
  kFileCheck,
  kPause,
  kResume,
  kParametersSave,
  kParametersRestore,
  kRunNote,
  kRunDelete,
  kRunReport,
  kRunCompare,
  kDoctor,
  kRunIdentify,
  kWheelsUpBegin,
  kWheelsUpWatch,
  kWatch,
};

/// All of them, in the enum's order.
const std::vector<ServiceText>& services();
/// Whether requests of the service set the robot in motion, and so carry what a person saw
/// (`stops`, `t_s`). A service that does not exist does not.
bool needs_consent(Service service);

// Each returns why the arguments are refused, in one line; empty: they are accepted.
/// Whether the service knows their names.
std::string unknown_argument(Service service, const Arguments& arguments);
/// Reads those of start; `here`: start where the last run ended.
std::string read_start(const Arguments& arguments, bool& here);
/// Reads that of record_start; it may stay empty.
std::string read_record_name(const Arguments& arguments, std::string& name);
/// Reads those of choose.
std::string read_choice(const Arguments& arguments, SetupChoice& choice);
/// Reads those of place; nothing: at the course's start.
std::string read_place(const Arguments& arguments, std::optional<Pose>& at);
/// Reads those of file_save, file_delete and file_check.
std::string read_file(const Arguments& arguments, SetupFile& file);
/// Reads those of run_note, run_delete, run_report, run_compare and run_identify.
std::string read_run(Service service, const Arguments& arguments, RunRequest& request);

/// Reads those of parameters_save: names of `known` that may be saved, each with an allowed value.
std::string read_parameters(const Arguments& arguments,
                            const std::vector<messages::ParameterText>& known,
                            ParameterSave& asked);
/// Reads that of doctor.
std::string read_part(const Arguments& arguments, DoctorPart& part);
/// Checks that of wheels_up_begin: a person has confirmed that the tracks are free.
std::string read_wheels_up(const Arguments& arguments);
/// Reads those of wheels_up_watch.
std::string read_watch(const Arguments& arguments, WheelsUpWatch& watch);
/// Reads that of parameters_restore.
std::string read_check(const Arguments& arguments, bool& check);

/// The response of stop.
std::string stop_answer(const messages::StopFigures& stop);

}  // namespace tp100::server
