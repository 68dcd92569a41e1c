#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "app/commands.h"
#include "identify/drive_file.h"
#include "report/run_result.h"
#include "ros2/bag.h"
#include "runs/run_folder.h"
#include "text/atomic_file.h"
#include "text/base64.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

using record::Recording;

/// The time of the run: from its first to its last step, or everything if no run began.
struct Window {
  HostNs from_ns = std::numeric_limits<HostNs>::max();
  HostNs to_ns = std::numeric_limits<HostNs>::min();
  bool ran = false;  ///< a run began
  bool has(HostNs at) const { return at >= from_ns && at <= to_ns; }
};

Window window_of(const Recording& recording) {
  Window run{.ran = true}, all;
  recording.visit({.step = [&](const StepRecord& record) {
    const auto widen = [&](Window& window) {
      window.from_ns = std::min(window.from_ns, record.now_ns);
      window.to_ns = record.now_ns;
    };
    widen(all);
    if (record.snapshot.run_state == RunState::kRunning) widen(run);
  }});
  return run.from_ns <= run.to_ns ? run : all;
}

using Write = std::function<void(std::string_view)>;

/// Calls `each` with the snapshot of every step in the window that received a sample.
template <class Each>
void for_each_pose(const Recording& recording, const Window& window, Each each) {
  HostNs last = std::numeric_limits<HostNs>::min();
  recording.visit({.step = [&](const StepRecord& record) {
    const Snapshot& snapshot = record.snapshot;
    const HostNs at = snapshot.sample.measured_ns;
    if (record.inputs.samples.empty() || !window.has(at) || at <= last) return;
    last = at;
    each(to_s(at - recording.start_ns()), snapshot);
  }});
}

/// The true poses within the window by their time; empty if they are not recorded.
std::map<HostNs, Pose> truth_of(const Recording& recording, const Window& window) {
  std::map<HostNs, Pose> truth;
  recording.visit({.truth = [&](HostNs at, const Pose& pose) {
    if (window.has(at)) truth.emplace(at, pose);
  }});
  return truth;
}

void append(std::string& line, const Pose& pose) {
  visit_fields([&line](auto, double value) { line += "," + text::shortest(value); }, pose);
}

void write_poses(const Recording& recording, const Window& window, const Write& write) {
  const std::map<HostNs, Pose> truth = truth_of(recording, window);
  std::string line = "t_s";
  for (const PoseSource source : kPoseSources) line += report::pose_columns(to_string(source));
  line += report::pose_columns("world");
  if (!truth.empty()) line += report::pose_columns("truth");
  write(line +
        ",left_mps,right_mps,slip_left,slip_right,cross_track_m,heading_error_rad,progress_m,"
        "desired_yaw_rad,speed_mps\n");
  for_each_pose(recording, window, [&](double t_s, const Snapshot& snapshot) {
    line = text::shortest(t_s);
    for (const Estimate& estimate : snapshot.estimates.values) append(line, estimate.pose);
    append(line, snapshot.world);
    if (!truth.empty()) {
      const auto found = truth.find(snapshot.sample.measured_ns);
      if (found != truth.end())
        append(line, found->second);
      else
        line += ",,,,,,";
    }
    for (const double value :
         {snapshot.left_mps, snapshot.right_mps, snapshot.slip_left, snapshot.slip_right,
          snapshot.cross_track_m, snapshot.heading_error_rad, snapshot.progress_m,
          snapshot.command.desired_yaw_rad, snapshot.command.speed_mps})
      line += "," + text::shortest(value);
    write(line + "\n");
  });
}

/// An output file that is announced once it is written.
class Product {
 public:
  Product(const std::filesystem::path& folder, const std::string& name)
      : path_((folder / name).string()), file_(path_) {}
  text::FileReplacement& file() { return file_; }
  void commit() {
    file_.commit();
    std::printf("%s\n", path_.c_str());
  }

 private:
  std::string path_;
  text::FileReplacement file_;
};

void export_csv(const Recording& recording, const Window& window,
                const std::filesystem::path& folder) {
  Product samples(folder, "samples.csv");
  samples.file().write(
      identify::write_drive(identify::recorded_drive(recording, recording.start_ns())));
  samples.commit();
  Product poses(folder, "poses.csv");
  write_poses(recording, window, [&](std::string_view text) { poses.file().write(text); });
  poses.commit();
}

void export_tum(const Recording& recording, const Window& window,
                const std::filesystem::path& folder) {
  PerSource<std::optional<Product>> products;
  for (const PoseSource source : kPoseSources)
    products[source].emplace(folder, std::string(to_string(source)) + ".tum");
  for_each_pose(recording, window, [&](double t_s, const Snapshot& snapshot) {
    for (const PoseSource source : kPoseSources)
      products[source]->file().write(report::tum_line(t_s, snapshot.estimates[source].pose));
  });
  for (std::optional<Product>& product : products.values) product->commit();

  const std::map<HostNs, Pose> poses = truth_of(recording, window);
  if (poses.empty()) return;
  Product truth(folder, "truth.tum");
  for (const auto& [at, pose] : poses)
    truth.file().write(report::tum_line(to_s(at - recording.start_ns()), pose));
  truth.commit();
}

