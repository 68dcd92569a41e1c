// tp100-camera: the command line.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "camera/lens_calibration.h"
#include "camera/view.h"
#include "camera/watch.h"
#include "core/error.h"
#include "link/camera_message.h"
#include "text/atomic_file.h"
#include "text/standard_streams.h"
#include "text/toml_document.h"

namespace tp100::camera {
namespace {

constexpr double kBoardPixelsPerM = 600.0 / 0.0254;

struct Options {
  WatchOptions watch;
  std::string size;
  bool images_only = false;
  std::string lens_out;
  std::string board;
  std::string print_marker, print_board;
  int marker_id = -1;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option(
         "SOURCE", options.watch.source,
         "Video file, folder of images, device (/dev/video0, or 0 for short), or pipe of netpbm "
         "images (- is standard input)")
      ->type_name("");
  app.add_option("--view", options.watch.view,
                 "View file: lens, marker, points on the floor (as config/view.toml)")
      ->type_name("FILE");
  app.add_option("--send", options.watch.send,
                 "Where poses go, udp:PORT or udp:HOST:PORT (default: udp:47100 without --tum)")
      ->type_name("ADDRESS");
  app.add_option("--tum", options.watch.tum, "Also write the poses to a TUM file")
      ->type_name("FILE");
  app.add_flag("--images-only", options.images_only,
               "Send images of any camera to the page and the recording, without looking for "
               "markers");
  app.add_option("--fps", options.watch.images.fps,
                 "Images per second: of a folder without times.csv, or requested from a device")
      ->check(CLI::Range(0.01, 10000.0))
      ->type_name("HZ");
  app.add_option("--size", options.size, "Image size requested from a device, as 1920x1080")
      ->type_name("WxH");
  app.add_option("--calibrate-lens", options.lens_out,
                 "Find the lens from images of --board and write it to this file")
      ->type_name("FILE");
  app.add_option("--board", options.board,
                 "charuco:7x5:0.04:0.03 (squares, square and marker in m)")
      ->type_name("BOARD");
  app.add_option("--print-marker", options.print_marker,
                 "Write the marker of --view, or the default one, as an SVG of true size")
      ->type_name("FILE");
  app.add_option("--id", options.marker_id, "Another marker to print, such as one of the floor")
      ->check(CLI::Range(0, 1023))
      ->type_name("NUMBER");
  app.add_option("--print-board", options.print_board, "Write --board as a PNG of 600 dpi")
      ->type_name("FILE");
}

int print_marker(const Options& options) {
  const View view = options.watch.view.empty() ? View{} : read_view(options.watch.view);
  const int id = options.marker_id < 0 ? view.marker_id : options.marker_id;
  text::write_file(options.print_marker, marker_svg(view, id));
  return 0;
}

int print_board(const Options& options) {
  const cv::Mat image = CalibrationBoard::parse(options.board).draw(kBoardPixelsPerM);
  std::vector<unsigned char> png;
  cv::imencode(".png", image, png);
  text::write_file(options.print_board, {reinterpret_cast<const char*>(png.data()), png.size()});
  return 0;
}

int run_monitor(Options& options) {
  WatchOptions& watch_options = options.watch;
  if (watch_options.view.empty() && !options.images_only)
    throw UserError(
        "no --view; copy config/view.toml, fill it in and pass it, or send --images-only");
  if (options.images_only && (!watch_options.view.empty() || !watch_options.tum.empty()))
    throw UserError("--images-only: no poses are found; leave out --view and --tum");
  if (watch_options.send.empty() && watch_options.tum.empty())
    watch_options.send = "udp:" + std::to_string(link::kCameraPort);
  SourceOptions& images = watch_options.images;
  int used = -1;
  if (!options.size.empty() &&
      (std::sscanf(options.size.c_str(), "%dx%d%n", &images.width_px, &images.height_px, &used) !=
           2 ||
       used != static_cast<int>(options.size.size()) || images.width_px < 16 ||
       images.height_px < 16 || images.width_px > 16384 || images.height_px > 16384))
    throw UserError("--size " + one_line(options.size) + ": not a size; use 1920x1080");
  return watch(watch_options);
}

int run(int argc, char** argv) {
  CLI::App app("Overhead camera: the pose of a marked robot from images", "tp100-camera");
  app.set_version_flag("--version", TP100_VERSION);
  Options options;
  add_options(app, options);
  app.footer("Example: tp100-camera /dev/video0 --view view.toml --send udp:47100");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return text::report_usage_error("tp100-camera", error.what());
  }
  if (!options.print_marker.empty()) return print_marker(options);
  if (!options.print_board.empty()) return print_board(options);
  if (options.watch.source.empty())
    return text::report_usage_error("tp100-camera", "SOURCE is required");
  if (options.lens_out.empty()) return run_monitor(options);
  return calibrate_lens(options.watch.source, options.watch.images, options.board,
                        options.lens_out);
}

}  // namespace
}  // namespace tp100::camera

int main(int argc, char** argv) {
  // Errors are reported in one line of our own; one thread leaves the other processors to the
  // bridge.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);
  return tp100::text::run_program("tp100-camera", [&] { return tp100::camera::run(argc, argv); });
}
