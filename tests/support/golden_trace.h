#pragma once
// A golden trace: the values of a scripted run, step by step, compared with the committed ones. It
// shows every change of a computation that other tests only bound. After an intended change, the
// command in its message writes it anew; the difference of the file then is part of the review.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/paths.h"

namespace tp100::test {

class GoldenTrace {
 public:
  /// `file`: a CSV file with one line of names, relative to tests/golden/.
  GoldenTrace(const std::string& file, std::vector<std::string> columns)
      : path_(source_path("tests/golden/" + file)), columns_(std::move(columns)) {}

  /// One value per column.
  void row(std::vector<double> values) { rows_.push_back(std::move(values)); }

  /// Empty if each value is within `tolerance` times the greatest size in its golden column; else
  /// says where not.
  std::string difference(double tolerance = 1e-6) const {
    if (std::getenv("TP100_WRITE_GOLDEN_TRACES") != nullptr) return write();
    std::ifstream file(path_);
    std::string line;
    if (!std::getline(file, line) || line != header()) return "other columns than " + path_ + how();
    std::vector<std::vector<double>> golden;
    while (std::getline(file, line)) golden.push_back(numbers(line));
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      double size = 0.0;
      for (const auto& values : golden) {
        if (std::isfinite(values.at(column))) size = std::max(size, std::abs(values[column]));
      }
      for (std::size_t i = 0; i < std::min(golden.size(), rows_.size()); ++i) {
        const double expected = golden[i][column], value = rows_[i].at(column);
        const bool same = std::isfinite(expected) ? std::abs(value - expected) <= tolerance * size
                                                  : text(value) == text(expected);
        if (!same) {
          return columns_[column] + " is " + text(value) + " instead of " + text(expected) +
                 " in row " + std::to_string(i + 1) + " of " + path_ + how();
        }
      }
    }
    if (golden.size() == rows_.size()) return "";
    return std::to_string(rows_.size()) + " rows instead of the " + std::to_string(golden.size()) +
           " of " + path_ + how();
  }

 private:
  static std::string how() {
    return "; if intended, run the test once with TP100_WRITE_GOLDEN_TRACES=1";
  }

  static std::string text(double value) {
    if (std::isnan(value)) return "nan";
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return digits;
  }

  static std::vector<double> numbers(const std::string& line) {
    std::vector<double> values;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
      values.push_back(std::strtod(cell.c_str(), nullptr));
    return values;
  }

  std::string header() const {
    std::string line = columns_.front();
    for (std::size_t i = 1; i < columns_.size(); ++i) line += "," + columns_[i];
    return line;
  }

  std::string write() const {
    std::ofstream file(path_);
    file << header() << '\n';
    for (const auto& values : rows_) {
      for (std::size_t i = 0; i < columns_.size(); ++i)
        file << (i == 0 ? "" : ",") << text(values.at(i));
      file << '\n';
    }
    return path_ + (file.flush() ? " is written: review it" : " cannot be written");
  }

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace tp100::test