void export_bag(const Recording& recording, const std::string& folder) {
  const config::RunSetup run = config::parse_run(recorded_files(recording));
  ros2::Marks marks;
  recording.visit({.message =
                       [&](const std::string&, std::uint64_t unix_ns, std::string_view text) {
                         const auto event = nlohmann::json::parse(text, nullptr, false);
                         if (!event.is_object() || event.value("kind", nlohmann::json()) != "mark")
                           return;
                         const nlohmann::json words = event.value("text", nlohmann::json());
                         if (words.is_string()) marks.emplace(unix_ns, words.get<std::string>());
                       },
                   .topics = {"/event"}});
  const messages::PublishClock clock{.start_ns = recording.start_ns(),
                                     .start_unix_ns = recording.start_unix_ns()};
  for (const runs::Mark& mark : runs::marks_of(runs::note_beside(recording.path())))
    marks.emplace(clock.unix_ns(recording.start_ns() + from_s(mark.t_s)), mark.text);
  for (const std::string& path :
       ros2::write_bag(recording, config::run_context_of(run), marks, folder))
    std::printf("%s\n", path.c_str());
}

constexpr const char* kImageTopic = "/camera/image";  // CHANNELS.md

/// The image of a foxglove.CompressedImage, or nothing.
std::optional<std::string> jpeg_of(std::string_view json) {
  const auto message = nlohmann::json::parse(json, nullptr, false);
  if (!message.is_object() || message.value("format", nlohmann::json()) != "jpeg")
    return std::nullopt;
  const auto data = message.find("data");
  if (data == message.end() || !data->is_string()) return std::nullopt;
  return text::from_base64(data->get_ref<const std::string&>());
}

void export_images(const Recording& recording, const std::filesystem::path& folder) {
  text::make_folder(folder);
  // In the format in which tp100-camera reads a folder of images.
  Product times(folder, "times.csv");
  times.file().write("file,t_s\n");
  const std::int64_t start_unix_ns = recording.start_unix_ns();
  int images = 0;
  recording.visit({.message =
                       [&](const std::string&, std::uint64_t unix_ns, std::string_view json) {
                         const auto jpeg = jpeg_of(json);
                         if (!jpeg) return;
                         const std::string name = text::format("image-%06d.jpg", ++images);
                         text::write_file((folder / name).string(), *jpeg);
                         const auto at = static_cast<std::int64_t>(unix_ns) - start_unix_ns;
                         times.file().write(name + "," + text::shortest(to_s(at)) + "\n");
                       },
                   .topics = {kImageTopic}});
  if (images == 0)
    throw UserError(recording.path() +
                    ": has no images; run tp100-camera with an [image] section in its view file");
  times.commit();
}

void export_run(const std::string& run, const ExportOptions& options) {
  const Recording recording(run);
  if (!recording.whole())
    std::fprintf(stderr, "tp100d: %s: the recording is cut off; exported everything before that\n",
                 recording.path().c_str());
  const Window window = window_of(recording);
  if (!window.ran)
    std::fprintf(stderr, "tp100d: %s: the run never began; exported the whole recording\n",
                 recording.path().c_str());
  const std::filesystem::path folder = options.out.empty()
                                           ? std::filesystem::path(recording.path()).parent_path()
                                           : std::filesystem::path(options.out);
  if (!options.ros2.empty()) export_bag(recording, options.ros2);
  if (!options.images.empty()) export_images(recording, options.images);
  if (options.csv || options.tum) text::make_folder(folder);
  if (options.csv) export_csv(recording, window, folder);
  if (options.tum) export_tum(recording, window, folder);
}

}  // namespace

int run_export(const ExportOptions& options) {
  ExportOptions wanted = options;
  if (!wanted.csv && !wanted.tum && wanted.ros2.empty() && wanted.images.empty())
    wanted.csv = wanted.tum = true;
  if (wanted.runs.size() > 1 && !wanted.out.empty())
    throw UserError("--out is for one run; without it the files go beside each recording");
  if (wanted.runs.size() > 1 && !wanted.ros2.empty())
    throw UserError("--ros2 is for one run: a bag has one recording");
  if (wanted.runs.size() > 1 && !wanted.images.empty())
    throw UserError("--images is for one run: its folder has the images of one recording");
  for (const std::string& run : wanted.runs) export_run(run, wanted);
  return 0;
}

void add_export(CLI::App& app, Action& action) {
  static ExportOptions options;
  CLI::App* command =
      app.add_subcommand("export", "Turn recordings into CSV and TUM files, a ROS 2 bag or images");
  text::option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  command->add_flag("--csv", options.csv, "Only samples.csv and poses.csv");
  command->add_flag("--tum", options.tum, "Only the trajectories, for evo: time x y z qx qy qz qw");
  text::option(command, "--ros2", options.ros2, "FOLDER",
               "A bag for ros2 bag, Foxglove and PlotJuggler, instead of CSV and TUM files");
  text::option(command, "--images", options.images, "FOLDER",
               "The camera's images as JPEG files, instead of CSV and TUM files");
  text::option(command, "--out", options.out, "FOLDER",
               "Folder to write to (default: beside the recording)");
  command->footer("Example: tp100d export runs/RUN --csv --out figures");
  command->callback([&action] { action = [] { return run_export(options); }; });
}

}  // namespace tp100::app
