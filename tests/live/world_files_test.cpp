// The two text files of an external world.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include "../support/eventually.h"
#include "core/error.h"
#include "live/external_inputs.h"
#include "support/temporary_folder.h"

namespace tp100::live {
namespace {

using namespace std::chrono_literals;
using test::eventually;

class Files : public testing::Test {
 protected:
  Files() {
    run_.settings.encoder_file = folder_.file("Encoder.txt");
    run_.settings.orientation_file = folder_.file("Orientation.txt");
    run_.settings.rate_hz = 1000.0;
  }
  void open() {
    files_ = open_world_files(
        run_,
        [this](const WorldSample& sample) {
          const std::lock_guard lock(mutex_);
          sample_ = sample;
          return true;
        },
        events_);
  }
  void step() {
    record_->now_ns += 5 * kNsPerMs;
    ++record_->step;
    files_->take(*record_);
  }
  void world_writes(const std::string& text) {
    test::write_bytes(run_.settings.orientation_file, text);
  }
  double pitch() {
    const std::lock_guard lock(mutex_);
    return sample_.pitch_rad;
  }

  test::TemporaryFolder folder_;
  messages::EventQueue events_;
  config::WorldRun run_;
  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
  std::mutex mutex_;
  WorldSample sample_{};
  std::unique_ptr<WorldLink> files_;
};

TEST_F(Files, TheNewestStepIsWrittenAsAWhole) {
  run_.settings.encoder_template = "{seq} " + std::string(400, '.') + " {seq}";
  open();
  std::atomic<bool> over{false};
  std::atomic<int> torn{0};
  // A reader that polls the file must never see an incomplete text.
  std::thread reader([&] {
    while (!over) {
      const std::string text = test::read_bytes(run_.settings.encoder_file);
      const bool first = text == "\n";
      const std::string number = text.substr(0, text.find(' '));
      if (!first && text != number + " " + std::string(400, '.') + " " + number + "\n") ++torn;
    }
  });
  for (int i = 0; i < 200; ++i) {
    step();
    std::this_thread::sleep_for(1ms);
  }
  const std::string last = std::to_string(record_->step);
  EXPECT_TRUE(eventually(
      [&] { return test::read_bytes(run_.settings.encoder_file).starts_with(last + " "); }));
  over = true;
  reader.join();
  EXPECT_EQ(torn, 0);
  files_.reset();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1)
      << "temporary files were left behind";
}

TEST_F(Files, AChangedFileIsReadAndABadOneIsCountedAndChangesNothing) {
  open();
  world_writes("-0.25\n");
  EXPECT_TRUE(eventually([&] { return pitch() == -0.25; }));
  world_writes("rubbish\n");
  EXPECT_TRUE(eventually([&] { return files_->figures().files.value().rejected >= 1; }));
  EXPECT_EQ(pitch(), -0.25);
  EXPECT_FALSE(events_.drain().empty());
  // Without a line's end it may be half written, and is read twice.
  world_writes("-0.75");
  EXPECT_TRUE(eventually([&] { return pitch() == -0.75; }));
  world_writes("P=-0.5 Y=0 R=0\n");
  EXPECT_TRUE(eventually([&] { return pitch() == -0.5; }));
  const std::uint64_t read = files_->figures().files.value().read;
  // After each text that it writes, the daemon checks the other file.
  for (int i = 0; i < 3; ++i) {
    const std::uint64_t written = files_->figures().files.value().written;
    step();
    ASSERT_TRUE(eventually([&] { return files_->figures().files.value().written > written; }));
  }
  EXPECT_EQ(files_->figures().files.value().read, read) << "an unchanged file was read again";
}

TEST_F(Files, BadSettingsAreErrorsAtTheStart) {
  run_.settings.encoder_template = "{speed}";
  EXPECT_THROW(open(), UserError);
  run_.settings.encoder_template = "{left}";
  run_.settings.encoder_file = folder_.file("none/Encoder.txt");
  EXPECT_THROW(open(), UserError);
}

TEST_F(Files, APipeInPlaceOfTheFileStopsNothing) {
  ASSERT_EQ(::mkfifo(run_.settings.orientation_file.c_str(), 0600), 0);
  open();
  step();
  const std::string last = std::to_string(record_->step);
  EXPECT_TRUE(eventually(
      [&] { return test::read_bytes(run_.settings.encoder_file).starts_with(last + " "); }));
}

}  // namespace
}  // namespace tp100::live
