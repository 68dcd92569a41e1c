// Tables of measurements as people and spreadsheets write them, and what is refused at its line.

#include "text/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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
           {"t_s,v\n0,1\n1\n", "3: 1 values, but the header has 2 columns"},
           {"t_s,v\n0,1,2\n", "2: 3 values, but the header has 2 columns"},
           {"t_s,v\n0,1\n\n1,2\n", "3: 1 values, but the header has 2 columns"},
           // The lines within quotes count.
           {"t_s,v,note\n0,1,\"a\nb\nc\"\n1,x,\n", "5: v is 'x', expected a number"},
           // Time that does not increase.
           {"t_s,v\n0,1\n0.5,1\n0.5,1\n", "4: t_s is 0.5, not after the row before (0.5)"},
           // Files that are cut off.
           {"t_s,v\n0,1\n1,", "3: the last row is unfinished"},
           {"t_s,v\n0,1\n1,\"2", "3: a quote is never closed"},
           {"t_s,v\n", "2: no rows after the header"},
           {"", "1: the file is empty; expected a header with t_s,v"},
           // Other columns.
           {"t_s,speed\n0,1\n", "1: column 'v' is missing; expected a header with t_s,v"},
           {"t_s,v,v\n0,1,1\n", "1: column 'v' appears twice"},
       })
    EXPECT_EQ(error_of(text), "f.csv:" + std::string(error)) << text;
  EXPECT_EQ(read("t_s,v\n0,1e-999\n")["v"][0], 0.0) << "too small for a double";
}

}  // namespace
}  // namespace tp100::text
