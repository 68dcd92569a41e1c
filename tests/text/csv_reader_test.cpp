#include "text/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tp100::text {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

const CsvColumns kColumns = {{"t_s", "v"}, {"g"}};

CsvTable read(std::string_view text) { return parse_csv(text, "f.csv", kColumns); }

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
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
      "\xef\xbb\xbft_s,v\r\n0,1\r\n1,2\r\n",
      "t_s,v\n0,1\n1,2",  // no final line break
      "t_s,v\n0,1\n1,2\n\n \r\n\n",
      "\"t_s\",\"v\"\n\"0\",1\n1,\"2\"\n",
      "t_s , v\n 0,\t1\n1 ,+2\n",
      "t_s,v,note\n0,1,\"a, \"\"b\"\"\"\n1,2,\n",
  };
  for (const char* text : kFiles) {
    const CsvTable table = read(text);
    EXPECT_THAT(table["t_s"], ElementsAre(0.0, 1.0)) << text;
    EXPECT_THAT(table["v"], ElementsAre(1.0, 2.0)) << text;
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
  EXPECT_THROW(parse_csv("t_s,v\n,1\n", "f.csv", {{"t_s", "v"}, {}, {"v"}}), SetupError);
}

TEST(CsvReader, CountsTheLinesOfQuotedLineBreaks) {
  EXPECT_EQ(error_of("t_s,v,note\n0,1,\"a\nb\nc\"\n1,x,\n"),
            "f.csv:5: v is 'x', expected a number");
}

TEST(CsvReader, RefusesABadRowAtItsLine) {
  EXPECT_EQ(error_of("t_s,v\n0,1\n1,fast\n"), "f.csv:3: v is 'fast', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,\n"), "f.csv:2: v is '', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,1 2\n"), "f.csv:2: v is '1 2', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,0x10\n"), "f.csv:2: v is '0x10', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,+-1\n"), "f.csv:2: v is '+-1', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,nan\n"), "f.csv:2: v is 'nan', expected a finite number");
  EXPECT_EQ(error_of("t_s,v\n0,-inf\n"), "f.csv:2: v is '-inf', expected a finite number");
  EXPECT_EQ(error_of("t_s,v\n0,1e999\n"), "f.csv:2: v is '1e999', expected a finite number");
  EXPECT_EQ(error_of("t_s,v\n0,1\n1\n"), "f.csv:3: 1 values, but the header has 2 columns");
  EXPECT_EQ(error_of("t_s,v\n0,1,2\n"), "f.csv:2: 3 values, but the header has 2 columns");
  EXPECT_EQ(error_of("t_s,v\n0,1\n\n1,2\n"), "f.csv:3: 1 values, but the header has 2 columns");
}

TEST(CsvReader, ANumberTooSmallForADoubleIsZero) {
  EXPECT_EQ(read("t_s,v\n0,1e-999\n")["v"][0], 0.0);
}

TEST(CsvReader, RefusesTimeThatDoesNotIncrease) {
  EXPECT_EQ(error_of("t_s,v\n0,1\n0.5,1\n0.5,1\n"),
            "f.csv:4: t_s is 0.5, not after the row before (0.5)");
  EXPECT_THAT(error_of("t_s,v\n1,1\n0.5,1\n"), StartsWith("f.csv:3: t_s is 0.5, not after"));
}

TEST(CsvReader, RefusesUnfinishedFiles) {
  EXPECT_EQ(error_of("t_s,v\n0,1\n1,"), "f.csv:3: the last row is unfinished");
  EXPECT_EQ(error_of("t_s,v\n0,1\n1"), "f.csv:3: 1 values, but the header has 2 columns");
  EXPECT_EQ(error_of("t_s,v\n0,1\n1,2e"), "f.csv:3: v is '2e', expected a number");
  EXPECT_EQ(error_of("t_s,v\n0,1\n1,\"2"), "f.csv:3: a quote is never closed");
  EXPECT_EQ(error_of("t_s,v\n"), "f.csv:2: no rows after the header");
  EXPECT_EQ(error_of("t_s,v"), "f.csv:2: no rows after the header");
  EXPECT_EQ(error_of(""), "f.csv:1: the file is empty; expected a header with t_s,v");
}

TEST(CsvReader, RefusesAWrongHeader) {
  EXPECT_EQ(error_of("t_s,speed\n0,1\n"),
            "f.csv:1: column 'v' is missing; expected a header with t_s,v");
  EXPECT_EQ(error_of("t_s,v,v\n0,1,1\n"), "f.csv:1: column 'v' appears twice");
  EXPECT_THAT(error_of("0,1\n1,1\n"), StartsWith("f.csv:1: column 't_s' is missing"));
}

TEST(CsvReader, AnyCorruptionGivesOneLineOrATable) {
  const std::string good = "\xef\xbb\xbft_s,v,\"n\"\r\n0,1,\"x\"\r\n1,2e-3,y\r\n";
  std::mt19937 random(3);
  for (int round = 0; round < 5000; ++round) {
    std::string text = good;
    for (int i = 0; i < 3; ++i) text[random() % text.size()] = static_cast<char>(random() % 256);
    text.resize(random() % (text.size() + 1));
    const std::string line = error_of(text);
    if (line.empty()) continue;
    EXPECT_THAT(line, StartsWith("f.csv:"));
    for (const char c : line) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << line;
  }
}

}  // namespace
}  // namespace tp100::text
