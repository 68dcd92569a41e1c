#include "camera/print.h"

#include <opencv2/aruco.hpp>

#include "camera/marker_detector.h"
#include "core/error.h"
#include "text/toml_document.h"

namespace tp100::camera {

std::string marker_svg(const View& view, int id) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionary_named(view.dictionary);
  if (id < 0 || id >= dictionary->bytesList.rows)
    throw SetupError("marker " + std::to_string(id) + ": dictionary " + view.dictionary +
                     " ends at " + std::to_string(dictionary->bytesList.rows - 1));
  const int modules = dictionary->markerSize + 2;
  cv::Mat bits;
  cv::aruco::drawMarker(dictionary, id, modules, bits);
  const double module_mm = view.marker_size_m * 1e3 / modules;
  // The detector needs white around the black square: one and a half modules.
  const double rim_mm = 1.5 * module_mm;
  const double side_mm = view.marker_size_m * 1e3 + 2.0 * rim_mm;
  const auto mm = [](double value) { return text::number_text(value); };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + mm(side_mm) +
                    "mm\" height=\"" + mm(side_mm) + "mm\" viewBox=\"0 0 " + mm(side_mm) + " " +
                    mm(side_mm) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (int row = 0; row < modules; ++row) {
    for (int column = 0; column < modules; ++column) {
      if (bits.at<unsigned char>(row, column) != 0) continue;
      svg += "<rect x=\"" + mm(rim_mm + column * module_mm) + "\" y=\"" +
             mm(rim_mm + row * module_mm) + "\" width=\"" + mm(module_mm) + "\" height=\"" +
             mm(module_mm) + "\" fill=\"black\"/>\n";
    }
  }
  svg += "<path d=\"M " + mm(side_mm / 2) + " " + mm(rim_mm * 0.1) + " l " + mm(rim_mm * 0.3) +
         " " + mm(rim_mm * 0.4) + " h " + mm(-rim_mm * 0.6) + " z\" fill=\"#bbb\"/>\n<text x=\"" +
         mm(rim_mm) + "\" y=\"" + mm(side_mm - rim_mm * 0.3) + "\" font-size=\"" +
         mm(rim_mm * 0.3) + "\" fill=\"#888\">" + view.dictionary + " " + std::to_string(id) +
         ", " + mm(view.marker_size_m * 1e3) + " mm</text>\n</svg>\n";
  return svg;
}

}  // namespace tp100::camera
