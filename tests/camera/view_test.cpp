#include "camera/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "../support/temporary_folder.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace tp100::camera {
namespace {

using ::testing::HasSubstr;

View example() {
  View view;
  view.lens = "lens.toml";
  view.floor_markers = {{10, {-0.2, -0.5}}, {11, {2.1, -0.5}}, {12, {2.1, 0.9}}, {13, {-0.2, 0.9}}};
  return view;
}

std::string problem(const std::string& text) {
  return test::refusal([&] { parse_view(text, "view.toml"); });
}

// `scripts/test --accept` rewrites the example from the key table.
TEST(ViewFile, TheExampleIsWhatTheKeyTableSays) {
  const std::string path = source_path("config/view.toml");
  if (std::getenv("TP100_ACCEPT") != nullptr) {
    test::write_bytes(path, write_view(example()));
    return;
  }
  EXPECT_EQ(test::read_bytes(path), write_view(example()));
}

TEST(ViewFile, ReadsBackWhatItWrites) {
  View view = example();
  view.dictionary = "apriltag_36h11";
  view.marker_turned_rad = 1.5;
  view.delay_s = 0.03;
  view.images = {.rate_hz = 2.5, .width_px = 320};
  EXPECT_EQ(write_view(parse_view(write_view(view), "f")), write_view(view));
  view.floor_markers.clear();
  view.floor_points = {{{1, 2}, {0, 0}}, {{3, 2}, {1, 0}}, {{3, 9}, {1, 1}}, {{1, 9}, {0, 1}}};
  EXPECT_EQ(write_view(parse_view(write_view(view), "f")), write_view(view));
}

TEST(ViewFile, WhatIsWrongIsNamedWithItsPlace) {
  const std::string good = write_view(example());
  EXPECT_THAT(problem(""), HasSubstr("no lens file"));
  EXPECT_THAT(problem("lens = \"l\"\n"), HasSubstr("fewer than four points"));
  EXPECT_THAT(problem(good + "[[floor_marker]]\nid = 10\nx_m = 0\ny_m = 0\n"), HasSubstr("twice"));
  EXPECT_THAT(problem(good + "[[floor_marker]]\nid = 0\nx_m = 0\ny_m = 0\n"), HasSubstr("own"));
  EXPECT_THAT(problem(good + "[[floor_marker]]\nid = 14\nx_m = 0\n"), HasSubstr("y_m"));
  EXPECT_THAT(problem(good + "[[floor_marker]]\nid = 14\nx_m = 1e9\ny_m = 0\n"),
              HasSubstr("allowed"));
  EXPECT_THAT(problem(good + "[[floor_point]]\nu_px = 1\nv_px = 1\nx_m = 0\ny_m = 0\n"),
              HasSubstr("not both"));
  EXPECT_THAT(problem("lens = \"l\"\n[marker]\ndictionary = \"9x9\"\n"), HasSubstr("4x4_50"));
  EXPECT_THAT(problem("lens = \"l\"\n[marker]\nsize_m = nan\n"), HasSubstr("size_m"));
}

}  // namespace
}  // namespace tp100::camera
