#pragma once
// Parts that the page of one run and that of several have in common: texts and rows of tables.

#include <cstdint>
#include <optional>
#include <string>

#include "messages/figures.h"
#include "report/html_page.h"
#include "report/recorded_run.h"
#include "report/report_figures.h"
#include "report/result_text.h"

namespace tp100::report {

/// `value` with `count` decimals; "-" if it is not finite.
std::string decimals(double value, int count);
/// `text` on one line of bounded length.
std::string plain(const std::string& text);
/// Course, robot, set-up.
std::string title_of(const RecordedRun& run);
/// When the run was driven, if the recording has the date.
std::string date_of(const RecordedRun& run);
/// Program and version that drove it.
std::string program_of(const RecordedRun& run);
/// "completed", or why it was not.
Cell outcome(const RecordedRun& run);

/// Head and rows of errors against the truth.
extern const Rows::value_type kPoseHead;
Rows::value_type pose_row(const std::string& name, const PoseErrors& errors);
/// Adds a row for each simpler form of the model whose errors are known.
void add_baselines(Rows& rows, const std::string& run, const RunFigures& judged);
extern const char* const kBaselinesCaption;

/// Head and row of a distribution of durations.
extern const Rows::value_type kDurationHead;
Rows::value_type duration_row(const std::string& name, const messages::Durations& durations);

void add_figures(HtmlPage& page, const std::vector<Figure>& figures);

}  // namespace tp100::report
