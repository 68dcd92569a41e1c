// Tables of measurements as people and spreadsheets write them, and what is refused at its line.

#include "text/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "support/refusal.h"

namespace tp100::text {
namespace {

using testing::ElementsAre;

const CsvColumns kColumns = {{"t_s", "v"}, {"g"}};

CsvTable read(std::string_view text) { return parse_csv(text, "f.csv", kColumns); }

std::string error_of(std::string_view text) {
  return test::refusal([&] { read(text); });
}

TEST(CsvReader, ReadsColumnsByNameInAnyOrder) {
  const CsvTable table = read("v,t_s\n1.5,0\n-2e-3,0.005\n");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table["t_s"], ElementsAre(0.0, 0.005));
  EXPECT_THAT(table["v"], ElementsAre(1.5, -2e-3));
  EXPECT_FALSE(table.has("g"));
  EXPECT_EQ(table.where(1), "f.csv:3");
}

TEST(CsvReader, AcceptsWhatSpreadsheetsWrite) {
  const char* const kFiles[] = {
      "t_s,v\n0,1\n1,2",  // no final line break
      "t_s,v\n0,1\n1,2\n\n \r\n\n",
      "\"t_s\",\"v\"\n\"0\",1\n1,\"2\"\n",
      "t_s , v\n 0,\t1\n1 ,+2\n",
      "t_s,v,note\n0,1,\"a, \"\"b\"\"\"\n1,2,\n",
      "t_s,v\n0,1\n\n1,2\n,,\n,\n",        // rows without a value
      "t_s;v\n0,0;1,0\n1,0;2,0\n",         // decimal commas
      "sep=;\r\nt_s;v\r\n0;1\r\n1;2\r\n",  // of Excel
      "t_s\tv\n0\t1\n1\t2\n",
      "t_s v\n 0   1\n1\t2 \r\n",
      "T_S,V\r0,1\r1,2",  // of an old Macintosh
      "# drive, of May\nt_s,v\n0,1\n# pause,,\n1,2\n",
      "# t_s v\n0 1\n1 2\n",
      "%time (ms),v\n0,1\n1000,2\n",
      "Timestamp [ns];\xc2\xa0V \n0;1\n1000000000;\xc2\xa0"
      "2\n",
  };
  for (const char* text : kFiles) {
    const CsvTable table = read(text);
    EXPECT_THAT(table["t_s"], ElementsAre(0.0, 1.0)) << text;
    EXPECT_THAT(table["v"], ElementsAre(1.0, 2.0)) << text;
  }
}

TEST(CsvReader, ConvertsTheUnitsThatAHeaderNames) {
  const CsvColumns columns = {
      .required = {"run"}, .optional = {"ahead_m", "turned_deg", "gyro_z_radps"}, .by_time = false};
  const auto value = [&](const std::string& header, const char* column) {
    return parse_csv("Run;" + header + "\n1;90\n", "f.csv", columns)[column][0];
  };
  EXPECT_DOUBLE_EQ(value("Ahead (cm)", "ahead_m"), 0.9);
  EXPECT_DOUBLE_EQ(value("ahead [Inches]", "ahead_m") / 0.0254, 90.0 / 1.0);
  EXPECT_DOUBLE_EQ(value("AHEAD_MM", "ahead_m"), 0.09);
  EXPECT_DOUBLE_EQ(value("turned (degrees)", "turned_deg"), 90.0);
  EXPECT_DOUBLE_EQ(value("turned (°)", "turned_deg"), 90.0);
  EXPECT_DOUBLE_EQ(value("turned_rad", "turned_deg"), 90.0 * kDegPerRad);
  EXPECT_DOUBLE_EQ(value("Gyro Z (deg/s)", "gyro_z_radps"), 90.0 * kRadPerDeg);
}

TEST(CsvReader, RefusesAColumnThatItWouldIgnore) {
  const CsvColumns columns = {
      .required = {"run"}, .optional = {"slope_deg"}, .by_time = false, .others = false};
  for (const auto& [header, error] : {
           std::pair{"run,slope",
                     "column 'slope' has no unit; name it 'slope_deg' or 'slope (deg)'"},
           {"run,slop_deg", "column 'slop_deg' is unknown; did you mean 'slope_deg'?"},
           {"run,weather", "column 'weather' is unknown; columns may be run,slope_deg"},
       })
    EXPECT_EQ(test::refusal([&] { parse_csv(std::string(header) + "\n1,2\n", "f.csv", columns); }),
              "f.csv:1: " + std::string(error));
}

TEST(CsvReader, ReadsTablesWithoutNames) {
  const CsvColumns columns = {
      .required = {"file", "t_s"}, .by_time = false, .header = false, .texts = {"file"}};
  for (const char* text : {"a b.png,0\nc.png,1\n", "file,seconds\na b.png,0\nc.png,1",
                           "# a list, sorted\n\"a b.png\" 0\nc.png 1\n"}) {
    const CsvTable table = parse_csv(text, "f.csv", columns);
    EXPECT_THAT(table.texts("file"), ElementsAre("a b.png", "c.png")) << text;
    EXPECT_THAT(table["t_s"], ElementsAre(0.0, 1.0)) << text;
  }
}

TEST(CsvReader, WithoutTimeRowsComeInAnyOrder) {
  const CsvColumns columns = {
      .required = {"left", "right"}, .optional = {}, .gaps = {}, .by_time = false};
  EXPECT_THAT(parse_csv("left,right\n2,0\n1,0\n1,5\n", "f.csv", columns)["left"],
              ElementsAre(2.0, 1.0, 1.0));
}

TEST(CsvReader, AnEmptyCellIsAGapWhereGapsAreAllowed) {
  const CsvTable table =
      parse_csv("t_s,v,g\n0, ,1\n1,2,\n", "f.csv", {{"t_s", "v"}, {"g"}, {"v", "g"}});
  EXPECT_TRUE(std::isnan(table["v"][0]));
  EXPECT_EQ(table["v"][1], 2.0);
  EXPECT_TRUE(std::isnan(table["g"][1]));
  EXPECT_THROW(parse_csv("t_s,v\n,1\n", "f.csv", {{"t_s", "v"}, {}, {"v"}}), UserError);
}

TEST(CsvReader, RefusesABadFileAtItsLine) {
  for (const auto& [text, error] : {
           std::pair{"t_s,v\n0,1\n1,fast\n", "3: v is 'fast', expected a number"},
           {"t_s,v\n0,\n", "2: v is '', expected a number"},
           {"t_s,v\n0,0x10\n", "2: v is '0x10', expected a number"},
           {"t_s,v\n0,+-1\n", "2: v is '+-1', expected a number"},
           {"t_s,v\n0,nan\n", "2: v is 'nan', expected a finite number"},
           {"t_s,v\n0,-inf\n", "2: v is '-inf', expected a finite number"},
           {"t_s,v\n0,1e999\n", "2: v is '1e999', expected a finite number"},
           {"t_s,v\n0,1\n1\n", "3: 1 values in 2 columns"},
           {"t_s,v\n0,1,2\n",
            "2: 3 values in 2 columns; with decimal commas, separate the columns by ;"},
           // The lines within quotes count.
           {"t_s,v,note\n0,1,\"a\nb\nc\"\n1,x,\n", "5: v is 'x', expected a number"},
           // Time that does not increase.
           {"t_s,v\n0,1\n0.5,1\n0.5,1\n", "4: t_s is 0.5, not after the row before (0.5)"},
           // Files that are cut off.
           {"t_s,v\n0,1\n1,", "3: v is '', expected a number"},
           {"t_s,v\n0,1\n1,\"2", "3: a quote is never closed"},
           {"t_s,v\n", "2: no rows after the header"},
           {"", "1: the file is empty; expected a header with t_s,v"},
           {"t_s;v\n0,5;1.5\n",
            "2: v is '1.5', but line 2 has a decimal comma; use one of them, and nothing between "
            "thousands"},
           {"t_s;v\n0;1.234,5\n",
            "2: v is '1.234,5', but line 2 has a decimal point; use one of them, and nothing "
            "between thousands"},
           {"t_s,v\n#N/A,1\n", "2: t_s is '#N/A', expected a number"},
           // Other columns.
           {"t,v\n0,1\n", "1: column 't' has no unit; name it 't_s' or 't (s)'"},
           {"t (kg),v\n0,1\n", "1: column 't (kg)' has a unit that does not fit; give it in s"},
           {"t_s,v,t_ms\n0,1,0\n", "1: column 't_s' appears twice"},
           {"t_s,speed\n0,1\n", "1: column 'v' is missing; expected a header with t_s,v"},
           {"t_s,v,v\n0,1,1\n", "1: column 'v' appears twice"},
       })
    EXPECT_EQ(error_of(text), "f.csv:" + std::string(error)) << text;
  EXPECT_EQ(read("t_s,v\n0,1e-999\n")["v"][0], 0.0) << "too small for a double";
}

}  // namespace
}  // namespace tp100::text
